# SPDX-License-Identifier: GPL-2.0-or-later
"""The steps of a study that Snakemake calls, each in a process of its own.

  jobs.py deposit OUT CASE SEED     one run, from where it stands to its end
  jobs.py analyse OUT CASE SEED     rodpack analyse
  jobs.py finish OUT PARTIAL        are all runs there? PARTIAL = 1: goes on with those that are
  jobs.py ensemble OUT              rodpack ensemble
  jobs.py report OUT                rodpack report

A run that ends with an error of its own would end so again: the step records it and succeeds, so
that the others go on, in a group job of a cluster as well. What stopped a run from outside (a signal,
a lost node) fails the step; the run goes on when Snakemake tries again.
"""

import contextlib
import fcntl
import json
import os
import subprocess
import sys
from pathlib import Path

from folder import Study, is_analysed, read_json, write_if_other

HERE = Path(__file__).resolve().parent
PROGRAMS = Path(os.environ.get("RODPACK_BIN") or HERE.parent.parent / "build" / "bin")


def arguments_of(plan, seed):
    """-var ... of a case of plan.json"""
    words = ["-var", "seed", str(seed)]
    for name, text in plan["variables"].items():
        words += ["-var", name, text]
    return words


def call(command, log, keep_open=(), **environment):
    """Runs a program whose output is appended to a log. Returns its exit status and what it printed."""
    log.parent.mkdir(parents=True, exist_ok=True)
    with open(log, "ab") as stream:
        begin = stream.tell()
        status = subprocess.run(
            command, stdout=stream, stderr=subprocess.STDOUT, env={**os.environ, **environment},
            pass_fds=keep_open,
        ).returncode
    with open(log, encoding="utf-8", errors="replace") as stream:
        stream.seek(begin)
        lines = [line.strip() for line in stream if line.strip()]
    return status, lines


def fail(study, case, seed, why):
    write_if_other(study.failure(case, seed), why + "\n")


def touch(flag):
    flag.parent.mkdir(parents=True, exist_ok=True)
    flag.touch()


def deposit(study, name, seed):
    plan = json.loads(study.plan_file.read_text())[name]
    run, log = study.run(name, seed), study.log(name, seed)
    study.failure(name, seed).unlink(missing_ok=True)
    status, lines = call(
        [HERE.parent / "deposition" / "run_one.sh", run, *arguments_of(plan, seed)],
        log,
        RANKS=str(plan["ranks"]),
        LIGGGHTS=str(PROGRAMS / "liggghts"),
        ASIDE=str(study.aside(name)),
    )
    if status == 0:
        prune(run, plan["keep_restarts"])
    else:
        errors = [line for line in lines if line.startswith("ERROR")]
        fail(study, name, seed, errors[-1] if errors else f"stopped, exit status {status}")
        if not errors:
            return 1
    touch(study.flag("deposited", name, seed))
    return 0


def prune(run, keep):
    """Of a complete run the restart files go, but for that of the bed at rest."""
    for file in (run / "restart").glob("deposition.*.restart"):
        if keep == "none" or (keep == "end" and file.name != "deposition.end.restart"):
            file.unlink()


def analyse(study, case, seed):
    run = study.run(case, seed)
    run.parent.mkdir(parents=True, exist_ok=True)
    # The lock of run_one.sh: a cluster's job that outlived its study may be at it still.
    with open(run.parent / f".lock.{run.name}", "w") as lock:
        with contextlib.suppress(OSError):  # a file system without locks
            fcntl.flock(lock, fcntl.LOCK_EX)
        if read_json(run / "result.json") is not None and not is_analysed(run):
            command = [PROGRAMS / "rodpack", "analyse", run]
            status, lines = call(command, study.log(case, seed), keep_open=(lock.fileno(),))
            if status < 0:
                return 1
            if status != 0 or not is_analysed(run):
                fail(study, case, seed, f"analysis: {lines[-1] if lines else f'exit status {status}'}")
    touch(study.flag("analysed", case, seed))
    return 0


def finish(study, partial):
    """All runs of cases.json have their analysis, or `partial` and cases.json is cut down to those."""
    table = json.loads(study.cases_file.read_text())
    left_out = []
    for name, case in table["cases"].items():
        missing = [seed for seed in case["seeds"] if not is_analysed(study.run(name, seed))]
        case["seeds"] = [seed for seed in case["seeds"] if seed not in missing]
        left_out += [f"{name} seed {seed}" for seed in missing]
    if left_out and not partial:
        print(f"{len(left_out)} runs are missing: " + ", ".join(left_out), file=sys.stderr)
        return 1
    if left_out:
        table["cases"] = {name: case for name, case in table["cases"].items() if case["seeds"]}
        table["left_out"] = left_out
        write_if_other(study.cases_file, cases_text(table))
    if not table["cases"]:
        print("no run has been completed", file=sys.stderr)
        return 1
    touch(study.state / "finished")
    return 0


def compare(study, step):
    """rodpack ensemble, rodpack report; the flag says that it has come to its end."""
    log = study.out / "logs" / f"{step}.log"
    log.unlink(missing_ok=True)
    status, _ = call([PROGRAMS / "rodpack", step, study.out], log)
    if status == 0:
        touch(study.state / step)
    return status


def cases_text(table):
    """cases.json, a case a line."""
    head = {key: value for key, value in table.items() if key != "cases"}
    lines = [f"  {json.dumps(key)}: {json.dumps(value)}" for key, value in head.items()]
    cases = [f"    {json.dumps(name)}: {json.dumps(case)}" for name, case in table["cases"].items()]
    lines.append('  "cases": {\n' + ",\n".join(cases) + "\n  }")
    return "{\n" + ",\n".join(lines) + "\n}\n"


def main(words):
    study = Study(Path(words[1]))
    if words[0] == "finish":
        return finish(study, words[2] == "1")
    if words[0] in ("ensemble", "report"):
        return compare(study, words[0])
    return {"deposit": deposit, "analyse": analyse}[words[0]](study, words[2], int(words[3]))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
