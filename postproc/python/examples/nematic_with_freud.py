# SPDX-License-Identifier: GPL-2.0-or-later
"""Nematic order of all rods of a run's last frame, by freud (glotzerlab's freud-analysis, 2 or 3).

  PYTHONPATH=postproc/python python3 postproc/python/examples/nematic_with_freud.py RUN

Ends with status 1 and says so where freud is not installed. freud's order parameter is the largest eigenvalue
S of <3/2 u u - 1/2>, u the long axes. Of axes in one plane S = 1/4 + 3/4 S_2, with S_2 = <cos 2 (gamma -
director)>, which rodpack gives (nematic_order_S2, where particles near the walls are left out): both are
printed, S_2 once from freud's S and once from the axes themselves.
"""

import sys

import numpy as np

import rodpack
from rodpack.orientation import long_axes, quaternions, to_freud

try:
    import freud
except ImportError:
    sys.exit("nematic_with_freud.py: the Python package 'freud' (freud-analysis) is not installed")


def freud_order(bodies, rods):
    """freud's nematic order parameter: freud 3 takes axes, freud 2 quaternions and the axis in the body."""
    if int(freud.__version__.split(".")[0]) >= 3:
        return freud.order.Nematic().compute(long_axes(bodies)[rods]).order
    return freud.order.Nematic([1, 0, 0]).compute(to_freud(quaternions(bodies))[rods]).order


def main(words):
    if len(words) != 1:
        sys.exit(__doc__)
    bodies = rodpack.Run(words[0]).bodies.last()
    rods = bodies["nspheres"] > 1
    if not rods.any():
        sys.exit(f"{bodies.file}: holds no rods, plain spheres alone")
    order = float(freud_order(bodies, rods))
    x, y, z = long_axes(bodies)[rods].T
    print(f"step {bodies.step}, {rods.sum()} rods: S = {order:.6f}")
    if np.abs(z).max() < 1e-6:
        # <exp 2 i gamma>: its modulus is S_2, half its argument the director.
        doubled = np.mean((x + 1j * y) ** 2)
        print(f"in one plane: S_2 = {(4 * order - 1) / 3:.6f} from it, {abs(doubled):.6f} from the axes, "
              f"director {np.degrees(np.angle(doubled)) / 2 % 180:.2f} degrees")


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except (OSError, LookupError, rodpack.FormatError) as error:
        sys.exit(f"nematic_with_freud.py: {error}")
