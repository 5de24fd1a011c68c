# SPDX-License-Identifier: GPL-2.0-or-later
"""A small grain on two large ones that are held: Vyas et al., Comput. Phys. Commun. 310, 109524 (2025).

Their case is LAMMPS's examples/granular/in.sync_verlet, at a ratio of sizes of 20.
"""
from math import acosh, atan2, cos, cosh, radians, sin, sinh, sqrt

import laws
from page import Table, fixed, number
from scene import OURS, PLAIN, STOCK, STOCK_BODY, sphere, spring_scene

LARGE, DENSITY, STIFFNESS, TANGENTIAL, FRICTION, RESTITUTION, GRAVITY = 0.005, 2500, 1e4, 8235, 0.5, 0.5, 9.81
FROM, TO = radians(1), radians(20)


def rolling_time(small, begin, end):
    """Seconds from one angle with the vertical to another, of a rigid grain that rolls on both large ones.

    Its centre moves on a circle of radius rho about the line of the large centres and turns about the line of
    the two contacts, at the distance rho r / (R + r) from its centre: with the angle phi,
    phi'^2 (rho^2 + 2/5 (R + r)^2) = 2 g rho (cos phi_0 - cos phi). With phi = phi_0 cosh(u) the integrand of
    dt = dphi / phi' is smooth; midpoint rule.
    """
    reach = LARGE + small
    rho = sqrt(reach**2 - LARGE**2)
    scale = 2 * GRAVITY * rho / (rho**2 + 0.4 * reach**2)
    last, steps = acosh(end / begin), 20000
    total = 0.0
    for n in range(steps):
        u = last * (n + 0.5) / steps
        phi = begin * cosh(u)
        total += begin * sinh(u) / sqrt(scale * (cos(begin) - cos(phi)))
    return total * last / steps


def roll(run, method, ratio, dt, longest):
    """Seconds until the grain has rolled to TO, and whether it has fallen off before `longest`."""
    small = LARGE / ratio
    rho = sqrt((LARGE + small)**2 - LARGE**2)
    mass = laws.sphere_mass(small, DENSITY)
    grain = sphere(y=rho * cos(FROM), z=rho * sin(FROM), radius=small, density=DENSITY)
    held = [sphere(x=x, radius=LARGE, density=DENSITY, frozen=1) for x in (-LARGE, LARGE)]
    every = max(1, round(longest / dt / 2000))
    scene = spring_scene([grain, *held], dt, round(longest / dt), every=every, kn=STIFFNESS, kt=TANGENTIAL,
                         eta_n=laws.damping_ratio_without_tension(RESTITUTION), mu=FRICTION, gy=-GRAVITY, walls=1,
                         floor=-0.02, half=0.15, skin=5e-3, effective_mass=mass)
    before, reached = None, None
    for t, states in run(scene, method):
        state = min(states, key=lambda s: s["radius"])
        angle = atan2(state["z"], state["y"])
        if angle > TO and reached is None:
            reached = before[0] + (TO - before[1]) / (angle - before[1]) * (t - before[0])
        before = t, angle
    return reached, state["y"] < -LARGE


def tables(run):
    rows = []
    for ratio in 3, 5, 7, 10, 20:
        small = LARGE / ratio
        exact = rolling_time(small, FROM, TO)
        step = laws.contact_time(STIFFNESS, laws.sphere_mass(small, DENSITY)) / 30
        found = []
        for method, dt in (OURS, step / 2), (OURS, step), (PLAIN, step), (STOCK, step), (STOCK, step * 30 / 100), \
                (STOCK_BODY, step):
            time, falls = roll(run, method, ratio, dt, 4 * exact)
            found.append(f"{number(time / exact - 1)}, {'falls' if falls else 'held'}")
        rows.append([f"{ratio}", None, fixed(exact, 5), *found])
    return [Table(
        "Vyas et al.: a small grain on two large ones",
        "A grain rolls off the top: time from 1° to 20°, s, its relative error, and whether the grain has fallen after "
        "four times as long. Two large ones of 1 cm are held side by side, k = 1e4 N/m, k_t = 8235 N/m, μ = 0.5, e = 0.5. "
        "Exact: rigid grain, no slip. Nothing holds the grain below; in velocity Verlet, whose springs add up velocities "
        "of half a step before in the plane of contact of now, it swings to and fro between the two for ever. Vyas et "
        "al. report that from a ratio of 3 on and give no times.",
        ["ratio", "Vyas et al.", "exact", "ours, 60 steps", "ours, 30 steps", "nve/sphere/ab, 30 steps",
         "nve/sphere, 30 steps", "nve/sphere, 100 steps", "multisphere, 30 steps"], rows)]
