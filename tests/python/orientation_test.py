# SPDX-License-Identifier: GPL-2.0-or-later
"""Quaternions against closed forms of rotation, and the two examples for other programs."""

import os
import subprocess
import sys
import unittest

import numpy as np
from support import PACKAGE, FileTest, rodpack

from rodpack.orientation import long_axes, multiply, quaternions, rotate, to_freud, to_ovito

HALF = np.sqrt(0.5)


def about(axis, angle):
    """The quaternion (w, x, y, z) of a turn by `angle`, rad, about a unit axis."""
    return np.array([np.cos(angle / 2), *(np.sin(angle / 2) * np.asarray(axis, float))])


def matrix_of_scalar_last(q):
    """The rotation matrix of a quaternion (x, y, z, w), as the textbooks have it."""
    x, y, z, w = q
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def bodies_text(angles, q=None, curvature=0, step=3):
    """A dump of rods of 15 mm x 3 mm, a metre apart, at these angles about z, and of a plain sphere."""
    rows = ""
    for k, angle in enumerate(angles):
        each = about([0, 0, 1], angle) if q is None else q[k]
        rows += (f"{k + 1} 2 9 {k} 0.5 0 {angle!r} 0.25 0 0 {' '.join(map(repr, map(float, each)))} "
                 f"0.0075 0.0015 {curvature}\n")
    rows += f"{len(angles) + 1} 1 1 0.5 0.5 0 0 0 0 0 1 0 0 0 0.0015 0.0015 0\n"
    return (f"ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n{len(angles) + 1}\nITEM: BOX BOUNDS pp ff ff\n"
            "-1 9\n0 2\n-0.5 0.5\n"
            "ITEM: ATOMS id type nspheres x y z angle vx vy vz qw qx qy qz half_length radius curvature\n"
            + rows)


class Rotation(FileTest):
    def test_quarter_turns_take_each_axis_to_the_next(self):
        x, y, z = np.eye(3)
        for axis, start, end in ((x, y, z), (y, z, x), (z, x, y)):
            np.testing.assert_allclose(rotate([HALF, *(HALF * axis)], start), end, rtol=0, atol=1e-15)

    def test_any_turn_is_rodrigues_formula(self):
        # v cos a + (k x v) sin a + k (k . v)(1 - cos a)
        random = np.random.default_rng(1)
        for _ in range(100):
            axis, v, angle = random.standard_normal(3), random.standard_normal(3), random.uniform(-4, 4)
            axis /= np.linalg.norm(axis)
            expected = (v * np.cos(angle) + np.cross(axis, v) * np.sin(angle)
                        + axis * (axis @ v) * (1 - np.cos(angle)))
            np.testing.assert_allclose(rotate(about(axis, angle), v), expected, rtol=0, atol=1e-14)
            # Many at once are the same.
            many = rotate(np.stack([about(axis, angle)] * 2), v)
            np.testing.assert_allclose(many, [expected] * 2, rtol=0, atol=1e-14)

    def test_a_product_turns_by_its_second_factor_first(self):
        random = np.random.default_rng(2)
        p, q = random.standard_normal((2, 50, 4))
        p, q = (each / np.linalg.norm(each, axis=1)[:, np.newaxis] for each in (p, q))
        v = random.standard_normal((50, 3))
        np.testing.assert_allclose(rotate(multiply(p, q), v), rotate(p, rotate(q, v)), rtol=0, atol=1e-14)

    def test_orders_of_the_components(self):
        # OVITO: (x, y, z, w); freud, as the dumps: (w, x, y, z).
        self.assert_equal(to_ovito([[1, 2, 3, 4], [5, 6, 7, 8]]), [[2, 3, 4, 1], [6, 7, 8, 5]])
        self.assert_equal(to_freud([[1, 2, 3, 4]]), [[1, 2, 3, 4]])
        # The textbooks' matrix of the scalar-last quaternion turns as rotate() does.
        q = multiply(about([0, 0.6, 0.8], 0.7), about([1, 0, 0], -1.9))
        turned = matrix_of_scalar_last(to_ovito(q)) @ [1, 2, 3]
        np.testing.assert_allclose(turned, rotate(q, [1, 2, 3]), rtol=0, atol=1e-14)

    def test_long_axes_of_a_frame(self):
        angles = [0.3, 2.5, -1.0]
        frame = rodpack.read_dump(self.write("bodies.dump", bodies_text(angles))).last()
        expected = [[np.cos(angle), np.sin(angle), 0] for angle in angles]
        np.testing.assert_allclose(long_axes(frame)[:3], expected, rtol=0, atol=1e-15)

    def test_a_quaternion_that_is_none_is_refused(self):
        q = [about([0, 0, 1], 1), 1.01 * about([0, 0, 1], 1), np.zeros(4)]
        file = self.write("bodies.dump", bodies_text([1, 1, 1], q))
        self.refuses(lambda f: quaternions(rodpack.read_dump(f).last()), file, 11, "unit quaternion", "1.01")
        # What a dump of six digits rounds is made one again.
        q = [np.round(about([0, 0, 1], 1), 6)]
        frame = rodpack.read_dump(self.write("bodies.dump", bodies_text([1], q))).last()
        np.testing.assert_allclose(np.linalg.norm(quaternions(frame), axis=1), 1, rtol=0, atol=1e-15)


