# SPDX-License-Identifier: GPL-2.0-or-later
"""A study whose runs take several MPI ranks: a test of its own, since it wants both of two cores. Ranks wait
for each other busily, and on cores that others use as well each of their hundred thousand steps waits for a turn."""

import unittest

from support import SMALL, StudyTest


class Ranks(StudyTest):
    def test_ranks_are_a_column(self):
        self.know_speed()
        self.write_table(SMALL + "cases:\n  rods: {aspect_ratio: 3, ranks: 2}\n")
        self.run_study("--runs-only")
        self.assertIn("2 by 1 by 1 MPI processor grid", (self.out / "logs/rods-seed-1.log").read_text())


if __name__ == "__main__":
    unittest.main()
