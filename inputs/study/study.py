# SPDX-License-Identifier: GPL-2.0-or-later
"""What run.sh asks before and after Snakemake.

  study.py check TABLE OUT                   is the table right, and the folder one for a study?
  study.py plan TABLE OUT CORES              what is to be done and what it costs; changes nothing
  study.py prepare TABLE OUT CORES           the same, then brings OUT in line with the table
  study.py groups OUT N                      --group-components of Snakemake, N repetitions a job
  study.py summary OUT STATUS                what came out of it; Snakemake's exit status
"""

import datetime
import json
import os
import shutil
import socket
import sys
from pathlib import Path

import estimate
from deck import DECK, Deck
from folder import (CHANGED, DONE, GO_ON, IRRELEVANT, START, Study, is_analysed, last_time, read_json, state_of,
                    write_if_other)
from jobs import PROGRAMS, cases_text
from table import TableError, read_table
from words import duration, size

TIMES = ("spheres_each", "particles", "timestep", "t_last", "t_landed", "t_rest", "n_observe", "engine")
RUNTIME_MARGIN = 4  # minutes to ask of a cluster: times the estimate, and a quarter of an hour


class Refusal(Exception):
    """One line for the user."""


class Plan:
    """Table, folder, and the state of every run."""

    def __init__(self, table_file, out):
        self.deck = Deck()
        self.table = read_table(table_file, self.deck)
        self.study = Study(Path(out).resolve())
        _check_folder(self.study.out)
        self.states = {}  # (case, seed) -> (state, why)
        for case in self.table.cases:
            for seed in case.seeds:
                values = {**case.values, "seed": seed}
                run = self.study.run(case.name, seed)
                self.states[case.name, seed] = state_of(run, values, self.deck)

    def with_state(self, state):
        return [key for key, (found, _) in self.states.items() if found == state]

    def left_out(self):
        """Cases that the folder has runs of and the table has not."""
        runs = self.study.out / "runs"
        found = sorted(item.name for item in runs.iterdir() if item.is_dir()) if runs.exists() else []
        return [name for name in found if name not in {case.name for case in self.table.cases}]

    def work_left(self):
        """Processor time, s, on the machine of the measurement."""
        left = 0.0
        for case in self.table.cases:
            for seed in case.seeds:
                state = self.states[case.name, seed][0]
                left += 0 if state == DONE else estimate.work(case.values)
                if state == GO_ON:
                    time_s = last_time(self.study.run(case.name, seed) / "energies.csv")
                    left -= estimate.work_until(min(time_s, case.values["t_rest"]), case.values)
        return max(left, 0.0)

    def disk(self, cores):
        """Bytes to come in the end, of restart files at most while `cores` are busy."""
        end, peaks = 0.0, []
        for case in self.table.cases:
            todo = sum(self.states[case.name, seed][0] != DONE for seed in case.seeds)
            kept, peak = estimate.disk(case.values, case.keep_restarts)
            end += todo * kept
            peaks += [peak] * todo
        return end, sum(sorted(peaks, reverse=True)[:cores])


def _check_folder(out):
    if out.exists() and not out.is_dir():
        raise Refusal(f"{out} is no folder, expected one for the study: choose another with OUT=...")
    if out.exists() and any(out.iterdir()) and not any(
        (out / name).exists() for name in ("runs", "cases.json", ".study")
    ):
        raise Refusal(f"{out} exists and is no study: choose another with OUT=...")


def speed_of(study):
    """This machine's speed; measured once a study and machine."""
    file, host = study.state / "speed.json", socket.gethostname()
    known = read_json(file) or {}
    if host not in known:
        known[host] = round(estimate.measure_speed(PROGRAMS / "liggghts", DECK), 3)
        if study.state.exists():
            write_if_other(file, json.dumps(known) + "\n")
    return known[host]


def describe(plan, cores, speed):
    """The plan, as lines for the user."""
    table, study = plan.table, plan.study
    count = {state: len(plan.with_state(state)) for state in (DONE, GO_ON, START, CHANGED)}
    yield f"study   {table.title} ({table.file})"
    yield f"folder  {study.out}"
    yield (
        f"runs    {len(plan.states)}, of {len(table.cases)} cases: {count[DONE]} done,"
        f" {count[GO_ON]} to go on, {count[START] + count[CHANGED]} to do"
    )
    left = plan.work_left() / speed
    yield (
        f"work    {left / 3600:.2g} core-hours, {duration(left / cores)} on {cores} cores"
        f" (measured: {speed:.2g} times the speed of the machine that the model is from)"
    )
    end, peak = plan.disk(cores)
    place = next(path for path in (study.out, *study.out.parents) if path.exists())
    free = shutil.disk_usage(place).free
    yield (
        f"disk    {size(end)} in the end, {size(peak)} more for restart files on the way;"
        f" {size(free)} are free" + (": TOO LITTLE" if end + peak > free else "")
    )
    for (case, seed), (state, why) in plan.states.items():
        if state == CHANGED:
            yield f"changed {case} seed {seed}: {why}: runs again, the old run goes to {study.aside(case)}"
    old = study.out / "study.yaml"
    if old.exists() and old.read_bytes() != Path(table.file).read_bytes():
        yield f"table   another one than {study.out} was made with, which goes to {study.out / 'aside'}"
    left_out = plan.left_out()
    if left_out:
        yield f"no part of the table, left alone: {', '.join(left_out)}"


