# SPDX-License-Identifier: GPL-2.0-or-later
"""What there is to do in a study's folder, and what it costs; changes nothing."""

import shutil
from pathlib import Path

import estimate
from deck import Deck
from folder import CHANGED, DONE, GO_ON, START, Study, last_time, state_of
from table import read_table
from words import duration, size


class Refusal(Exception):
    """One line for the user."""


class Plan:
    """Table, folder, and the state of every run."""

    def __init__(self, table_file, out):
        self.deck = Deck()
        self.table = read_table(table_file, self.deck)
        self.study = Study(Path(out).resolve())
        check_folder(self.study.out)
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


def check_folder(out):
    if out.exists() and not out.is_dir():
        raise Refusal(f"{out} is no folder, expected one for the study: choose another with OUT=...")
    if out.exists() and any(out.iterdir()) and not any(
        (out / name).exists() for name in ("runs", "cases.json", ".study")
    ):
        raise Refusal(f"{out} exists and is no study: choose another with OUT=...")


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
