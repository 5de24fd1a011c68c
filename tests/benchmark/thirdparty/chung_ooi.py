# SPDX-License-Identifier: GPL-2.0-or-later
"""Chung and Ooi, Granular Matter 13, 643 (2011): tests 1 to 7, with LIGGGHTS's own Hertz model.

Materials and velocities of tests 1 to 4 as in YADE's scripts of them. Test 4 is MFiX's DEM05 with Hertz's law, too.
"""
from math import cos, radians, sin, sqrt

import laws
from page import Table, fixed
from scene import OURS, ORDER_4, PLAIN, STOCK, STOCK_BODY, sphere

METHODS = [(m._replace(law="hertz"), steps) for m, steps in (
    (OURS, 30), (OURS, 100), (ORDER_4, 30), (PLAIN, 30), (STOCK, 30), (STOCK_BODY, 30))]
NAMES = ["multisphere/ab, 30 steps", "multisphere/ab, 100 steps", "multisphere/ab order 4, 30 steps",
         "nve/sphere/ab, 30 steps", "nve/sphere, 30 steps", "multisphere, 30 steps"]

# LIGGGHTS's own tangential model, and ours, under the integrators.
METHODS_OBLIQUE = [(m._replace(law=law), steps) for m, law, steps in (
    (OURS, "hertz_spring", 30), (OURS, "hertz_spring", 100), (OURS, "hertz", 30), (OURS, "hertz", 100),
    (PLAIN, "hertz", 30), (STOCK, "hertz", 30), (STOCK_BODY, "hertz", 30))]
NAMES_OBLIQUE = ["multisphere/ab, tangential spring_dashpot, 30 steps", "the same, 100 steps",
                 "multisphere/ab, tangential history, 30 steps", "the same, 100 steps",
                 "nve/sphere/ab, history, 30 steps", "nve/sphere, history, 30 steps",
                 "multisphere, history, 30 steps"]


def impact(run, method, steps_per_contact, contact, radius, density, young, poisson, speed, restitution, pair):
    """Errors of overlap (over the steps), of duration (from the motion in flight) and the rebound speed."""
    dt = contact / steps_per_contact
    gap = 3.37 * speed * dt
    ball = dict(radius=radius, density=density)
    spheres = [sphere(y=radius + gap, vy=-speed, **ball)]
    if pair:
        spheres = [sphere(x=side * (radius + gap / 2), vx=-side * speed / 2, **ball) for side in (-1, 1)]
    scene = dict(spheres=spheres, dt=dt, steps=round(2.5 * steps_per_contact) + 20, young=young, poisson=poisson,
                 restitution=restitution, walls=0 if pair else 1, half=20 * radius, skin=radius)
    distances, frames = [], run(scene, method)
    for t, states in frames:
        if pair:
            distances.append((t, states[1]["x"] - states[0]["x"] - 2 * radius, states[1]["vx"] - states[0]["vx"]))
        else:
            distances.append((t, states[0]["y"] - radius, states[0]["vy"]))
    t, distance, rebound = distances[-1]
    duration = t - distance / rebound - gap / speed
    return max(-d for _, d, _ in distances), duration, rebound


