# SPDX-License-Identifier: GPL-2.0-or-later
"""A study by Slurm: a node drained, a job killed in the middle, and the numbers of a local one."""

import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from local_slurm import CannotStart, LocalSlurm
from support import CASES, SMALL, WORKFLOW, StudyTest, ensemble_text

SLURM = LocalSlurm(Path(tempfile.mkdtemp(prefix="rodpack-slurm-")))


class Cluster(StudyTest):
    def environment(self):
        # Snakemake asks for the states of jobs every ten seconds, with this every second.
        return {**super().environment(), "CI": "true"}

    def test_a_drained_node_and_a_killed_job_change_no_number(self):
        # Beds that take seconds, with a restart file each fraction of one.
        table = SMALL.replace("particles: 30", "particles: 150").replace("0.1\n", "0.05\n")
        self.write_table("repetitions: 2\n" + table + CASES)
        self.know_speed()
        self.run_study("--no-report")
        expected = ensemble_text(self.out)

        self.out = self.folder / "cluster"
        self.know_speed()
        before = set(SLURM.jobs())
        SLURM.node("drain")
        words = ("--no-report", "--profile", str(WORKFLOW / "slurm"), "--per-job", "2", "--latency-wait", "5")
        with open(self.folder / "printed.txt", "w") as printed:
            study = subprocess.Popen(
                self.command(*words), env=self.environment(), stdout=printed, stderr=subprocess.STDOUT
            )
        # One job for both repetitions of a case; none starts on a node that is drained.
        self.wait_for(study, lambda: len(set(SLURM.jobs()) - before) == 2)
        time.sleep(2)
        self.assertEqual([SLURM.jobs()[job] for job in set(SLURM.jobs()) - before], 2 * ["PENDING"])
        SLURM.node("resume")
        self.wait_for(study, lambda: self.in_the_middle("rods"))
        (killed,) = [job for job in set(SLURM.jobs()) - before if "rods" in self.script_of(job)]
        subprocess.run(["scancel", str(killed)], check=True)
        # The node gives out while the others are at work, and comes back.
        SLURM.node("drain")
        time.sleep(2)
        SLURM.node("resume")
        study.wait()
        printed = (self.folder / "printed.txt").read_text()
        self.assertEqual(study.returncode, 0, printed + self.log("snakemake.log"))
        self.assertEqual(SLURM.jobs()[killed], "CANCELLED")
        self.assertIn("going on from", "".join(
            (self.out / "logs" / f"rods-seed-{seed}.log").read_text() for seed in (1, 2)
        ))
        self.assertEqual(ensemble_text(self.out), expected)
        # Two jobs, one made again, and the ensemble's: none a run.
        self.assertEqual(len(set(SLURM.jobs()) - before), 4)

    def test_jobs_outlive_a_run_sh_that_is_killed_and_are_not_made_twice(self):
        self.write_table(SMALL.replace("particles: 30", "particles: 150") + CASES)
        self.know_speed()
        words = ("--runs-only", "--profile", str(WORKFLOW / "slurm"), "--latency-wait", "5")
        study = subprocess.Popen(
            self.command(*words), env=self.environment(), stdout=subprocess.DEVNULL, start_new_session=True
        )
        self.wait_for(study, lambda: self.in_the_middle("rods"))
        os.killpg(study.pid, signal.SIGKILL)
        study.wait()
        self.assertIn("RUNNING", SLURM.jobs().values())
        self.run_study(*words)
        self.assertEqual(self.started(), {"spheres-seed-1": 1, "rods-seed-1": 1})
        for case in ("spheres", "rods"):
            printed = (self.out / "logs" / f"{case}-seed-1.log").read_text()
            self.assertEqual(printed.count(f"written: {self.run_folder(case, 1)}/analysis"), 1)

    def in_the_middle(self, case):
        runs = [self.run_folder(case, seed) for seed in (1, 2)]
        return any(
            len(list((run / "restart").glob("*"))) >= 3 and not (run / "result.json").exists()
            for run in runs
        )

    def script_of(self, job):
        return SLURM.ask("scontrol", "write", "batch_script", str(job), "-")

    def wait_for(self, study, holds, seconds=120):
        end = time.time() + seconds
        while not holds():
            self.assertIsNone(study.poll(), self.log("snakemake.log"))
            self.assertLess(time.time(), end, self.log("snakemake.log"))
            time.sleep(0.05)


def main():
    try:
        SLURM.start()
    except CannotStart as reason:
        print(f"skipped: {reason}")
        SLURM.stop()
        return 77
    try:
        succeeded = unittest.main(exit=False).result.wasSuccessful()
    finally:
        SLURM.stop()
    if succeeded:
        shutil.rmtree(SLURM.folder)
    return 0 if succeeded else 1


if __name__ == "__main__":
    sys.exit(main())
