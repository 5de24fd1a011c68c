# SPDX-License-Identifier: GPL-2.0-or-later
"""Chung and Ooi, Granular Matter 13, 643 (2011): tests 1 to 8, with LIGGGHTS's own Hertz model.

Materials and velocities of tests 1 to 4 as in YADE's scripts of them, of test 8 as in PySPH's. Test 4 is
MFiX's DEM05 with Hertz's law, too.
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
    # Test 3: aluminium oxide on a plane at 3.9 m/s. The dashpot told e = 0.4 gives that to a contact that may
    # pull.
    for told in 0.8, 0.4, laws.hertz_input_for(0.4):
        radius, density, young, poisson, speed = 0.0025, 4000, 3.8e11, 0.23, 3.9
        mass = laws.sphere_mass(radius, density)
        contact, _ = laws.hertz_duration(radius, mass, young / (1 - poisson**2) / 2, speed)
        exact = laws.hertz_restitution(told) * speed
        found = [impact(run, method, steps, contact, radius, density, young, poisson, speed, told, False)
                 for method, steps in METHODS]
        rows.append(["3", "aluminium oxide", f"rebound, told e = {told:.4g}, m/s", None, fixed(exact, 4),
                     *(f[2] / exact - 1 for f in found)])
    return Table(
        "Chung and Ooi: Hertz's law of LIGGGHTS, tests 1 to 3",
        "Relative errors. `model hertz` of LIGGGHTS under the integrators; events are those of "
        "`spring_dashpot` alone, so that `multisphere/ab` follows none here. Closed form of the undamped "
        "impact; the overlap is the largest of the steps, up to 0.1 % below that in between at 30 steps. "
        "Test 3: LIGGGHTS's dashpot aims at e for a contact that may pull; cut off where it would "
        "(`limitForce`), it rebounds with the closed form of Schwager and Pöschel, e' = exp(−2 η acos η / "
        "√(1 − η²)), η of e = exp(−π η / √(1 − η²)), for Hertz's law as for the linear one: 3.15 and 1.84 "
        "m/s where 3.12 and 1.56 were asked. The last row asks for 0.304 to have 0.4. Chung and Ooi print "
        "curves; their other materials give the same numbers, since the impact has no other scale.",
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


# Aluminium alloy of tests 2 and 5 to 8, and their normal speed.
ALLOY = dict(radius=0.1, density=2699)
YOUNG, POISSON, FRICTION, SPEED = 7e10, 0.3, 0.4, 0.2
MODULUS, SHEAR = 0.5 * YOUNG / (1 - POISSON**2), 0.25 * YOUNG / (2 - POISSON) / (1 + POISSON)
# Of test 8: it has 125000 times the mass, and stays. The second one is ours: it does not.
HEAVY, LIGHT = dict(radius=0.5, density=2699e3), dict(radius=0.15, density=2699)


def alloy_contact(partner):
    """Reduced radius and mass of the alloy sphere at a wall (None) or with a partner, and duration, s."""
    radius, mass = ALLOY["radius"], laws.sphere_mass(**ALLOY)
    if partner:
        radius, mass = (1 / (1 / one + 1 / other) for one, other in
                        ((radius, partner["radius"]), (mass, laws.sphere_mass(**partner))))
    return radius, mass, laws.hertz_duration(radius, mass, MODULUS, SPEED)[0]


def slip_after(run, method, steps, partner, along, surface, **settings):
    """Slip of the surface after the alloy sphere, with these slips by motion and by spin, has met a wall or a
    partner.

    An equal partner spins alike, so that each has half the slip; another one is at rest.
    """
    dt = alloy_contact(partner)[2] / steps
    gap, count = 3.37 * dt * SPEED, round(1.7 * steps) + 20
    shares = (0.5, 0.5) if partner is ALLOY else (1, 0)
    spheres = [sphere(y=ALLOY["radius"] + gap, vy=-SPEED, vx=along, wz=surface / ALLOY["radius"], **ALLOY)]
    if partner:
        spheres = [sphere(x=side * (ball["radius"] + 0.5 * gap), vx=-side * share * SPEED,
                          wz=share * surface / ball["radius"], **ball)
                   for side, share, ball in zip((-1, 1), shares, (ALLOY, partner))]
    scene = dict(spheres=spheres, dt=dt, steps=count, every=count, young=YOUNG, poisson=POISSON, mu=FRICTION,
                 walls=0 if partner else 1, half=2, skin=ALLOY["radius"], **settings)
    states = run(scene, method)[-1][1]
    spins = sum(s["radius"] * s["omegaz"] for s in states)
    return spins + (states[0]["vy"] - states[1]["vy"] if partner else states[0]["vx"])


def spinning(run):
    unit, rows = FRICTION * SPEED, []
    cases = (("5", None, False), ("6", None, True), ("7", ALLOY, True), ("8", HEAVY, True),
             ("8, light", LIGHT, True))
    for (test, partner, spins), ratio in [(case, ratio) for case in cases for ratio in (1, 3, 6)]:
        along, surface = (0.0, ratio * unit) if spins else (ratio * unit, 0.0)
        curvature, _, contact = alloy_contact(partner)
        radius, mass = ALLOY["radius"], laws.sphere_mass(**ALLOY)
        other = (partner["radius"], laws.sphere_mass(**partner)) if partner else None
        rebound = laws.ObliqueImpact(
            radius, mass, 4 / 3 * MODULUS * sqrt(curvature), 8 * SHEAR * sqrt(curvature), FRICTION, SPEED,
            along, spin=surface / radius, exponent=0.5, duration=contact, partner=other)
        turns = zip((radius, other[0] if other else 0), rebound.spins)
        exact = (rebound.velocity + sum(r * w for r, w in turns)) / unit
        errors = [slip_after(run, method, steps, partner, along, surface, restitution=1.0) / unit - exact
                  for method, steps in METHODS_OBLIQUE]
        rows.append([test, f"{ratio}", None, fixed(exact, 5), *errors])
    return Table(
        "Chung and Ooi's tests 5 to 8: one normal speed, other slips",
        "Slip of the surface after the rebound over μ v_n, and its error. Test 5: a sphere that moves "
        "along the plane, 6: one that spins, 7: two equal ones that spin, 8: one that spins and one of "
        "five times the radius and a thousand times the density (as in PySPH's script) at rest; light: one "
        "of 1.5 times the radius and the same density, which recoils. Aluminium alloy of test 2, μ = 0.4, "
        "0.2 m/s, no dashpots. The impact has no other scales than this slip and Poisson's ratio, so test "
        "8 repeats test 6. The references keep the line of centres; two spheres turn it, by some 1e-4, "
        "which is what is left of tests 7 and 8 at 100 steps.",
        ["test", "slip before / μ v_n", "published", "converged", *NAMES_OBLIQUE], rows)


def damped(run):
    """Test 8 as published, with e = 0.5, over 7/2 mu (1 + e) v_n / slip."""
    # As Kratos's tests (DEM3D_chung_ooi_tests/paper_data_5_to_8) have read them off the printed curve.
    published = ((0.187, -0.815), (0.358, -0.626), (0.551, -0.439), (0.765, -0.238), (1.214, 0.096),
                 (2.091, 0.058), (2.989, -0.049), (4.508, -0.139))
    restitution = 0.5
    asked = laws.hertz_input_for(restitution)
    methods = [(OURS, "hertz_spring", 30, asked), (OURS, "hertz_spring", 100, asked),
               (OURS, "hertz_spring", 300, asked), (STOCK, "hertz", 30, asked), (STOCK, "hertz", 300, asked),
               (STOCK, "hertz", 300, restitution)]
    rows = []
    for abscissa, peer in published:
        slip = 3.5 * FRICTION * (1 + restitution) * SPEED / abscissa
        found = [-slip_after(run, method._replace(law=law), steps, HEAVY, 0.0, slip, cap="on",
                             restitution=told) / slip for method, law, steps, told in methods]
        # A slide all through has mu times the normal impulse, mu m (1 + e) v_n, and 7/2 of it over m of the
        # slip.
        exact = fixed(abscissa - 1, 3) if abscissa < 0.9 else None
        rows.append([f"{abscissa}", fixed(peer, 3), exact, *(fixed(f, 4) for f in found)])
    return Table(
        "Chung and Ooi's test 8 with its dashpots, e = 0.5",
        "Tangential restitution, −slip after / slip before. The published curve is that of their case A as "
        "Kratos's tests have read it off the print, to some 0.01. A slide all through is μ times the "
        "normal impulse, a closed form. `multisphere/ab` with `tangential spring_dashpot` and "
        "`totalForceCap on` meets it. LIGGGHTS's `tangential history` goes past Coulomb's cap: it caps the "
        "spring alone and adds the whole tangential dashpot as long as the spring is below, as it is at "
        "the beginning of every impact. A slide then loses a tenth too much (first row, 300 steps), "
        "whatever the integrator; at 30 steps the spring's first increment hides it. From 1.2 on the "
        "contact sticks, each law damps it in its own way, and there is no common reference: LIGGGHTS's, "
        "told 0.5 as it stands, is within 0.02 of the published curve up to 3, ours, whose dashpot counts "
        "under the cap, 0.02 to 0.1 above it; at 4.5 both are above.",
        ["7/2 μ (1 + e) v_n / slip", "published", "slides all through",
         "multisphere/ab, tangential spring_dashpot, 30 steps", "the same, 100 steps", "the same, 300 steps",
         "nve/sphere, history, 30 steps", "the same, 300 steps", "the same, told e = 0.5"], rows)


def tables(run):
    return [normal(run), oblique(run), spinning(run), damped(run)]