def normal(run):
    rows = []
    # Test 1: two equal spheres; test 2: a sphere on a rigid plane (LIGGGHTS's wall has the sphere's own modulus).
    for test, material, pair, radius, density, young, poisson, speed in (
            (1, "glass", True, 0.01, 2800, 4.8e10, 0.20, 20.0),
            (2, "aluminium alloy", False, 0.1, 2699, 7.0e10, 0.30, 0.2)):
        mass = laws.sphere_mass(radius, density)
        # Two moduli in series; a rigid plane leaves that of the sphere, so the wall's share is made up for here.
        reduced = young / (1 - poisson**2) / (2 if pair else 1)
        given = young if pair else 2 * young
        contact, overlap = laws.hertz_duration(radius / 2 if pair else radius, mass / 2 if pair else mass, reduced,
                                               speed)
        found = [impact(run, method, steps, contact, radius, density, given, poisson, speed, 1.0, pair)
                 for method, steps in METHODS]
        rows.append([f"{test}", material, "largest overlap, m", None, f"{overlap:.5e}",
                     *(f[0] / overlap - 1 for f in found)])
        rows.append([f"{test}", material, "duration, s", None, f"{contact:.5e}",
                     *(f[1] / contact - 1 for f in found)])
        rows.append([f"{test}", material, "rebound speed, m/s", None, f"{speed}",
                     *(f[2] / speed - 1 for f in found)])
    # Test 3: aluminium oxide on a plane at 3.9 m/s. LIGGGHTS's damping aims at e for a contact with tension.
    for restitution in 0.8, 0.4:
        radius, density, young, poisson, speed = 0.0025, 4000, 3.8e11, 0.23, 3.9
        mass = laws.sphere_mass(radius, density)
        contact, _ = laws.hertz_duration(radius, mass, young / (1 - poisson**2) / 2, speed)
        found = [impact(run, method, steps, contact, radius, density, young, poisson, speed, restitution, False)
                 for method, steps in METHODS]
        rows.append(["3", "aluminium oxide", f"rebound at e = {restitution}, m/s", None,
                     fixed(restitution * speed, 2), *(f[2] / (restitution * speed) - 1 for f in found)])
    return Table(
        "Chung and Ooi: Hertz's law of LIGGGHTS, tests 1 to 3",
        "Relative errors. `model hertz` of LIGGGHTS under the integrators; events are those of `spring_dashpot` "
        "alone, so that `multisphere/ab` follows none here. Closed form of the undamped impact; the overlap is the "
        "largest of the steps, up to 0.1 % below that in between at 30 steps. Test 3: LIGGGHTS's dashpot aims at e "
        "for a contact that may pull; cut off where it would (`limitForce`), it rebounds faster, whatever the "
        "integrator. Chung and Ooi print curves; their other materials give the same numbers, since the impact has "
        "no other scale.",
        ["test", "material", "", "published", "exact", *NAMES], rows)


def oblique(run):
    radius, density, friction, speed = 2.5e-3, 4000, 0.092, 3.9
    mass = laws.sphere_mass(radius, density)
    # Aluminium oxide on a glass wall: 1/E* and 1/G* add up. One material on itself with the same E* and G*, since
    # then G*/E* = (1 - nu) / 2 (2 - nu).
    materials = (3.8e11, 0.23), (7.0e10, 0.25)
    modulus = 1 / sum((1 - nu**2) / young for young, nu in materials)
    shear = 1 / sum(2 * (2 - nu) * (1 + nu) / young for young, nu in materials)
    ratio = shear / modulus
    poisson = (1 - 4 * ratio) / (1 - 2 * ratio)
    young = 2 * modulus * (1 - poisson**2)
    kn = 4 / 3 * modulus * sqrt(radius)
    rows = []
    for degrees, peer in (5, 20.2515), (10, 208.3846), (20, 510.5268), (30, 618.3861), (45, 505.2858), (60, 357.6565):
        across, along = speed * cos(radians(degrees)), speed * sin(radians(degrees))
        contact, _ = laws.hertz_duration(radius, mass, modulus, across)
        exact = -laws.ObliqueImpact(radius, mass, kn, 8 * shear * sqrt(radius), friction, across, along,
                                    exponent=0.5, duration=contact).spin
        own = -laws.ObliqueImpact(radius, mass, kn, 8 * shear * sqrt(radius), friction, across, along,
                                  lever=lambda r, d: r - d, exponent=0.5, duration=contact).spin
        errors = []
        for method, steps in METHODS_OBLIQUE:
            dt = contact / steps
            ball = sphere(y=radius + 3.37 * dt * across, vy=-across, vx=along, radius=radius, density=density)
            count = round(1.5 * steps) + 20
            scene = dict(spheres=[ball], dt=dt, steps=count, every=count, young=young, poisson=poisson,
                         restitution=1.0, mu=friction, walls=1, half=0.05, skin=radius)
            errors.append(-run(scene, method)[-1][1][0]["omegaz"] / exact - 1)
        rows.append([f"{degrees}°", fixed(own, 3), peer / own - 1, fixed(exact, 3), *errors])
    return Table(
        "Chung and Ooi's test 4, MFiX's DEM05: oblique impacts under Hertz's law",
        "Spin after the rebound, rad/s, and its relative error. Aluminium oxide on glass, 3.9 m/s, μ = 0.092, no "
        "dashpots. MFiX's lever is r − δ, LIGGGHTS's r − δ/2: each has a converged solution of its own.",
        ["angle", "lever r − δ", "MFiX: error", "lever r − δ/2", *NAMES_OBLIQUE], rows)


