# SPDX-License-Identifier: GPL-2.0-or-later
"""What the tests of the study workflow share: a fresh folder, a table, inputs/study/run.sh."""

import contextlib
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parent.parent.parent
WORKFLOW = REPOSITORY / "inputs" / "study"
DEPOSITION = REPOSITORY / "inputs" / "deposition"
PROGRAMS = Path(os.environ.get("RODPACK_BIN", REPOSITORY / "build" / "bin"))
sys.path[:0] = [str(WORKFLOW), str(DEPOSITION)]

# A bed of one layer: a second a run.
SMALL = """\
defaults:
  particles: 30
  particles_per_line: 10
  width_in_lengths: 12
  container_height: 0.4
  restart_interval: 0.1
"""
CASES = """\
cases:
  spheres:
    aspect_ratio: 1
  rods:
    aspect_ratio: 3
"""


# The tests of the workflow end with the ensemble; the report has tests of its own.
UNTIL_ENSEMBLE = ("--no-report",)
# Seconds after which a study of these has not been slow but has come to a halt.
LONGEST_STUDY = 240


class StudyTest(unittest.TestCase):
    """A test with a folder of its own, which stays when the test fails."""

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="rodpack-study-"))
        self.out = self.folder / "out"
        self.table = self.folder / "table.yaml"

    def tearDown(self):
        outcome = self._outcome.result
        bad = [test for test, _ in outcome.failures + outcome.errors if test is self]
        if bad:
            print(f"kept: {self.folder}")
        else:
            shutil.rmtree(self.folder)

    def write_table(self, text):
        self.table.write_text(text)

    def know_speed(self):
        """Spares run.sh the measurement of this machine's speed."""
        (self.out / ".study").mkdir(parents=True, exist_ok=True)
        (self.out / ".study" / "speed.json").write_text(json.dumps({os.uname().nodename: 1.0}))

    def command(self, *words):
        return ["sh", str(WORKFLOW / "run.sh"), str(self.table), f"OUT={self.out}", "-j", "2", *words]

    def environment(self):
        return {**os.environ, "RODPACK_BIN": str(PROGRAMS), "PROGRESS_S": "0.5"}

    def run_study(self, *words, expect=0):
        """Runs run.sh to its end. Returns what it printed."""
        study = subprocess.Popen(
            self.command(*words), env=self.environment(), stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, text=True, start_new_session=True,
        )
        try:
            printed = study.communicate(timeout=LONGEST_STUDY)[0]
        except BaseException as fault:
            at_work = members_of(study.pid)
            os.killpg(study.pid, signal.SIGKILL)
            if isinstance(fault, subprocess.TimeoutExpired):
                self.fail(f"no end after {LONGEST_STUDY} s\n{at_work}\n{self.log('snakemake.log')}")
            raise
        self.assertEqual(study.returncode, expect, printed + self.log("snakemake.log"))
        return printed

    def log(self, name):
        file = self.out / "logs" / name
        return file.read_text()[-4000:] if file.exists() else ""

    def run_folder(self, case, seed):
        return self.out / "runs" / case / f"seed-{seed}"

    def result(self, case, seed):
        return json.loads((self.run_folder(case, seed) / "result.json").read_text())

    def started(self):
        """How often LIGGGHTS was started for each run: {case-seed-n: times}."""
        logs = (self.out / "logs").glob("*-seed-*.log")
        count = {log.stem: log.read_text().count("LIGGGHTS (Version") for log in logs}
        return {name: times for name, times in count.items() if times > 0}


def members_of(group):
    """The command lines of the processes of a group, one a line."""
    commands = []
    for process in Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):  # it has ended meanwhile
            if os.getpgid(int(process.name)) == group:
                commands.append((process / "cmdline").read_text().replace("\0", " "))
    return "\n".join(commands)


def ensemble_text(out):
    """ensemble.json, the same to the last digit for the same runs."""
    return (out / "ensemble" / "ensemble.json").read_text()


def ensemble(out):
    return json.loads(ensemble_text(out))
