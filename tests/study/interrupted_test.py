# SPDX-License-Identifier: GPL-2.0-or-later
"""A study that is killed again and again ends as one that was left alone."""

import os
import random
import signal
import subprocess
import time
import unittest

from support import CASES, SMALL, StudyTest, ensemble

KILLS = 20
# From before Snakemake has read its file to after the last run, by time since the start.
LONGEST_S = 6.0


class Interrupted(StudyTest):
    def start(self):
        return subprocess.Popen(
            self.command("--no-report"), env=self.environment(), stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL, start_new_session=True,
        )

    def progress(self):
        """What a kill has met, for the record."""
        runs = list((self.out / "runs").glob("*/seed-*"))
        done = [run for run in runs if (run / "result.json").exists()]
        ended = (self.out / "ensemble" / "ensemble.json").exists()
        return (len(runs), len(done), ended)

    def test_twenty_kills_at_random_moments_change_nothing(self):
        # Restart files often enough that a second of work brings a run to the next.
        table = "repetitions: 2\n" + SMALL.replace("restart_interval: 0.1", "restart_interval: 0.05")
        self.write_table(table.replace("particles: 30", "particles: 60") + CASES)
        self.know_speed()
        self.run_study("--no-report")
        expected, whole = ensemble(self.out), self.out
        self.out = self.folder / "killed"
        self.know_speed()
        moments, met, runs = random.Random(2016), set(), 0
        for kill in range(KILLS):
            study = self.start()
            time.sleep(moments.uniform(0.2, LONGEST_S))
            # All of it: Snakemake, its steps, LIGGGHTS, the watch on progress.
            os.killpg(study.pid, signal.SIGKILL)
            study.wait()
            met.add(self.progress())
        self.run_study("--no-report")
        self.assertEqual(ensemble(self.out), expected)
        # They have met the study in several states, one at least with a run in the middle.
        self.assertGreaterEqual(len(met), 3, met)
        self.assertTrue([state for state in met if state[0] > state[1]], met)
        for log in (self.out / "logs").glob("*-seed-*.log"):
            runs += log.read_text().count("going on from")
        self.assertGreaterEqual(runs, 1)
        self.assertEqual(
            sorted(str(file.relative_to(self.out / "runs")) for file in self.results(self.out)),
            sorted(str(file.relative_to(whole / "runs")) for file in self.results(whole)),
        )
        for file in self.results(self.out):
            same = whole / "runs" / file.relative_to(self.out / "runs")
            self.assertEqual(file.read_bytes(), same.read_bytes())

    def results(self, out):
        return list((out / "runs").glob("*/seed-[0-9]*/result.json"))


if __name__ == "__main__":
    unittest.main()
