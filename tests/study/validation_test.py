# SPDX-License-Identifier: GPL-2.0-or-later
"""inputs/study/results/validation.md: what validation.py makes of the results as they are."""

import csv
import subprocess
import sys
import unittest

from support import WORKFLOW


class Validation(unittest.TestCase):
    def setUp(self):
        self.page = (WORKFLOW / "results/validation.md").read_text(encoding="utf-8")

    def rows(self, file):
        with open(WORKFLOW / file, newline="", encoding="utf-8") as stream:
            return list(csv.DictReader(stream))

    def test_the_page_is_that_of_the_results(self):
        made = subprocess.run([sys.executable, "-B", WORKFLOW / "validation.py"], capture_output=True,
                              encoding="utf-8", check=True).stdout
        self.assertEqual(self.page, made, "make it again: python3 inputs/study/validation.py > "
                                          "inputs/study/results/validation.md")

    def test_every_claim_and_every_published_number_stands_on_it(self):
        lines = self.page.splitlines()
        for row in self.rows("results/reduced/claims.csv"):
            found = [line for line in lines if f"| {row['claim']} |" in line]
            self.assertEqual(len(found), 1, row["claim"])
            self.assertIn(row["verdict"], found[0])
        for row in self.rows("published.csv"):
            found = [line for line in lines
                     if line.startswith(f"| {row['case']} | {row['value']} ± {row['error']} |")]
            self.assertEqual(len(found), 2, row["case"])  # of either size

    def test_a_number_is_that_of_the_study(self):
        """By hand: smooth rods of AR 5 at the paper's size, one bed."""
        numbers = {(row["case"], row["number"]): row for row in self.rows("results/full/numbers.csv")}
        mean = float(numbers["smooth-AR5", "solid_fraction"]["mean"])
        line = next(line for line in self.page.splitlines() if line.startswith("| smooth-AR5 ")
                    and "| 9000 |" in line)
        self.assertIn(f"| {mean:.4f} | {mean - 0.85:+.3f} |", line)


if __name__ == "__main__":
    unittest.main()
