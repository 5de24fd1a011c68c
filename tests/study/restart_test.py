# SPDX-License-Identifier: GPL-2.0-or-later
"""Restart files that were cut off are told from whole ones, wherever the cut is."""

import os
import random
import subprocess
import unittest

from support import DEPOSITION, PROGRAMS, StudyTest

import whole_restart

VARIABLES = {"particles": 12, "particles_per_line": 6, "width_in_lengths": 6, "container_height": 0.2,
             "aspect_ratio": 3, "restart_interval": 0.1}


class Restart(StudyTest):
    def deposit(self, ranks, **others):
        run = self.folder / f"run-{ranks}"
        words = []
        for name, value in {**VARIABLES, **others}.items():
            words += ["-var", name, str(value)]
        environment = {**os.environ, "LIGGGHTS": str(PROGRAMS / "liggghts"), "RANKS": str(ranks)}
        subprocess.run([DEPOSITION / "run_one.sh", run, *words], check=True, env=environment,
                       stdout=subprocess.DEVNULL)
        return run

    def is_whole(self, content):
        file = self.folder / "file"
        file.write_bytes(content)
        return whole_restart.is_whole(file)

    def test_every_file_of_a_run_is_whole_and_no_beginning_of_one_is(self):
        for ranks, others in ((1, {}), (2, {}), (1, {"integrator": "builtin"})):
            run = self.deposit(ranks, **others)
            files = sorted((run / "restart").iterdir())
            self.assertGreaterEqual(len(files), 4)
            for file in files:
                self.assertTrue(whole_restart.is_whole(file), file)
            content = files[-1].read_bytes()
            self.assertFalse(self.is_whole(content + b"\0"))
            cuts = random.Random(1)
            for size in [*range(0, 1500, 7), *(cuts.randrange(len(content)) for _ in range(200)),
                         len(content) - 8, len(content) - 1]:
                self.assertFalse(self.is_whole(content[:size]), size)
            subprocess.run(["rm", "-r", run], check=True)

    def test_the_last_whole_one_is_taken(self):
        run = self.deposit(1)
        files = {int(file.name.split(".")[1]): file for file in (run / "restart").glob("deposition.[0-9]*")}
        steps = sorted(files)
        self.assertGreaterEqual(len(steps), 3)
        # by its step, not by its name (45455 is after 9091) nor by its time
        os.utime(files[steps[0]])
        self.assertEqual(whole_restart.last_whole(run), str(files[steps[-1]]))
        os.truncate(files[steps[-1]], 5000)
        self.assertEqual(whole_restart.last_whole(run), str(files[steps[-2]]))
        for step in steps:
            os.truncate(files[step], 0)
        self.assertIsNone(whole_restart.last_whole(run))
        self.assertIsNone(whole_restart.last_whole(self.folder / "nowhere"))

    def test_a_file_of_something_else_is_not_whole(self):
        self.assertFalse(self.is_whole(b"no restart file at all, and long enough to be read into" * 9))
        self.assertFalse(whole_restart.is_whole(self.folder))


if __name__ == "__main__":
    unittest.main()
