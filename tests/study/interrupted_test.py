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
# Files that the study makes between two kills, at most: 20 times half of that are most of what it makes.
MOST_FILES = 7


class Interrupted(StudyTest):
    def start(self):
        return subprocess.Popen(
            self.command("--no-report"), env=self.environment(), stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL, start_new_session=True,
        )

    def made(self):
        """Files that tell how far the study is: restart files, results, summaries, the ensemble."""
        patterns = ("runs/*/*/restart/*", "runs/*/*/result.json", "runs/*/*/analysis/summary.json", "ensemble/*.json")
        return {file for pattern in patterns for file in self.out.glob(pattern)}

    def kill_after(self, files, seconds):
        """Starts the study and kills all of it when it has made so many files, and a while later."""
        seen = self.made()
        enough, end = len(seen) + files, time.time() + 60
        study = self.start()
        while len(seen) < enough and study.poll() is None and time.time() < end:
            time.sleep(0.01)
            seen |= self.made()
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
        table = "repetitions: 2\n" + SMALL.replace("restart_interval: 0.1", "restart_interval: 0.05")
        self.write_table(table.replace("particles: 30", "particles: 60") + CASES)
        self.know_speed()
        self.run_study("--no-report")
        expected, whole = ensemble_text(self.out), self.out
        self.out = self.folder / "killed"
        self.know_speed()
        moments, met, killed = random.Random(2016), [], 0
        for kill in range(KILLS):
            # Every fifth meets run.sh or Snakemake before they have begun.
            files = moments.randrange(1, MOST_FILES) if kill % 5 else 0
            killed += self.kill_after(files, moments.uniform(0, 0.1 if files else 3))
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
