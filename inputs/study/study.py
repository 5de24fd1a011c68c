# SPDX-License-Identifier: GPL-2.0-or-later
"""What run.sh asks before and after Snakemake.

  study.py check TABLE OUT                   is the table right, and the folder one for a study?
  study.py plan TABLE OUT CORES              what is to be done and what it costs; changes nothing
  study.py prepare TABLE OUT CORES           the same, then brings OUT in line with the table
  study.py groups OUT N                      --group-components of Snakemake, N repetitions a job
  study.py summary OUT STATUS                what came out of it; Snakemake's exit status
"""

import json
import re
import socket
import sys
from pathlib import Path

import estimate
from deck import DECK, Deck
from folder import Study, is_analysed, read_json, write_if_other
from jobs import PROGRAMS
from plan import Plan, Refusal, case_lines, check_folder, describe
from prepare import prepare
from table import TableError, read_table


def speed_of(study):
    """This machine's speed; measured once a study and machine."""
    file, host = study.state / "speed.json", socket.gethostname()
    known = read_json(file) or {}
    if host not in known:
        known[host] = round(estimate.measure_speed(PROGRAMS / "liggghts", DECK), 3)
        if study.state.exists():
            write_if_other(file, json.dumps(known) + "\n")
    return known[host]


def groups(out, count):
    """One group a case, `count` repetitions in a job."""
    names = read_json(Study(Path(out)).cases_file)["cases"]
    return "\n".join(f"{name}={count}" for name in names)


def summary(out, status):
    """Prints what came out of it. Returns the exit status: 1 when anything is missing."""
    study = Study(Path(out))
    table = read_json(study.cases_file) or {"cases": {}}
    failures = sorted((study.state / "failed").glob("*/seed-*"))
    for file in failures:
        case, seed = file.parent.name, file.name[len("seed-"):]
        print(f"FAILED {case} seed {seed}: {file.read_text().strip()}")
        print(f"       log: {study.log(case, int(seed))}")
    missing = [
        f"{name} seed {seed}"
        for name, case in table["cases"].items()
        for seed in case["seeds"]
        if not is_analysed(study.run(name, seed)) and not study.failure(name, seed).exists()
    ]
    if status and missing:
        print(f"not finished: {', '.join(missing)}")
    if status and not failures:
        print(f"FAILED: {last_error(study)}")
    if "left_out" in table:
        print(f"ensemble and report are without {', '.join(table['left_out'])}")
    for result in ("ensemble/ensemble.json", "report.html"):
        if status == 0 and (study.out / result).exists():
            print(study.out / result)
    return 1 if status or failures else 0


def last_error(study):
    """What stopped the study where no run did: its last programs', else Snakemake's words."""
    for name in ("report.log", "ensemble.log", "snakemake.log"):
        log = study.out / "logs" / name
        lines = log.read_text(errors="replace").split("\n") if log.exists() else []
        errors = [line.strip() for line in lines if re.search(r"^rodpack: |[Ee]rror|Exception", line)]
        if errors and (name == "snakemake.log" or lines[-2] == errors[-1]):
            return f"{errors[-1]} (log: {log})"
    return f"see {study.out / 'logs'}"


def main(words):
    if words[0] == "check":
        read_table(words[1], Deck())
        check_folder(Path(words[2]))
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
