# SPDX-License-Identifier: GPL-2.0-or-later
"""inputs/tutorial/README.md: its blocks are put together and run in their order, as a reader would."""

import json
import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[2]
PAGE = REPOSITORY / "inputs/tutorial/README.md"
FILES = {"liggghts": "in.mine", "python": "flat.py"}


def blocks(text):
    """Pairs of the language and the lines of each fenced block."""
    return re.findall(r"^```(\w+)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)


class Tutorial(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp())
        cls.environment = dict(
            os.environ,
            # /usr/bin: Debian's python3, which has NumPy.
            PATH=os.pathsep.join((os.environ["RODPACK_BIN"], "/usr/bin", os.environ["PATH"])),
            RODPACK=str(REPOSITORY),
            PYTHONDONTWRITEBYTECODE="1",
        )
        cls.failures = []
        output = ""
        for language, text in blocks(PAGE.read_text(encoding="utf-8")):
            if language in FILES:
                with open(cls.folder / FILES[language], "a", encoding="utf-8") as file:
                    file.write(text)
            elif language == "sh":
                run = subprocess.run(
                    ["bash", "-e", "-c", text], cwd=cls.folder, env=cls.environment,
                    stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding="utf-8", check=False)
                output = run.stdout
                if run.returncode:
                    cls.failures.append(f"{text}ended with {run.returncode}:\n{output}")
            elif language == "text":
                cls.failures += [f"'{line}' is not in the output:\n{output}"
                                 for line in text.splitlines() if line not in output]
            else:
                cls.failures.append(f"a block of language '{language}', which nobody runs")

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def summary(self, run):
        return json.loads((self.folder / run / "analysis/summary.json").read_text(encoding="utf-8"))

    def test_every_step_does_what_the_page_says(self):
        self.assertEqual(self.failures, [])

    def test_there_are_steps_of_every_kind(self):
        languages = [language for language, _ in blocks(PAGE.read_text(encoding="utf-8"))]
        for language in ("liggghts", "sh", "text", "python"):
            self.assertIn(language, languages)

    def test_all_three_runs_have_their_walls_from_the_scene_and_are_mixtures(self):
        for run in ("walls", "engine", "periodic"):
            summary = self.summary(run)
            self.assertRegex(summary["walls_from"], run + r"/scene\.80000\.json$")
            self.assertEqual([kind["type"] for kind in summary["mixture"]], [1, 2])
            self.assertAlmostEqual(sum(kind["number_share"] for kind in summary["mixture"]), 1)
            self.assertAlmostEqual(summary["time_s"], 80000 * 2e-5)
            self.assertIsNotNone(summary["mobilised_friction_mean"])
            touching = summary["mixture"][0]["touching"]
            self.assertEqual(set(touching), {"rods-type1", "spheres-type2"})

    def test_periodic_sides_leave_no_rod_out_beside_them(self):
        """Only those near the floor are, so that a periodic bed counts more of its 60 rods."""
        walls, periodic = self.summary("walls"), self.summary("periodic")
        self.assertGreater(periodic["orientation_particles"], walls["orientation_particles"])
        self.assertFalse([note for note in periodic["notes"] if note.startswith("walls:")])

    def test_the_engine_makes_the_same_bed_as_the_spheres_do(self):
        """The same draws fall onto the same floor; contacts differ by rounding, beds by chance."""
        walls, engine = self.summary("walls"), self.summary("engine")
        self.assertIn("Planar engine", (self.folder / "engine.log").read_text(encoding="utf-8"))
        key = "covered_area_over_area_below_surface"
        self.assertAlmostEqual(walls[key], engine[key], delta=0.05)


if __name__ == "__main__":
    unittest.main()
