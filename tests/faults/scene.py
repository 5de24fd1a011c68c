# SPDX-License-Identifier: GPL-2.0-or-later
"""A small run of a deck that faults happen to, and what it has to come to in spite of them."""

import os
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[2]
RUN_ONE = REPOSITORY / "inputs" / "deposition" / "run_one.sh"

sys.path.insert(0, str(RUN_ONE.parent))
import whole_restart  # noqa: E402

# The decks with a run folder: some ten restart files and dumps of each kind in about a second.
DECKS = {
    "deposition": {"particles": 12, "width_in_lengths": 5, "particles_per_line": 4, "container_height": 0.12,
                   "relaxation_ratio": 1e-4, "restart_interval": 0.05, "output_interval": 0.04},
    "discharge": {"particles": 40, "container_width": 0.036, "orifice_width": 0.015, "particles_per_line": 5,
                  "settle_time": 0.1, "flow_limit": 0.2, "shutter_speed": 0.5, "restart_interval": 0.04,
                  "output_interval": 0.04},
    "deposition3d": {"particles": 30, "aspect_ratio": 3, "surface": "coarse", "container_width": 0.018,
                     "relaxation_ratio": 1e-4, "restart_interval": 0.05, "output_interval": 0.04},
}
# No fault may take longer to be noticed; four times as much on a machine that does other things.
PATIENCE = 40


class Failure(Exception):
    """What a fault must not lead to."""


def words(variables):
    return [word for name, value in variables.items() for word in ("-var", name, str(value))]


class Scene:
    def __init__(self, programs, work, deck):
        self.deck = REPOSITORY / "inputs" / deck / f"in.{deck}"
        self.variables = DECKS[deck]
        self.programs = Path(programs).resolve()
        self.liggghts = self.programs / "liggghts"
        self.work = Path(work).resolve()
        shutil.rmtree(self.work, ignore_errors=True)
        self.work.mkdir(parents=True)
        self._references = {}
        self._folders = 0

    def remove(self):
        shutil.rmtree(self.work, ignore_errors=True)

    def fresh(self):
        self._folders += 1
        folder = self.work / f"fault-{self._folders}"
        folder.mkdir()
        return folder

    def environment(self, ranks=1, **others):
        # Ranks that wait leave their core to others.
        return {**os.environ, "OMPI_MCA_mpi_yield_when_idle": "1", "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
                "OMPI_MCA_ess_singleton_isolated": "1" if ranks == 1 else "0", "RANKS": str(ranks),
                "LIGGGHTS": str(self.liggghts), "DECK": str(self.deck), **{k: str(v) for k, v in others.items()}}

    def start(self, run, ranks=1, variables=None, limit=None, **environment):
        """run_one.sh in a process group of its own; `limit` is called in it before it starts."""
        out = open(run.parent / "output.txt", "a")
        return subprocess.Popen(
            [RUN_ONE, run, *words({**self.variables, **(variables or {})})], stdout=out, stderr=out,
            stdin=subprocess.DEVNULL, env=self.environment(ranks, **environment), start_new_session=True,
            preexec_fn=limit)

    @staticmethod
    def wait_until_under_way(run):
        for _ in range(10 * PATIENCE):
            if (run / "energies.csv").exists():
                return
            time.sleep(0.1)
        raise Failure(f"{run} does not begin: {tail(run)}")

    def finish(self, process, what):
        try:
            return process.wait(PATIENCE)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            raise Failure(f"{what}: no end after {PATIENCE} s")

    def complete(self, run, what, ranks=1, variables=None):
        """The command that a user gives again; the run has to come to its end."""
        status = self.finish(self.start(run, ranks, variables), what)
        if status != 0 or not (run / "result.json").exists():
            raise Failure(f"{what}: not completed by the same command (status {status}): {tail(run)}")

    def liggghts_alone(self, run, *arguments, ranks=1, limit=None):
        """The program without run_one.sh; returns its status and what it said."""
        launcher = ["mpiexec", "--oversubscribe", "--bind-to", "none", "-np", str(ranks)] if ranks > 1 else []
        try:
            done = subprocess.run(
                [*launcher, self.liggghts, "-log", "none", "-in", self.deck, "-var", "out", run,
                 *words(self.variables), *arguments],
                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env=self.environment(ranks),
                timeout=PATIENCE, preexec_fn=limit, cwd=run.parent)
        except subprocess.TimeoutExpired:
            raise Failure(f"{arguments}: no end after {PATIENCE} s")
        return done.returncode, done.stdout.decode(errors="replace")

    def reference(self, ranks=1):
        """Files of the run that nothing happened to, by name, and its time in seconds."""
        if ranks not in self._references:
            run = self.fresh() / "run"
            begin = time.monotonic()
            self.complete(run, f"reference of {ranks} ranks", ranks)
            self._references[ranks] = (contents(run), time.monotonic() - begin, run)
        return self._references[ranks]

    def expect_the_same(self, run, what, ranks=1):
        expected, found = self.reference(ranks)[0], contents(run)
        different = [name for name in sorted(set(expected) | set(found))
                     if expected.get(name) != found.get(name)]
        if different:
            raise Failure(f"{what}: not as in the run that nothing happened to: {different[:6]}")


def contents(run):
    """What a run has to say: tables, result, parameters but for its own name, dumps."""
    files = {file.name: "unfinished" for file in run.rglob("*.part")}
    for file in [*sorted(run.glob("*.csv")), run / "result.json", *sorted((run / "dumps").iterdir())]:
        files[file.name] = file.read_bytes() if file.exists() else None
    text = (run / "parameters.json").read_text()
    files["parameters.json"] = re.sub(r'"(out|resume)": .*', "", text)
    return files


def tail(run):
    output = run.parent / "output.txt"
    return output.read_text(errors="replace")[-1500:] if output.exists() else ""


def expect_one_line(text, what):
    """A refusal is one line, from whichever ranks."""
    lines = {re.sub(r"on proc \d+", "on proc", line) for line in text.splitlines() if "ERROR" in line}
    if len(lines) != 1:
        raise Failure(f"{what}: expected one line of error, got {sorted(lines) or text[-300:]!r}")
