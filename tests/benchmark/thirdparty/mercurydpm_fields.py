# SPDX-License-Identifier: GPL-2.0-or-later
"""MercuryDPM's unit tests of coarse graining (Drivers/UnitTests/CG*UnitTest.cpp), by `compute
stress/goldhirsch` and, in the plane, `rodpack stress`.

MercuryDPM averages over the whole box ("unresolved"), over planes (resolved in one direction), or about a
point. Here a grid in space, fine and wide enough for the Gaussian, is summed over all its places, or over a
plane of them: by Poisson's summation formula such a sum is the integral but for exp(-2 pi^2 (scale /
spacing)^2), 1e-15 here.
"""
from collections import namedtuple
from math import pi, sqrt
from pathlib import Path

import laws
from page import Table
from scene import read_table

STIFFNESS, SCALE = 2e5, 0.15
SPACING = 0.75 * SCALE
TOLERANCE = 1e-15  # of the compute: the share of the Gaussian beyond its cut-off, at 8.5 scales
MASS_1 = 0.75 / pi  # density of a sphere of radius 1 that has the mass 1

# `bound`: MercuryDPM's, of its own; `own`: LIGGGHTS's `compute stress/atom`.
Row = namedtuple("Row", "what measure bound exact ours rodpack own", defaults=(None, None))


def ball(x=0.0, y=0.0, z=0.0, vx=0.0, diameter=2.0, density=MASS_1):
    return dict(x=x, y=y, z=z, vx=vx, diameter=diameter, density=density)


def density(row):
    return row["mass_density_kg_m3"]


def trace(row):
    return sum(row[f"contact_stress_{a}{a}_N_m2"] for a in "xyz")


def exactly(scale, dimension):
    return f"scale {scale!r} dimension {dimension} tolerance {TOLERANCE} line exact"


def grid(middle, steps):
    """Arguments of a grid with a place in `middle`, `steps` spacings to either side."""
    box = " ".join(f"{m - n * SPACING!r} {m + n * SPACING!r}" for m, n in zip(middle, steps))
    return f"{exactly(SCALE, len(middle))} spacing {SPACING} box {box}"


def total(rows, of, where=None):
    """Sum over all places, or over those at one y, times the part of space that belongs to each."""
    dimension = 3 if "z_m" in rows[0] else 2
    if where is None:
        return sum(of(row) for row in rows) * SPACING**dimension
    return sum(of(row) for row in rows if abs(row["y_m"] - where) < 0.01 * SPACING) * SPACING**(dimension - 1)


class Pair:
    """CGParticleParticleUnitTest, its z along our y: spheres of radius and mass 1 overlap, box 2 x 4 x 2."""

    centre = 0.05, 0.95  # of one; the other is opposite
    balls = [ball(-0.05, -0.95), ball(0.05, 0.95)]
    distance = 2 * sqrt(0.05**2 + 0.95**2)
    moment = STIFFNESS * (2 - distance) * distance  # f r
    # A plane between the centres, its distances from them, and the trace of its stress.
    plane = 0.95 - 8 * SPACING
    crossing = moment / 1.9 * laws.gaussian_between(SCALE, plane + 0.95, 0.95 - plane)


def two_particles(run):
    radius = 0.15  # of Lucy's kernel
    lucy = f"scale {radius / laws.KERNEL_RADIUS['lucy', 3]!r} dimension 3 kernel lucy point"
    found, virial, _ = run.fields(Pair.balls, dict(
        space=grid((*Pair.centre, 0.0), (12, 28, 12)),
        lucy_at=f"{lucy} 0.05 0.95 0", lucy_between=f"{lucy} 0 0 0",
        cut_at=f"scale {SCALE} dimension 3 cutoff 3 point 0.05 0.95 0",
        gauss_between=f"{exactly(SCALE, 3)} point 0 0 0"), kn=STIFFNESS)
    space, force = found["space"], Pair.moment / Pair.distance
    return [
        Row("two particles", "mass / box", 1e-15, 2 / 16, total(space, density) / 16),
        Row("", "density of the plane through a centre, Gaussian", 1e-15, laws.gaussian_peak(SCALE, 1) / 4,
            total(space, density, Pair.centre[1]) / 4),
        Row("", "density at a centre, Lucy", 1e-11, laws.KERNEL_PEAK["lucy", 3] / radius**3,
            density(found["lucy_at"][0])),
        Row("", "density at a centre, Gaussian cut at 3 ω", None, laws.gaussian_peak(SCALE, 3, 3),
            density(found["cut_at"][0])),
        Row("", "trace of the stress / box", 1e-11, Pair.moment / 16, total(space, trace) / 16,
            own=-virial / 16),
        Row("", "trace of a plane between the centres", 1e-11, Pair.crossing / 4,
            total(space, trace, Pair.plane) / 4),
        Row("", "trace at the contact, Lucy", None, force * laws.LUCY_LINE / radius**2,
            trace(found["lucy_between"][0])),
        Row("", "trace at the contact, Gaussian", None, force * laws.gaussian_line(SCALE, Pair.distance),
            trace(found["gauss_between"][0]))]