def case_lines(plan, speed):
    """A line for each case: what it costs where it is not there yet."""
    yield f"{'case':<28} {'runs':>5} {'done':>5} {'core-hours each':>16} {'disk each':>10}"
    for case in plan.table.cases:
        done = sum(plan.states[case.name, seed][0] == DONE for seed in case.seeds)
        hours = estimate.work(case.values) / speed / 3600
        kept = size(estimate.disk(case.values, case.keep_restarts)[0])
        yield f"{case.name:<28} {len(case.seeds):>5} {done:>5} {hours:>16.2g} {kept:>10}"


def prepare(plan, speed):
    """Brings the folder in line with the table: what changed goes aside, flags tell what stands."""
    study, now = plan.study, datetime.datetime.now().strftime("%Y%m%d-%H%M%S")
    study.state.mkdir(parents=True, exist_ok=True)
    for case, seed in plan.with_state(CHANGED):
        study.aside(case).mkdir(parents=True, exist_ok=True)
        os.rename(study.run(case, seed), study.aside(case) / f"seed-{seed}.before.{now}")
    text, copy = Path(plan.table.file).read_text(), study.out / "study.yaml"
    if copy.exists() and copy.read_text() != text:
        (study.out / "aside").mkdir(exist_ok=True)
        os.rename(copy, study.out / "aside" / f"study.before.{now}.yaml")
    write_if_other(copy, text)
    complete = [set_flags(study, *key, state == DONE) for key, (state, _) in plan.states.items()]
    if not all(complete):
        # Snakemake would not look behind it.
        (study.state / "finished").unlink(missing_ok=True)
    speed_file = study.state / "speed.json"
    known = {**(read_json(speed_file) or {}), socket.gethostname(): speed}
    write_if_other(speed_file, json.dumps(known) + "\n")
    write_if_other(study.plan_file, json.dumps(plan_entries(plan, speed), indent=1) + "\n")
    write_if_other(study.cases_file, cases_text(cases_of(plan)))


def set_flags(study, case, seed, done):
    """Flags as old as what they stand for, so that nothing is made anew on their account.

    Returns whether all steps of the run are done.
    """
    run = study.run(case, seed)
    marks = {"deposited": run / "result.json", "analysed": run / "analysis" / "summary.json"}
    holds = {"deposited": done, "analysed": done and is_analysed(run)}
    for step, mark in marks.items():
        flag = study.flag(step, case, seed)
        if not holds[step]:
            flag.unlink(missing_ok=True)
        elif not flag.exists():
            flag.parent.mkdir(parents=True, exist_ok=True)
            flag.touch()
            shutil.copystat(mark, flag)
    study.failure(case, seed).unlink(missing_ok=True)
    return all(holds.values())


def plan_entries(plan, speed):
    """plan.json"""
    return {
        case.name: {
            "variables": case.parameters,
            "ranks": case.ranks,
            "keep_restarts": case.keep_restarts,
            "minutes": 15 + int(RUNTIME_MARGIN * estimate.work(case.values) / speed / 60 / case.ranks),
            "mem_mb": estimate.memory_mb(case.values),
            "work_s": estimate.work(case.values),
            "times": {name: case.values[name] for name in TIMES},
        }
        for case in plan.table.cases
    }


def plain(value):
    """5 for 5.0, as a person would write it."""
    return int(value) if isinstance(value, float) and value.is_integer() else value


def cases_of(plan):
    """cases.json: what `rodpack ensemble` and `rodpack report` need of the table.

    Without what may differ from run to run of a case, such as the interval of the output.
    """
    cases = {
        case.name: {
            "seeds": case.seeds,
            "parameters": {
                name: plain(case.values[name])
                for name in case.parameters
                if name not in IRRELEVANT
            },
            "ranks": case.ranks,
        }
        for case in plan.table.cases
    }
    return {
        "format": "rodpack-study 1",
        "title": plan.table.title,
        "columns": [name for name in plan.table.columns if name not in IRRELEVANT],
        "cases": cases,
    }


def groups(out, count):
    """One group a case, `count` repetitions in a job."""
    names = read_json(Study(Path(out)).cases_file)["cases"]
    return "\n".join(f"{name}={count}" for name in names)


def summary(out, status):
    """Prints what came out of it. Returns the exit status: 1 when anything is missing."""
    study = Study(Path(out))
    failures = sorted((study.state / "failed").glob("*/seed-*"))
    for file in failures:
        case, seed = file.parent.name, file.name[len("seed-"):]
        print(f"FAILED {case} seed {seed}: {file.read_text().strip()}")
        print(f"       log: {study.log(case, int(seed))}")
    if status and not failures:
        print(f"FAILED: see {study.out / 'logs'}, snakemake.log first")
    left_out = (read_json(study.cases_file) or {}).get("left_out")
    if left_out:
        print(f"ensemble and report are without {', '.join(left_out)}")
    for result in ("ensemble/ensemble.json", "report.html"):
        if status == 0 and (study.out / result).exists():
            print(study.out / result)
    return 1 if status or failures else 0


def main(words):
    if words[0] == "check":
        read_table(words[1], Deck())
        _check_folder(Path(words[2]))
    elif words[0] in ("plan", "prepare"):
        plan, cores = Plan(words[1], words[2]), int(words[3])
        speed = speed_of(plan.study)
        if words[0] == "plan":
            print("\n".join(case_lines(plan, speed)))
        print("\n".join(describe(plan, cores, speed)))
        if words[0] == "prepare":
            prepare(plan, speed)
    elif words[0] == "groups":
        print(groups(words[1], int(words[2])))
    elif words[0] == "summary":
        return summary(words[1], int(words[2]))
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except (TableError, Refusal, RuntimeError) as error:
        print(f"inputs/study/run.sh: {error}", file=sys.stderr)
        sys.exit(1)
