# SPDX-License-Identifier: GPL-2.0-or-later
"""Brings a study's folder in line with its table, and writes down what Snakemake needs to know."""

import datetime
import json
import os
import shutil
import socket
from pathlib import Path

import estimate
from folder import CHANGED, DONE, IRRELEVANT, is_analysed, read_json, write_if_other
from jobs import cases_text

TIMES = ("spheres_each", "particles", "timestep", "t_last", "t_landed", "t_rest", "n_observe", "engine")
RUNTIME_MARGIN = 4  # minutes to ask of a cluster: times the estimate, and a quarter of an hour


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
    for step, product in {"ensemble": "ensemble/ensemble.json", "report": "report.html"}.items():
        if not (study.out / product).exists():
            (study.state / step).unlink(missing_ok=True)
    # Snakemake's own marks of steps that were interrupted: the flags know better, and to force such steps
    # makes Snakemake 7.21 forget others.
    shutil.rmtree(study.state / ".snakemake" / "incomplete", ignore_errors=True)
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