def two_in_the_plane(run):
    """The same two in the plane, in the run and from its dumps by `rodpack stress`."""
    steps = 12, 28
    window = [m + sign * n * SPACING for m, n in zip(Pair.centre, steps) for sign in (-1, 1)]
    words = ["stress", "bodies.dump", "--scale", SCALE, "--spacing", SPACING, "--tolerance", TOLERANCE,
             "--line", "exact", "--walls", -4, 4, -4, "--window", *window]

    def after(folder):
        run.execute([run.program.with_name("rodpack"), *map(str, words)], folder, "rodpack")
        return read_table(Path(folder, "stress.csv"))

    found, _, afterwards = run.fields(Pair.balls, dict(plane=grid(Pair.centre, steps)), after, kn=STIFFNESS)

    def of_area(row):
        return row["mass_density_kg_m2"]

    def in_plane(row):
        return row["contact_stress_xx_N_m"] + row["contact_stress_yy_N_m"]

    measures = (("mass / area", of_area, None, 2 / 8, 8),
                ("density of the line through a centre", of_area, Pair.centre[1],
                 laws.gaussian_peak(SCALE, 1) / 2, 2),
                ("trace of the stress / area", in_plane, None, Pair.moment / 8, 8),
                ("trace of a line between the centres", in_plane, Pair.plane, Pair.crossing / 2, 2))
    return [Row("" if n else "two in the plane", name, None, exact,
                *(total(rows, of, where) / size for rows in (found["plane"], afterwards)))
            for n, (name, of, where, exact, size) in enumerate(measures)]


def particle_and_wall(run):
    """CGParticleWallUnitTest, upright: the contact point is half an overlap behind the wall there, too."""
    height = sqrt(0.05**2 + 0.95**2)
    overlap = 1 - height
    force, branch, plane = STIFFNESS * overlap, height + 0.5 * overlap, height - 4 * SPACING
    crossing = force * laws.gaussian_between(SCALE, plane + 0.5 * overlap, height - plane)
    found, virial, _ = run.fields([ball(y=height)], dict(space=grid((0.0, height, 0.0), (12, 24, 12))),
                                  kn=STIFFNESS, floor=1)
    space = found["space"]
    return [
        Row("particle and wall", "trace of the stress / box", 1e-11, force * branch / 16,
            total(space, trace) / 16, own=-virial / 16),
        Row("", "trace of a plane between centre and wall", 1e-11, crossing / 4,
            total(space, trace, plane) / 4),
        Row("", "force of the wall, N", None, force,
            total(space, lambda r: r["boundary_force_density_y_N_m3"]))]


def packing(run):
    """CG3DPackingUnitTest: 5^3 spheres of mass 1 on a cubic lattice, periodic, all forces 1."""
    distance, number = 0.99, 5
    half, spacing = 0.5 * number * distance, 0.25 * distance
    places = [(n + 0.5) * distance - half for n in range(number)]
    balls = [ball(x, y, z, diameter=1.0, density=6 / pi) for x in places for y in places for z in places]
    # One period of the lattice is a period of its fields.
    period = " ".join([f"{-half!r} {distance - half - spacing!r}"] * 3)
    words = f"{exactly(0.5 * distance, 3)} spacing {spacing!r} box {period}"
    found, virial, _ = run.fields(balls, dict(space=words), kn=100, half=half, periodic=1)
    rows, volume = found["space"], (2 * half)**3
    results = [Row("lattice", "density", 1e-10, number**3 / volume, sum(map(density, rows)) / len(rows))]
    for a in "xyz":
        stress = sum(row[f"contact_stress_{a}{a}_N_m2"] for row in rows) / len(rows)
        results.append(Row("", f"stress {a}{a}", 1e-10, number**3 * distance / volume, stress,
                           own=-virial / 3 / volume if a == "x" else None))
    return results


