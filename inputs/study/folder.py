# SPDX-License-Identifier: GPL-2.0-or-later
"""The folder of a study: where things are in it, and how far each run has come."""

import json
import os
import sys
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "deposition"))
import whole_restart  # noqa: E402  (beside the deck, whose restart files it reads)

# Parameters that a run may have otherwise and still be the run of the table: its name for the
# folder, and what changes neither motion nor end.
IRRELEVANT = {"preset", "out", "resume", "relaxation_limit", "output_interval", "restart_interval",
              "falling_skin", "settled_skin"}

DONE, GO_ON, START, CHANGED = "done", "to go on", "to do", "changed"


@dataclass(frozen=True)
class Study:
    """Paths below OUT."""

    out: Path

    def run(self, case, seed):
        return self.out / "runs" / case / f"seed-{seed}"

    def aside(self, case):
        return self.out / "aside" / case

    def log(self, case, seed):
        return self.out / "logs" / f"{case}-seed-{seed}.log"

    def flag(self, step, case, seed):
        """Exists when Snakemake need not take that step of a run: deposited, analysed."""
        return self.state / step / case / f"seed-{seed}"

    def failure(self, case, seed):
        """Holds the line that says why a run failed."""
        return self.state / "failed" / case / f"seed-{seed}"

    @property
    def state(self):
        return self.out / ".study"

    @property
    def cases_file(self):
        return self.out / "cases.json"

    @property
    def plan_file(self):
        """What Snakemake and its jobs need of a case: -var, ranks, minutes, memory, what to keep."""
        return self.state / "plan.json"


def read_json(file):
    """What a JSON file holds; None when it is missing or was cut off while it was written."""
    try:
        return json.loads(Path(file).read_text())
    except (OSError, ValueError):
        return None


def write_if_other(file, text):
    """Writes a file unless it holds that text already: its time says when it changed."""
    file = Path(file)
    if file.exists() and file.read_text() == text:
        return False
    file.parent.mkdir(parents=True, exist_ok=True)
    part = file.with_name(file.name + ".part")
    part.write_text(text)
    os.replace(part, file)
    return True


def difference(parameters, values, deck):
    """How a run's parameters.json differs from the values of a case, in words; empty if not at all."""
    for name, parameter in deck.parameters.items():
        if name in IRRELEVANT:
            continue
        if parameter.key not in parameters:
            return f"{name} is missing in its parameters.json"
        was, wanted = parameters[parameter.key], values[name]
        if isinstance(wanted, str) or isinstance(was, str):
            same = was == wanted
        else:
            same = abs(was - wanted) <= 1e-12 * abs(wanted)
        if not same:
            return f"{name} was {was}, is {wanted}"
    return ""


def state_of(run, values, deck):
    """State of a run folder against the values of its case, seed included: (state, why)."""
    parameters = read_json(run / "parameters.json")
    if parameters is None:
        return START, ""
    other = difference(parameters, values, deck)
    if other:
        return CHANGED, other
    if read_json(run / "result.json") is not None:
        return DONE, ""
    return (GO_ON, "") if whole_restart.last_whole(run) else (START, "")


def is_analysed(run):
    """`rodpack analyse` removes its summary first and writes it last."""
    summary = run / "analysis" / "summary.json"
    if read_json(summary) is None:
        return False
    result = read_json(run / "result.json") or {}
    return result.get("step") == read_json(summary).get("timestep")


def last_time(energies):
    """Simulated time, s, of the last whole line of a run's energies.csv."""
    try:
        with open(energies, "rb") as file:
            file.seek(max(0, os.fstat(file.fileno()).st_size - 400))
            lines = file.read().split(b"\n")[:-1]
        return float(lines[-1].split(b",")[1])
    except (OSError, IndexError, ValueError):
        return 0.0
