# SPDX-License-Identifier: GPL-2.0-or-later
"""Orientations of particles as unit quaternions.

Order: (w, x, y, z), as the columns qw qx qy qz of a dump of bodies; the quaternion turns vectors of the
body's own axes into those of space. The body's x axis is the long axis (of curved chains the chord between
the end centres), an arc bulges to the body's +y. q and -q are the same orientation.
"""

import numpy as np

from .errors import FormatError


def quaternions(bodies):
    """Unit quaternions of a frame of bodies, rows x 4, order (w, x, y, z), body to space.

    FormatError where a row's norm is off from 1 by more than 1e-3, which no rounding of a dump explains.
    """
    q = bodies.stack("qw", "qx", "qy", "qz")
    with np.errstate(over="ignore"):  # the square of 1e200: no unit quaternion, as is said below
        norm = np.linalg.norm(q, axis=1)
    bad = np.flatnonzero(np.abs(norm - 1) > 1e-3)
    if bad.size:
        raise FormatError(bodies.file, bodies.line + 1 + int(bad[0]),
                          "columns qw qx qy qz: expected a unit quaternion, found one of norm "
                          f"{norm[bad[0]]:.4g}")
    return q / norm[:, np.newaxis]


def multiply(p, q):
    """The rotation that turns by q first, then by p; order (w, x, y, z), shapes (..., 4)."""
    p, q = np.asarray(p, float), np.asarray(q, float)
    scalar = p[..., :1] * q[..., :1] - (p[..., 1:] * q[..., 1:]).sum(axis=-1, keepdims=True)
    vector = p[..., :1] * q[..., 1:] + q[..., :1] * p[..., 1:] + np.cross(p[..., 1:], q[..., 1:])
    return np.concatenate([scalar, vector], axis=-1)


def rotate(q, v):
    """Vectors v of the body's axes, (..., 3), in those of space; q (..., 4), order (w, x, y, z), unit."""
    q, v = np.asarray(q, float), np.asarray(v, float)
    # v + 2 w (u x v) + 2 u x (u x v), with q = (w, u): q v q* without the two products.
    once = 2 * np.cross(q[..., 1:], v)
    return v + q[..., :1] * once + np.cross(q[..., 1:], once)


def long_axes(bodies):
    """Unit vectors along the bodies' long axes in space, rows x 3. Plain spheres (nspheres 1) have none:
    theirs mean nothing."""
    return rotate(quaternions(bodies), [1.0, 0.0, 0.0])


def to_ovito(q):
    """Quaternions in the order of OVITO's property Orientation, (x, y, z, w), from (w, x, y, z)."""
    return np.roll(np.asarray(q, float), -1, axis=-1)


def to_freud(q):
    """Quaternions in freud's order, (w, x, y, z), which is that of the dumps: a copy."""
    return np.array(q, float)