def spinning(run):
    radius, density, young, poisson, friction, speed = 0.1, 2699, 7e10, 0.3, 0.4, 0.2
    mass = laws.sphere_mass(radius, density)
    modulus, shear = 0.5 * young / (1 - poisson**2), 0.25 * young / (2 - poisson) / (1 + poisson)
    unit = friction * speed
    rows = []
    for test, ratio in [(test, ratio) for test in (5, 6, 7) for ratio in (1, 3, 6)]:
        pair = test == 7
        along, surface = (ratio * unit, 0.0) if test == 5 else (0.0, ratio * unit)
        # Two equal spheres that close at `speed` and turn alike, at half the slip each, are one sphere of half the mass.
        curvature, moving = (0.5 * radius, 0.5 * mass) if pair else (radius, mass)
        contact, _ = laws.hertz_duration(curvature, moving, modulus, speed)
        rebound = laws.ObliqueImpact(radius, moving, 4 / 3 * modulus * sqrt(curvature), 8 * shear * sqrt(curvature),
                                     friction, speed, along, spin=surface / radius, exponent=0.5, duration=contact)
        exact = (rebound.velocity + radius * rebound.spin) / unit
        errors = []
        for method, steps in METHODS_OBLIQUE:
            dt = contact / steps
            gap, ball = 3.37 * dt * speed, dict(radius=radius, density=density)
            spheres = [sphere(y=radius + gap, vy=-speed, vx=along, wz=surface / radius, **ball)]
            if pair:
                spheres = [sphere(x=side * (radius + gap / 2), vx=-side * speed / 2, wz=surface / radius / 2, **ball)
                           for side in (-1, 1)]
            count = round(1.5 * steps) + 20
            scene = dict(spheres=spheres, dt=dt, steps=count, every=count, young=young, poisson=poisson,
                         restitution=1.0, mu=friction, walls=0 if pair else 1, half=1, skin=radius)
            states = run(scene, method)[-1][1]
            slip = states[0]["vx"] + radius * states[0]["omegaz"]
            if pair:
                slip = states[0]["vy"] - states[1]["vy"] + radius * (states[0]["omegaz"] + states[1]["omegaz"])
            errors.append(slip / unit - exact)
        rows.append([f"{test}", f"{ratio}", None, fixed(exact, 5), *errors])
    return Table(
        "Chung and Ooi's tests 5 to 7: one normal speed, other slips",
        "Slip of the surface after the rebound over μ v_n, and its error. Test 5: a sphere that moves along the plane, "
        "6: one that spins, 7: two equal ones that spin. Aluminium alloy of test 2, μ = 0.4, 0.2 m/s. Chung and Ooi "
        "print curves for other materials; the impact has no other scales than this slip and Poisson's ratio. Test 8 "
        "has two unequal spheres.",
        ["test", "slip before / μ v_n", "published", "converged", *NAMES_OBLIQUE], rows)


def tables(run):
    return [normal(run), oblique(run), spinning(run)]