class Examples(FileTest):
    def run_example(self, name, *words, status=0, stand_in=None):
        """Runs an example for the run folder `run`. Returns what it printed."""
        path = [str(PACKAGE)]
        if stand_in is not None:
            path.insert(0, str(self.write("stand_in/freud.py", stand_in).parent))
        program = [sys.executable, "-B", PACKAGE / "examples" / name]
        done = subprocess.run([*program, self.folder / "run", *words], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True,
                              env={**os.environ, "PYTHONPATH": os.pathsep.join(path)})
        self.assertEqual(done.returncode, status, done.stdout)
        return done.stdout

    def test_capsules_for_ovito_lie_where_the_rods_do(self):
        angles = [0.3, 2.5, -1.0]
        self.write("run/dumps/bodies.3.dump", bodies_text(angles))
        self.write("run/dumps/bodies.9.dump", bodies_text([0.1], step=9))
        out = self.folder / "rods.xyz"
        self.assertEqual(self.run_example("capsules_for_ovito.py", out), "")
        lines = out.read_text().splitlines()
        self.assertEqual(len(lines), (2 + 4) + (2 + 2))
        self.assertEqual(lines[0], "4")
        self.assertIn('Lattice="10 0 0 0 2 0 0 0 1" Origin="-1 0 -0.5" pbc="T F F" Timestep=3', lines[1])
        self.assertIn("species:S:1:pos:R:3:orientation:R:4:aspherical_shape:R:3:velo:R:3:id:I:1", lines[1])
        for k, angle in enumerate(angles):
            words = lines[2 + k].split()
            self.assertEqual((words[0], words[-1]), ("2", str(k + 1)))
            x, q, shape, v = np.split(np.array(words[1:-1], float), [3, 7, 10])
            self.assert_equal(shape, [0.0015, 0.0015, 0.012])
            self.assert_equal(v, [0.25, 0, 0])
            # OVITO's capsule lies along its own z; the end centres of a rod are l_axial / 2 - r = 6 mm off.
            end = x + matrix_of_scalar_last(q) @ [0, 0, shape[2] / 2]
            np.testing.assert_allclose(end, [k + 0.006 * np.cos(angle), 0.5 + 0.006 * np.sin(angle), 0],
                                       rtol=0, atol=1e-15)
        self.assert_equal(np.array(lines[5].split()[8:11], float), [0.0015, 0.0015, 0])  # the plain sphere

    def test_bent_rods_are_no_capsules(self):
        self.write("run/dumps/bodies.3.dump", bodies_text([0.3]))
        self.write("run/dumps/bodies.4.dump", bodies_text([0.3], curvature=1.0, step=4))
        printed = self.run_example("capsules_for_ovito.py", self.folder / "rods.xyz", status=1)
        self.assertEqual(printed.count("\n"), 1, printed)
        self.assertIn("bodies.4.dump:9: expected straight particles", printed)
        self.assertEqual(list(self.folder.glob("rods*")), [])

    def test_an_example_without_dumps_says_so_in_a_line(self):
        (self.folder / "run").mkdir()
        stand_in = '__version__ = "3.4.0"\n'
        for name, words in (("nematic_with_freud.py", ()), ("capsules_for_ovito.py", ("rods.xyz",))):
            printed = self.run_example(name, *words, status=1, stand_in=stand_in)
            self.assertEqual(printed, f"{name}: {self.folder}/run/dumps/bodies.*.dump: no such file\n")

    def test_without_freud_the_example_says_so(self):
        self.write("run/dumps/bodies.3.dump", bodies_text([0.3]))
        printed = self.run_example("nematic_with_freud.py", status=1, stand_in="raise ImportError\n")
        self.assertEqual(printed, "nematic_with_freud.py: the Python package 'freud' (freud-analysis) is not "
                                  "installed\n")

    def test_nematic_order_with_a_stand_in_for_freud(self):
        # Debian has no freud: modules of its interface take its place, which compute the order as its pages
        # define it. Rods at 30 +- 20 degrees: S_2 = cos 40 degrees, director 30 degrees.
        order = """
import numpy as np
class _Order:
    def _of(self, u):
        q = 1.5 * np.mean(u[:, :, None] * u[:, None, :], axis=0) - 0.5 * np.eye(3)
        self.order = np.linalg.eigvalsh(q)[-1]
        return self
"""
        three = order + """
__version__ = "3.4.0"
class Nematic(_Order):
    def compute(self, orientations):
        assert orientations.shape == (4, 3)
        return self._of(orientations)
"""
        two = order + """
__version__ = "2.13.0"
class Nematic(_Order):
    def __init__(self, u):
        assert list(u) == [1, 0, 0]
    def compute(self, q):
        w, x, y, z = q.T
        return self._of(np.stack([1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)], axis=1))
"""
        self.write("run/dumps/bodies.3.dump", bodies_text(np.radians([50, 10, 230, 190]).tolist()))
        expected = np.cos(np.radians(40))
        for text in (three, two):
            printed = self.run_example("nematic_with_freud.py",
                                       stand_in=text + "\nclass order:\n    Nematic = Nematic\n")
            self.assertIn(f"step 3, 4 rods: S = {0.25 + 0.75 * expected:.6f}\n", printed)
            self.assertIn(f"S_2 = {expected:.6f} from it, {expected:.6f} from the axes, "
                          "director 30.00 degrees", printed)


if __name__ == "__main__":
    unittest.main()
