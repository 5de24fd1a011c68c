# SPDX-License-Identifier: GPL-2.0-or-later
"""A study that is killed again and again ends as one that was left alone."""

import contextlib
import os
import random
import signal
import subprocess
import time
import unittest

from support import CASES, SMALL, StudyTest, ensemble_text

KILLS = 20
PATTERNS = ("runs/*/*/restart/*", "runs/*/*/result.json", "runs/*/*/analysis/summary.json", "ensemble/*.json")


class Interrupted(StudyTest):
    def setUp(self):
        super().setUp()
        self.made = set()

    def start(self):
        return subprocess.Popen(
            self.command("--no-report"), env=self.environment(), stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL, start_new_session=True,
        )

    def progress(self):
        """How far the study is: restart files, results, summaries, the ensemble that it has made so far."""
        self.made |= {file for pattern in PATTERNS for file in self.out.glob(pattern)}
        return len(self.made)

    def leave_alone(self):
        """Makes the study without a kill. Returns seconds to its first file, to its end, and its files."""
        begin, first = time.time(), None
        study = self.start()
        while study.poll() is None:
            time.sleep(0.005)
            if self.progress() and first is None:
                first = time.time()
        self.assertEqual(study.returncode, 0)
        return first - begin, time.time() - begin, self.progress()

    def kill_at(self, files, seconds):
        """Starts the study and kills all of it when it has made so many files, and a while later."""
        study, end = self.start(), time.time() + 60
        while self.progress() < files and study.poll() is None and time.time() < end:
            time.sleep(0.005)
        time.sleep(seconds)
        # Snakemake, its steps, LIGGGHTS, the watch on progress.
        with contextlib.suppress(ProcessLookupError):  # it has ended in the while
            os.killpg(study.pid, signal.SIGKILL)
        return study.wait() == -signal.SIGKILL

    def state(self):
        """What a kill has met: runs begun, runs at their end, whether there is an ensemble."""
        runs = list((self.out / "runs").glob("*/seed-[0-9]*"))
        done = [run for run in runs if (run / "result.json").exists()]
        return (len(runs), len(done), (self.out / "ensemble" / "ensemble.json").exists())

    def test_twenty_kills_at_random_moments_change_nothing(self):
        # Of the spheres of seed 1 one rolls on for ever.
        table = "seeds: [2, 3]\n" + SMALL.replace("restart_interval: 0.1", "restart_interval: 0.05")
        self.write_table(table.replace("particles: 30", "particles: 60") + CASES)
        self.know_speed()
        first, last, files = self.leave_alone()
        expected, whole = ensemble_text(self.out), self.out
        self.out, self.made = self.folder / "killed", set()
        self.know_speed()
        # Moments are shares of the study's progress, not seconds, so that they meet all of it on any machine.
        moments, met, killed = random.Random(2016), [], 0
        shares = sorted(moments.uniform(0, 1) for kill in range(KILLS))
        for kill, share in enumerate(shares):
            # Every fifth meets run.sh or Snakemake before they have begun.
            early = kill % 5 == 0
            wait = moments.uniform(0, first) if early else moments.uniform(0, (last - first) / files)
            killed += self.kill_at(0 if early else max(self.progress() + 1, round(share * files)), wait)
            met.append(self.state())
        self.run_study("--no-report")
        self.assertEqual(ensemble_text(self.out), expected)
        # They have met the study in several states, most with runs in the middle, which went on.
        self.assertGreaterEqual(killed, 12, met)
        self.assertGreaterEqual(len(set(met)), 4, met)
        self.assertTrue([state for state in met if state[0] > state[1] > 0], met)
        logs = [log.read_text() for log in (self.out / "logs").glob("*-seed-*.log")]
        self.assertGreaterEqual(sum(log.count("going on from") for log in logs), 5)
        names = [sorted(file.relative_to(out / "runs") for file in self.results(out)) for out in (self.out, whole)]
        self.assertEqual(*names)
        for name in names[0]:
            self.assertEqual((self.out / "runs" / name).read_bytes(), (whole / "runs" / name).read_bytes())

    def results(self, out):
        return list((out / "runs").glob("*/seed-[0-9]*/result.json"))


if __name__ == "__main__":
    unittest.main()
