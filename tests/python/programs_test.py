# SPDX-License-Identifier: GPL-2.0-or-later
"""What liggghts and rodpack write is read: a small deposition with its analysis, chains in space."""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np
from support import PACKAGE, PROGRAMS, REPOSITORY, FileTest, rodpack

from rodpack import Run, read_dump, read_fields, read_json, read_table
from rodpack.orientation import long_axes, quaternions, rotate


def run_program(*words, cwd=None):
    done = subprocess.run(words, cwd=cwd, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        raise AssertionError(f"{words}: status {done.returncode}\n{done.stdout[-3000:]}")


def template_centres(body, mass_points):
    """Centres of a chain's spheres about its centre of mass, body frame, m, from its row of the dump.

    As the templates' page says: end centres l_axial - d apart along the centreline, the others evenly
    between; x parallel to the chord, the arc bulges to +y; the centre of mass is that of `mass_points` points
    evenly spaced on the same centreline.
    """
    length, theta = 2 * (body["half_length"] - body["radius"]), body["curvature"]
    if theta == 0:
        x = np.linspace(-length / 2, length / 2, int(body["nspheres"]))
        return np.stack([x, 0 * x, 0 * x], axis=1)
    radius = length / theta
    turn = np.linspace(-theta / 2, theta / 2, int(body["nspheres"]))
    height = np.mean(np.cos(np.linspace(-theta / 2, theta / 2, mass_points)))
    return radius * np.stack([np.sin(turn), np.cos(turn) - height, 0 * turn], axis=1)


class ProgramTest(FileTest):
    def check_spheres(self, bodies, spheres, aspect_ratio):
        """The template's spheres, turned by the body's quaternion, are the dumped ones. Positions below 1 m
        of 16 digits are added up: 1e-15 m."""
        self.assertGreater(bodies.rows, 0)
        self.assertEqual(spheres.rows, bodies["nspheres"].sum())
        size = np.ptp(bodies.box, axis=1)
        for body, q in zip(bodies.records(), quaternions(bodies)):
            turned = [body[name] for name in "xyz"] + rotate(q, template_centres(body, aspect_ratio(body)))
            mine = spheres["body"] == body["id"]
            apart = turned[:, np.newaxis] - spheres.stack("x", "y", "z")[mine]
            # Spheres stand inside the box, each by itself.
            apart -= size * np.round(apart / size) * bodies.periodic
            distance = np.linalg.norm(apart, axis=2)
            self.assertLess(distance.min(axis=0).max(), 1e-15)  # every sphere is one of the template's
            self.assertLess(distance.min(axis=1).max(), 1e-15)  # and every one of the template's a sphere
            self.assert_equal(spheres["radius"][mine], [body["radius"]] * mine.sum())

    def check_fields(self, fields, table, dimension):
        """The image holds what the table does, which has a column per component and prints 15 digits."""
        columns = set(table.names)
        shape = fields.count[dimension - 1::-1]
        places = np.meshgrid(*(getattr(fields, axis) for axis in "zyx"[3 - dimension:]), indexing="ij")
        for axis, place in zip("zyx"[3 - dimension:], places):
            # The place is counted from the origin in steps: the last of 16 digits may differ.
            np.testing.assert_allclose(table[f"{axis}_m"].reshape(shape), place, rtol=6e-15, atol=0)
            columns.remove(f"{axis}_m")
        for name, values in fields.items():
            parts = fields.components[name]
            self.assertEqual(values.shape, shape + ((len(parts),) if parts else ()), name)
            for k, part in enumerate(parts or [""]):
                value = values[..., k] if parts else values
                # contact_stress_N_m, xy: contact_stress_xy_N_m
                words = name.split("_")
                matching = columns & {"_".join(words[:at] + [part] * bool(part) + words[at:])
                                      for at in range(1, len(words) + 1)}
                if dimension == 2 and part == "z":
                    self.assertEqual(matching, set())
                    self.assert_equal(value, np.zeros(shape))
                    continue
                self.assertEqual(len(matching), 1, (name, part))
                column = matching.pop()
                columns.remove(column)
                self.assertEqual(table.words(column), [f"{each:.15g}" for each in value.ravel()], column)
        self.assertEqual(columns, set())


class InSpace(ProgramTest):
    def test_chains_lie_where_their_quaternions_say(self):
        run_program(PROGRAMS / "liggghts", "-log", "none", "-in",
                    REPOSITORY / "tests" / "python" / "in.mixture", cwd=self.folder)
        bodies = read_dump(self.folder / "bodies.dump.gz")
        spheres = read_dump(self.folder.glob("spheres.*.dump"))
        steps = []
        for body_frame, sphere_frame in zip(bodies, spheres):
            self.assertEqual(body_frame.step, sphere_frame.step)
            self.assertEqual((body_frame.kind, sphere_frame.kind), ("bodies", "spheres"))
            self.assertEqual(body_frame.periodic, (True, False, False))
            steps.append(body_frame.step)
            if body_frame.rows:
                # As in in.mixture: rods of AR 4, arcs of AR 5.
                self.check_spheres(body_frame, sphere_frame, lambda body: 5 if body["curvature"] else 4)
                # Both kinds, and orientations about all axes: an exchange of components shows.
                self.assertEqual(set(np.round(body_frame["curvature"], 12)), {0, round(np.pi / 2, 12)})
                self.assertTrue((np.abs(quaternions(body_frame)).max(axis=0) > 0.7).all())
        self.assertEqual(steps, [0, 100, 200, 300])

        contacts = read_dump(self.folder / "contacts.dump").last()
        self.assertEqual(contacts.kind, "contacts")
        self.assertGreater(contacts.rows, 0)
        normals = np.linalg.norm(contacts.stack("nx", "ny", "nz"), axis=1)
        np.testing.assert_allclose(normals, 1, rtol=0, atol=1e-14)

        fields = read_fields(self.folder / "fields.vti")
        self.check_fields(fields, read_table(self.folder / "fields.csv"), 3)
        self.assertEqual(fields.tensor("contact_stress_N_m2").shape, (5, 5, 5, 3, 3))
        self.assertAlmostEqual(fields.time, 300 * 1e-5, delta=1e-15)


class Deposition(ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.top = Path(tempfile.mkdtemp(prefix="rodpack-python-"))
        cls.addClassCleanup(shutil.rmtree, cls.top)
        for name, words in (("rods", ("output_interval", "0.2")), ("arcs", ("curvature", "90"))):
            run_program("env", f"LIGGGHTS={PROGRAMS / 'liggghts'}", "sh",
                        REPOSITORY / "inputs" / "deposition" / "run_one.sh", cls.top / name,
                        "-var", "preset", "quick", "-var", "particles", "60", "-var", *words)
            run_program(PROGRAMS / "rodpack", "analyse", cls.top / name)

    def test_dumps(self):
        for name in ("rods", "arcs"):
            run = Run(self.top / name)
            steps = [frame.step for frame in run.bodies]
            self.assertEqual(steps, [frame.step for frame in run.contacts])
            self.assertEqual(steps[-1], run.result["step"])
            bodies, spheres, contacts = run.bodies.last(), run.spheres.last(), run.contacts.last()
            self.assertEqual(bodies.rows, run.parameters["particles"])
            self.assertEqual((bodies.kind, spheres.kind, contacts.kind), ("bodies", "spheres", "contacts"))
            self.check_spheres(bodies, spheres, lambda _: run.parameters["aspect_ratio"])
            angle = bodies["angle"]
            in_plane = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
            np.testing.assert_allclose(long_axes(bodies), in_plane, rtol=0, atol=1e-14)
            # At rest the walls carry the weight: to 1e-2 of it, as settled as the run's end asks for.
            weight = bodies["mass"].sum() * run.parameters["gravity_m_s2"]
            walls = contacts["wall"] == 1
            self.assertAlmostEqual(contacts["fy"][walls].sum() / weight, 1, delta=1e-2)
            self.assertEqual(contacts.rows, run.result["contacts"])
            self.assert_equal(np.unique(contacts["body_j"][walls]), [0])

    def test_analysis(self):
        for name in ("rods", "arcs"):
            run = Run(self.top / name)
            self.check_fields(run.fields, run.table("fields"), 2)
            self.assertAlmostEqual(run.fields.time, run.summary["time_s"], delta=1e-12)
            energies = run.energies
            self.assertEqual(energies["step"][-1], run.result["step"])
            elastic = energies["elastic_normal_J"][-1] + energies["elastic_tangential_J"][-1]
            self.assertAlmostEqual(elastic / run.summary["elastic_energy_J"], 1, delta=1e-12)
            self.assertIn("rdf", run.tables)
            for table in run.tables:
                for column in run.table(table).values():
                    self.assertTrue(np.isfinite(column).all())

    def test_the_example_of_the_page_does_what_it_says(self):
        (self.folder / "results").mkdir()
        (self.folder / "results" / "quick").symlink_to(self.top / "rods")
        example = (PACKAGE / "README.md").read_text().split("```python\n")[1].split("```")[0]
        example += ("assert axes.shape == (60, 3) and peak > 0.9\n"
                    "assert pressure.shape == (fields.y.size, fields.x.size)\n")
        done = subprocess.run([sys.executable, "-B", "-c", example], cwd=self.folder,
                              env={**os.environ, "PYTHONPATH": str(PACKAGE)}, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertTrue(done.stdout.endswith(f"{Run(self.top / 'rods').result['step']} 60\n"), done.stdout)

    def test_every_cut_of_a_real_dump_is_noticed(self):
        file = Path(Run(self.top / "rods").contacts.files[-1])
        content = file.read_bytes()
        random = np.random.default_rng(1)
        for length in random.integers(len(content), size=200):
            cut = self.write("cut.dump", content[:length])
            with self.assertRaises(rodpack.FormatError):
                read_dump(cut).last()

    def test_ensemble(self):
        folders = [self.top / "rods", self.top / "arcs"]
        # Beds this low have no voids: the ensemble is there when the figures end.
        subprocess.run([PROGRAMS / "rodpack", "ensemble", *folders, "-o", self.folder],
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        curve = read_json(self.folder / "ensemble.json")["cases"]["smooth-AR5"]["curves"]["rdf"]["g"]
        table = read_table(self.folder / "smooth-AR5_rdf.csv")
        np.testing.assert_allclose(np.array(curve["mean"], float), table["g"], rtol=1e-9, atol=0)
        # A single run has no error: null there, nan in the table.
        self.assertTrue(np.isnan(np.array(curve["sem"], float)).all())
        self.assertTrue(np.isnan(table.numbers("g_sem", missing=True)).all())


if __name__ == "__main__":
    unittest.main()