def kernels(run):
    """CGStandardDeviationUnitTest: radii of kernels of standard deviation 1, from their value in the middle.

    MercuryDPM's standard deviation is that of the distance, sqrt(D) times that along an axis.
    """
    rows = []
    for (kernel, dimension), exact in sorted(laws.KERNEL_RADIUS.items()):
        words = f"scale 1 dimension {dimension} kernel {kernel} point" + " 0" * dimension
        found, _, _ = run.fields([ball()], dict(at=words))
        peak = found["at"][0][f"number_density_1_m{dimension}"]
        rows.append(Row("" if rows else "radius of the kernel", f"{kernel}, {dimension} dimensions", 1e-11,
                        exact, (laws.KERNEL_PEAK[kernel, dimension] / peak)**(1 / dimension)))
    return rows


def moving(run):
    """What a single moving sphere has, at its centre."""
    speed = 3.0
    found, _, _ = run.fields([ball(vx=speed)], dict(at=f"{exactly(SCALE, 3)} point 0 0 0"))
    row = found["at"][0]
    return [Row("one particle", "momentum density at its centre", None, speed * laws.gaussian_peak(SCALE, 3),
                row["momentum_density_x_kg_m2_s"]),
            Row("", "velocity", None, speed, row["velocity_x_m_s"])]


def column(run):
    """Three spheres of mass 1 that stand on a floor under g: a contact carries what is above it.

    A plane at the height y is crossed by the force of each contact as far as the Gaussian about y lies
    between the ends of its branch.
    """
    gravity, heights, contacts, y = 9.81, [], [], 0.0
    for above in 3, 2, 1:
        overlap = above * gravity / STIFFNESS
        y += (2 if heights else 1) - overlap
        contacts.append((above * gravity, heights[-1] if heights else -0.5 * overlap, y))
        heights.append(y)
    places = grid((0.0, heights[1], 0.0), (12, 38, 12))
    found, virial, _ = run.fields([ball(y=h) for h in heights], dict(space=places), kn=STIFFNESS, floor=1,
                                  half=10)
    results = []
    for name, steps in ("between first and second", -8), ("at the height of the second", 0), ("above it", 8):
        plane = heights[1] + steps * SPACING
        exact = sum(f * laws.gaussian_between(SCALE, plane - low, high - plane) for f, low, high in contacts)
        results.append(Row("" if results else "column of three", f"force through a plane {name}, N", None,
                           exact, total(found["space"], lambda r: r["contact_stress_yy_N_m2"], plane)))
    results.append(Row("", "trace of the stress, J", None, sum(f * (high - low) for f, low, high in contacts),
                       total(found["space"], trace), own=-virial))
    return results


SCENES = two_particles, two_in_the_plane, particle_and_wall, packing, kernels, moving, column


def tables(run):
    rows = [[row.what, row.measure, row.bound and f"{row.bound:.0e}, its bound", f"{row.exact:.8g}",
             *(None if f is None else f / row.exact - 1 for f in (row.ours, row.rodpack, row.own))]
            for scene in SCENES for row in scene(run)]
    return [Table(
        "MercuryDPM: coarse graining of a few particles",
        "Relative errors. MercuryDPM's checks of density and stress of two particles, of one at a wall, of "
        "a periodic cubic lattice of 125 and of its kernels' widths, with its numbers (radius 1 m, mass 1 "
        "kg, 2e5 N/m, kernels 0.15 m wide), each against the closed form; the plane's measures, the moving "
        "particle and the column on its floor (g = 9.81 m/s²) are added. Averages over the box, a plane or "
        "a line are sums of the fields over a grid, which for the Gaussian are exact. Ours meets "
        "MercuryDPM's (absolute) bounds, that of the second row to the 15 digits of its file; the column "
        "is exact to the rounding of its overlaps of 5e-5 m. At a wall the branch ends half an overlap "
        "behind it, as MercuryDPM's does. Beside it LIGGGHTS's own `compute stress/atom`, which has the "
        "whole box alone and leaves walls out.",
        ["scene", "", "MercuryDPM", "exact", "compute stress/goldhirsch", "rodpack stress",
         "compute stress/atom, summed"], rows)]
