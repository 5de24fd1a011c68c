# SPDX-License-Identifier: GPL-2.0-or-later
"""Writes the particles of a run as capsules in a file that OVITO reads by itself (extended XYZ).

  PYTHONPATH=postproc/python python3 postproc/python/examples/capsules_for_ovito.py RUN FILE.xyz

All frames, straight rods and plain spheres. In OVITO: open the file, then Particles > Shape:
Spherocylinders; or, in OVITO's Python,

  from ovito.io import import_file
  from ovito.vis import ParticlesVis
  pipeline = import_file("FILE.xyz")
  pipeline.compute().particles.vis.shape = ParticlesVis.Shape.Spherocylinder
  pipeline.add_to_scene()

OVITO has no bent capsule: of curved particles open RUN/dumps/spheres.*.dump, which it reads as they are.
"""

import sys
from pathlib import Path

import numpy as np

import rodpack
from rodpack.orientation import multiply, quaternions, to_ovito

# OVITO's capsule lies along its own z axis, our rods along x: a quarter turn about y takes z to x.
Z_TO_X = (np.sqrt(0.5), 0, np.sqrt(0.5), 0)

# species, position, Orientation (x, y, z, w), Aspherical Shape (radius, unused, length without the caps), ...
PROPERTIES = "species:S:1:pos:R:3:orientation:R:4:aspherical_shape:R:3:velo:R:3:id:I:1"


def write_capsules(bodies, out):
    """Adds a frame to the open file `out`: lengths in m, velocities in m/s."""
    if (bodies["curvature"] > 0).any():
        raise rodpack.FormatError(bodies.file, bodies.line, "expected straight particles, found curved ones: "
                                  "OVITO has no bent capsule, open the spheres' dump in it")
    (x, y, z), size = bodies.box[:, 0], np.ptp(bodies.box, axis=1)
    flags = " ".join("T" if each else "F" for each in bodies.periodic)
    out.write(f'{bodies.rows}\nLattice="{size[0]:.16g} 0 0 0 {size[1]:.16g} 0 0 0 {size[2]:.16g}" '
              f'Origin="{x:.16g} {y:.16g} {z:.16g}" pbc="{flags}" Timestep={bodies.step} '
              f'Properties={PROPERTIES}\n')
    length = 2 * (bodies["half_length"] - bodies["radius"])
    shape = np.stack([bodies["radius"], bodies["radius"], length], axis=1)
    table = np.hstack([bodies.stack("x", "y", "z"), to_ovito(multiply(quaternions(bodies), Z_TO_X)), shape,
                       bodies.stack("vx", "vy", "vz")])
    for number, kind, row in zip(bodies["id"], bodies["type"], table):
        out.write(f"{kind} {' '.join(f'{value:.16g}' for value in row)} {number}\n")


def main(words):
    if len(words) != 2:
        sys.exit(__doc__)
    # Renamed when it is whole: a refusal in a later frame leaves no half of a file.
    target, part = Path(words[1]), Path(words[1] + ".part")
    try:
        with open(part, "w", encoding="ascii") as out:
            for bodies in rodpack.Run(words[0]).bodies:
                write_capsules(bodies, out)
        part.rename(target)
    except (OSError, rodpack.FormatError) as error:
        sys.exit(f"capsules_for_ovito.py: {error}")
    finally:
        part.unlink(missing_ok=True)


if __name__ == "__main__":
    main(sys.argv[1:])
