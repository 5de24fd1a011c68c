# SPDX-License-Identifier: GPL-2.0-or-later
"""The page that has each published number and claim of the paper beside ours.

  python3 inputs/study/validation.py > inputs/study/results/validation.md

from published.csv and what the studies left in results/: nothing on it is written by hand, and a test makes it
again, so that page and results cannot part.
"""

import csv
import math
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
RESULTS = HERE / "results"
MEASURES = (("solid_fraction", "up to the surface"),
            ("solid_fraction_to_3_omega_below_surface", "up to 3ω below it"))
MARKS = {"holds": "✓", "does not hold": "✗"}

HEAD = """\
# The paper's numbers and claims beside ours

Lu, Hidalgo, Third, Müller, Granular Matter 18:34 (2016). Made by [`validation.py`](../validation.py) from
[`published.csv`](../published.csv), [`reduced/numbers.csv`](reduced/numbers.csv) and
[`claims.csv`](reduced/claims.csv) (3000 particles, three seeds), and [`full/numbers.csv`](full/numbers.csv) (9000, as
the paper); a test makes it again. [What the differences mean](README.md): the kernel reads low beds too low, and the mass
that the specification gives the particles is worth 0.005 to 0.010.
"""


def rows_of(file):
    with open(file, newline="", encoding="utf-8") as stream:
        return list(csv.DictReader(stream))


def numbers_of(study):
    return {(row["case"], row["number"]): row for row in rows_of(RESULTS / study / "numbers.csv")}


def measured(row):
    """Mean and error of a number as text; of a single run the mean alone."""
    if row is None:
        return "–"
    mean, error = float(row["mean"]), float(row["sem"])
    return f"{mean:.4f}" if math.isnan(error) else f"{mean:.4f} ± {error:.4f}"


def difference(row, published):
    return "–" if row is None else f"{float(row['mean']) - published:+.3f}".replace("-", "−")


def published_table():
    studies = (("3000", numbers_of("reduced")), ("9000", numbers_of("full")))
    lines = ["## Published numbers",
             "Solid fraction φ in the central slice, from 3ω above the floor.",
             "",
             "| case | published | particles | " + " | ".join(f"{name} | difference" for _, name in MEASURES) + " |",
             "|---|---|---|" + "---|---|" * len(MEASURES)]
    for row in rows_of(HERE / "published.csv"):
        if row["quantity"] != MEASURES[0][0]:
            raise ValueError(f"published.csv: no table for the quantity {row['quantity']}")
        value = float(row["value"])
        for particles, numbers in studies:
            cells = []
            for key, _ in MEASURES:
                ours = numbers.get((row["case"], key))
                cells += [measured(ours), difference(ours, value)]
            lines.append(f"| {row['case']} | {row['value']} ± {row['error']} | {particles} | "
                         + " | ".join(cells) + " |")
    return lines


def claims_table():
    claims = rows_of(RESULTS / "reduced" / "claims.csv")
    counts = {}
    for claim in claims:
        counts[claim["verdict"]] = counts.get(claim["verdict"], 0) + 1
    lines = ["## Claims",
             "σ: significance in favour; from 2 a claim holds, to −2 it does not. "
             + ", ".join(f"{verdict}: {number}" for verdict, number in counts.items()) + ".",
             "",
             "| claim | measured | value | σ | verdict |",
             "|---|---|---|---|---|"]
    for claim in claims:
        error = f" ± {float(claim['error']):.2g}" if claim["error"] else ""
        value = f"{float(claim['value']):.4g}{error}".replace("-", "−")
        sigmas = f"{float(claim['sigmas']):.1f}".replace("-", "−")
        verdict = f"{MARKS.get(claim['verdict'], '?')} {claim['verdict']}"
        cells = (claim["claim"], claim["measured"], value, sigmas, verdict)
        lines.append("| " + " | ".join(cell.replace("<", "⟨").replace(">", "⟩").replace("|", "∣")
                                       for cell in cells) + " |")
    return lines


def page():
    return "\n".join([HEAD, *published_table(), "", *claims_table()]) + "\n"


if __name__ == "__main__":
    sys.stdout.reconfigure(encoding="utf-8")
    sys.stdout.write(page())
