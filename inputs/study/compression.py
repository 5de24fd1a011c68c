# SPDX-License-Identifier: GPL-2.0-or-later
"""How far the weight above compresses the beds of a study: the solid fraction over the pressure.

  python3 inputs/study/compression.py OUT

For each finished run of OUT (packed ones too) a row of CSV: in the central vertical slice, 2 AR d_p wide,
from 3 omega above the floor to 3 omega below the surface, the line phi = phi_0 + c P through the rows of the
map, P = (sigma_xx + sigma_yy) / 2 in N/m. phi_0 is the solid fraction of the same arrangement without weight,
c P what the soft contacts give way. omega = 3 AR d_p (physics: Lu et al. 2016, section 2.4).
"""

import csv
import sys
from collections import defaultdict
from pathlib import Path

from folder import Study, read_json

COLUMNS = ("case", "seed", "bed_height_m", "solid_fraction", "pressure_N_m", "solid_fraction_without_pressure",
           "rise_m_N")


class Refusal(Exception):
    pass


def slice_rows(file, left, right, bottom, top):
    """(solid fraction, pressure) of the map's rows between heights, means over its columns between x."""
    rows = defaultdict(list)
    with open(file, newline="", encoding="utf-8") as stream:
        for row in csv.DictReader(stream):
            x, y = float(row["x_m"]), float(row["y_m"])
            if left <= x <= right and bottom <= y <= top:
                pressure = float(row["contact_stress_xx_N_m"]) + float(row["contact_stress_yy_N_m"])
                rows[y].append((float(row["solid_fraction"]), pressure / 2))
    return [tuple(sum(values) / len(values) for values in zip(*found)) for found in rows.values()]


def line_through(points):
    """Least squares of y over x: value at x = 0, slope, means of x and y."""
    n = len(points)
    x, y = sum(p for _, p in points) / n, sum(f for f, _ in points) / n
    slope = sum((f - y) * (p - x) for f, p in points) / sum((p - x) ** 2 for _, p in points)
    return y - slope * x, slope, x, y


def compression(run):
    """Bed height, means of solid fraction and pressure, solid fraction without pressure, rise."""
    parameters, summary = read_json(run / "parameters.json"), read_json(run / "analysis" / "summary.json")
    length = parameters["aspect_ratio"] * parameters["particle_diameter_m"]
    middle, height = parameters["container_width_m"] / 2, summary["bed_height_m"]
    edge = 1e-9 * length  # places are decimal numbers
    points = slice_rows(run / "analysis" / "fields.csv", middle - length - edge, middle + length + edge,
                        9 * length, height - 9 * length)
    if len(points) < 3:
        raise Refusal(f"{run}: the bed is {height:.3g} m high, expected more than 6 omega, {18 * length:.3g} m")
    without, rise, pressure, fraction = line_through(points)
    return height, fraction, pressure, without, rise


def main(words):
    if len(words) != 1:
        raise Refusal(f"'{' '.join(words)}', expected the folder of a study")
    study = Study(Path(words[0]))
    runs = sorted(path.parent for path in study.out.glob("runs/*/seed-*/result.json"))
    if not runs:
        raise Refusal(f"{words[0]}: no finished run, expected the folder of a study")
    print(",".join(COLUMNS))
    for run in runs:
        numbers = ",".join(f"{value:.5g}" for value in compression(run))
        print(f"{run.parent.name},{run.name[len('seed-'):]},{numbers}")


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except (Refusal, OSError, KeyError) as error:
        print(f"inputs/study/compression.py: {error}", file=sys.stderr)
        sys.exit(1)
