# SPDX-License-Identifier: GPL-2.0-or-later
"""inputs/study/compression.py on made-up maps whose line is known."""

import json
import subprocess
import sys
import unittest

from support import WORKFLOW, StudyTest

LENGTH, WIDTH, HEIGHT = 0.015, 0.3, 0.9  # AR d_p, m
NAMES = "x_m,y_m,solid_fraction,contact_stress_xx_N_m,contact_stress_yy_N_m"


class Compression(StudyTest):
    def write_run(self, case, seed, height=HEIGHT):
        """In the slice phi = 0.8 + 0.002 P where the line counts; elsewhere something else."""
        run = self.out / "runs" / case / f"seed-{seed}"
        (run / "analysis").mkdir(parents=True)
        (run / "result.json").write_text("{}")
        (run / "parameters.json").write_text(json.dumps(
            {"aspect_ratio": 5, "particle_diameter_m": 0.003, "container_width_m": WIDTH}))
        (run / "analysis" / "summary.json").write_text(json.dumps({"bed_height_m": height}))
        rows = [NAMES]
        for i in range(41):
            for k in range(81):
                x, y = WIDTH * i / 40, height * k / 80
                pressure = 30 * (1 - y / height)
                inside = abs(x - WIDTH / 2) < LENGTH + 1e-9 and 9 * LENGTH <= y <= height - 9 * LENGTH
                fraction = 0.8 + 0.002 * pressure if inside else 0.3
                rows.append(f"{x:.9g},{y:.9g},{fraction:.12g},{0.6 * pressure:.12g},{1.4 * pressure:.12g}")
        (run / "analysis" / "fields.csv").write_text("\n".join(rows) + "\n")

    def compression(self):
        return subprocess.run([sys.executable, "-B", WORKFLOW / "compression.py", self.out],
                              capture_output=True, text=True, check=False)

    def test_the_line_of_each_run_is_found_in_the_slice(self):
        self.write_run("coarse-AR5", 1)
        self.write_run("coarse-AR5", 2)
        done = self.compression()
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = done.stdout.splitlines()
        self.assertEqual([line.split(",")[:2] for line in lines[1:]], [["coarse-AR5", "1"], ["coarse-AR5", "2"]])
        numbers = dict(zip(lines[0].split(",")[2:], map(float, lines[1].split(",")[2:])))
        self.assertAlmostEqual(numbers["solid_fraction_without_pressure"], 0.8, places=9)
        self.assertAlmostEqual(numbers["rise_m_N"], 0.002, places=9)
        # The middle of the bed is the middle of the heights that count.
        self.assertAlmostEqual(numbers["pressure_N_m"], 15, delta=0.3)
        self.assertAlmostEqual(numbers["solid_fraction"], 0.8 + 0.002 * numbers["pressure_N_m"], places=4)

    def test_a_bed_that_is_too_low_and_a_folder_without_runs_are_refused(self):
        self.out.mkdir()
        done = self.compression()
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("no finished run, expected the folder of a study", done.stderr)
        self.write_run("rods", 1, height=0.2)
        done = self.compression()
        self.assertEqual(done.returncode, 1)
        self.assertIn("the bed is 0.2 m high, expected more than 6 omega, 0.27 m", done.stderr)


if __name__ == "__main__":
    unittest.main()
