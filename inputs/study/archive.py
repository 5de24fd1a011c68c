# SPDX-License-Identifier: GPL-2.0-or-later
"""Packs what the ensemble needs of the finished runs of a study, some 30 kB each, to publish it.

  python3 inputs/study/archive.py OUT FILE.tar.xz

Unpacked into another folder, run.sh takes the runs for its own and makes the same ensemble.json. Whole are
the tables of each analysis, its summary, parameters.json, result.json and the log; of the map, fields.csv,
the columns that an ensemble shows, with six digits. Dumps, restart files and figures stay behind.
"""

import csv
import io
import sys
import tarfile
from pathlib import Path

from folder import Study, is_analysed, read_json

WHOLE = ("parameters.json", "result.json", "log.liggghts", "analysis/summary.json")
MAP = "analysis/fields.csv"
MAP_COLUMNS = ("x_m", "y_m", "solid_fraction", "contact_stress_xx_N_m", "contact_stress_yy_N_m")


class Refusal(Exception):
    pass


def short_map(file):
    """The columns of a map that an ensemble shows, with six digits."""
    with open(file, newline="", encoding="utf-8") as stream:
        rows = csv.DictReader(stream)
        names = [name for name in MAP_COLUMNS if name in rows.fieldnames]
        lines = [",".join(names)] + [",".join(f"{float(row[name]):.6g}" for name in names) for row in rows]
    return "\n".join(lines) + "\n"


def add_run(archive, run, out):
    for file in sorted([run / name for name in WHOLE] + list((run / "analysis").glob("*.csv"))):
        if not file.exists():
            continue
        entry = archive.gettarinfo(file, str(file.relative_to(out)))
        # Whose files they were is nobody's business; their times tell that the analysis is current.
        entry.uid = entry.gid = 0
        entry.uname = entry.gname = ""
        content = short_map(file).encode() if file == run / MAP else file.read_bytes()
        entry.size = len(content)
        archive.addfile(entry, io.BytesIO(content))


def pack(out, target):
    """Packs all runs of cases.json that are finished. Returns how many there are, and how many are not."""
    study = Study(Path(out))
    table = read_json(study.cases_file)
    if table is None:
        raise Refusal(f"{study.cases_file}: no such file, expected the folder of a study that was begun")
    if Path(target).exists():
        raise Refusal(f"{target} exists, expected the name of a new file")
    runs = [study.run(name, seed) for name, case in table["cases"].items() for seed in case["seeds"]]
    finished = [run for run in runs if read_json(run / "result.json") is not None and is_analysed(run)]
    if not finished:
        raise Refusal(f"{out}: no run is finished and analysed yet")
    part = Path(target).with_name(Path(target).name + ".part")
    try:
        with tarfile.open(part, "w:xz", preset=9) as archive:
            for run in finished:
                add_run(archive, run, study.out)
        part.rename(target)
    finally:
        part.unlink(missing_ok=True)
    return len(finished), len(runs) - len(finished)


def main(words):
    if len(words) != 2 or not words[1].endswith(".tar.xz"):
        raise Refusal(f"'{' '.join(words)}', expected OUT FILE.tar.xz")
    packed, missing = pack(*words)
    unfinished = f"; {missing} are not finished" if missing else ""
    print(f"{packed} runs in {words[1]}, {Path(words[1]).stat().st_size / 1e6:.2f} MB{unfinished}")


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except (Refusal, OSError) as error:
        print(f"inputs/study/archive.py: {error}", file=sys.stderr)
        sys.exit(1)
