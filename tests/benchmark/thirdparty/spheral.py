# SPDX-License-Identifier: GPL-2.0-or-later
"""Spheral's linear spring and its composite particle
(tests/functional/DEM/LinearSpringDEM/TwoParticleCollision)."""
from math import pi, sqrt

import laws
from page import Table, fixed
from scene import OURS, ORDER_4, PLAIN, STOCK, STOCK_BODY, dumbbell, dumbbell_inertia, sphere, spring_scene

RADIUS, MASS, STIFFNESS, SPEED = 0.25, 0.25, 1e4, 1.0
PEER_STEPS, PHASES = 50, 8


def restitution_error(run, method, restitution, steps_per_contact):
    """Root mean square over pairs whose first touches fall at different moments of a step."""
    density = MASS / laws.sphere_mass(RADIUS, 1)
    dt = laws.contact_time(STIFFNESS, MASS / 2) / steps_per_contact
    steps = round(2 * steps_per_contact) + 20
    spheres = []
    for pair in range(PHASES):
        for side in -1, 1:
            apart = RADIUS + (3 + (pair + 0.5) / PHASES) * dt * SPEED
            spheres.append(sphere(x=side * apart, y=1.5 * pair - 5.25, vx=-side * SPEED, radius=RADIUS,
                                  density=density))
    eta = laws.damping_ratio_without_tension(restitution)
    scene = spring_scene(spheres, dt, steps, every=steps, kn=STIFFNESS, kt=2857, eta_n=eta, eta_t=eta, mu=1, half=7,
                         skin=0.3, effective_mass=MASS / 2)
    states = run(scene, method)[-1][1]
    found = [(right["vx"] - left["vx"]) / (2 * SPEED) for left, right in zip(states[::2], states[1::2])]
    return sqrt(sum((e / restitution - 1)**2 for e in found) / PHASES)


# Spheral's composite: two of these spheres that overlap by a radius. Theirs hold together by a spring, ours
# are rigid.
SPACING, PAIR_MASS = RADIUS, 2 * MASS
INERTIA = dumbbell_inertia(MASS, SPACING, RADIUS)[1]
OFF_CENTRE_MASS = 0.5 / (1 / PAIR_MASS + (0.5 * SPACING)**2 / INERTIA)  # what the line of impact meets
SPHERE_DENSITY = MASS / laws.sphere_mass(RADIUS, 1)
BODY_METHODS = [(OURS, PEER_STEPS), (OURS, 30), (ORDER_4, PEER_STEPS), (STOCK_BODY, PEER_STEPS)]
BODY_NAMES = ["ours, 50 steps", "ours, 30 steps", "ours, order 4, 50 steps", "multisphere, 50 steps"]


def meet(run, method, pairs, eta, contact, steps_per_contact, effective_mass):
    """First and last states, (time, rows), of `pairs` (lists of spheres and dumbbells) that meet without
    friction.

    Those that `pairs` gives for a gap of g steps at the relative speed 2 SPEED touch at another moment of a
    step each.
    """
    dt = contact / steps_per_contact
    steps = round(2 * steps_per_contact) + 20
    bodies = []
    for n in range(PHASES):
        bodies += pairs((6 + 2 * (n + 0.5) / PHASES) * dt * SPEED, 2.2 * n - 7.7)
    scene = spring_scene(bodies, dt, steps, every=steps, kn=STIFFNESS, kt=2857, eta_n=eta, eta_t=eta, half=10,
                         skin=0.3, effective_mass=effective_mass)
    frames = run(scene, method)
    return frames[0], frames[-1]


def root_mean_square(numbers):
    return sqrt(sum(x**2 for x in numbers) / len(numbers))


def head_on(run, method, restitution, steps_per_contact):
    """Of a dumbbell that meets a sphere end-on: errors of the restitution and of the duration (undamped), and
    the change of momentum over that of the sphere."""
    reduced = 1 / (1 / PAIR_MASS + 1 / MASS)
    contact = laws.contact_time(STIFFNESS, reduced)

    def pairs(gap, y):
        return [dumbbell(MASS, SPACING, x=-0.5 * SPACING - RADIUS - 0.5 * gap, y=y, vx=SPEED, radius=RADIUS),
                sphere(x=RADIUS + 0.5 * gap, y=y, vx=-SPEED, radius=RADIUS, density=SPHERE_DENSITY)]

    eta = laws.damping_ratio_without_tension(restitution)
    (_, before), (t, after) = meet(run, method, pairs, eta, contact, steps_per_contact, reduced)
    rebounds, durations, momenta = [], [], []
    for n in range(0, 2 * PHASES, 2):
        rebound = after[n + 1]["vx"] - after[n]["vx"]
        gaps = [s[n + 1]["x"] - s[n]["x"] - 0.5 * SPACING - 2 * RADIUS for s in (before, after)]
        rebounds.append(rebound / (2 * SPEED * restitution) - 1)
        durations.append((t - gaps[0] / (2 * SPEED) - gaps[1] / rebound) / contact - 1)
        momenta.append(abs(PAIR_MASS * (after[n]["vx"] - SPEED) + MASS * (after[n + 1]["vx"] + SPEED)))
    return root_mean_square(rebounds), root_mean_square(durations), max(momenta) / (MASS * SPEED)


def off_centre(run, method, eta, steps_per_contact):
    """Of two dumbbells across their way whose inner spheres meet head-on: velocities along x and spins
    afterwards, and the largest change of a pair's angular momentum over that of one body."""

    def pairs(gap, y):
        return [dumbbell(MASS, SPACING, 0.5 * pi, x=side * (RADIUS + 0.5 * gap), y=y + side * 0.5 * SPACING,
                         vx=-side * SPEED, radius=RADIUS) for side in (-1, 1)]

    (_, before), (_, after) = meet(run, method, pairs, eta, laws.contact_time(STIFFNESS, OFF_CENTRE_MASS),
                                   steps_per_contact, 0.5 * PAIR_MASS)
    angular = []
    for n in range(0, 2 * PHASES, 2):
        x, y = before[n]["x"], before[n]["y"]
        turns = [sum(PAIR_MASS * ((s["x"] - x) * s["vy"] - (s["y"] - y) * s["vx"]) + INERTIA * s["omegaz"]
                     for s in state[n:n + 2]) for state in (before, after)]
        angular.append(abs(turns[1] - turns[0]))
    return ([(-1)**n * s["vx"] for n, s in enumerate(after)], [s["omegaz"] for s in after],
            max(angular) / (PAIR_MASS * SPEED * 0.5 * SPACING))


def composite(run):
    rows = []
    reduced = 1 / (1 / PAIR_MASS + 1 / MASS)
    for restitution in 0.8, 1.0:
        errors = zip(*(head_on(run, method, restitution, steps) for method, steps in BODY_METHODS))
        measures = (("restitution", "1e-2, its bound", fixed(restitution, 1)),
                    ("duration, s", None, fixed(laws.contact_time(STIFFNESS, reduced), 7)),
                    ("momentum", None, "kept"))
        for (name, bound, exact), found in zip(measures, errors):
            if name != "duration, s" or restitution == 1:
                rows.append(["end-on, a sphere", fixed(restitution, 1), name, bound, exact, exact, *found])
    for restitution in 0.8, 1.0:
        # The dashpot is that of the bodies' masses; against what turns out of the way its damping ratio is
        # another.
        damping = 2 * laws.damping_ratio_without_tension(restitution) * sqrt(STIFFNESS * OFF_CENTRE_MASS)
        velocity, _, spin = laws.parallel_dumbbells(PAIR_MASS, INERTIA, SPACING, RADIUS, STIFFNESS, damping,
                                                    SPEED)
        push = laws.impulse([PAIR_MASS] * 2, [INERTIA] * 2, [0.5 * SPACING] * 2, 2 * SPEED, restitution)
        found = [off_centre(run, method, damping / (2 * sqrt(STIFFNESS * 0.5 * PAIR_MASS)), steps)
                 for method, steps in BODY_METHODS]
        for n, (name, stiff, exact) in enumerate((("velocity, m/s", SPEED - push / PAIR_MASS, velocity),
                                                  ("spin, rad/s", 0.5 * SPACING * push / INERTIA, spin))):
            rows.append(["off-centre, its like", fixed(restitution, 1), name, None, fixed(stiff, 5),
                         fixed(exact, 5), *(root_mean_square([v / exact - 1 for v in f[n]]) for f in found)])
        rows.append(["off-centre, its like", fixed(restitution, 1), "angular momentum", None, "kept", "kept",
                     *(f[2] for f in found)])
    return Table(
        "Spheral: composite particles",
        f"Root mean square of the relative error, {PHASES} impacts without friction whose first touches "
        "fall at different moments of a step; of what is kept, its largest change over that of one body. "
        "Two spheres of the table above that overlap by a radius meet one of their like end-on (Spheral's "
        "test; its composite is held together by a spring, ours is rigid), or pass across their way "
        "another two such that a sphere of each meets one of the other head-on (ours), at ±1 m/s. Stiff: "
        "the impulse of rigid bodies, (1 + e) v / (Σ 1/m + h²/I). The spring lasts, and the bodies turn "
        "meanwhile, which changes the velocity by 1e-4: the converged solution has that in it. Momentum is "
        "kept to rounding, angular momentum by ours as well as its order lets it.",
        ["two spheres in one body meet", "e", "", "Spheral", "stiff", "converged", *BODY_NAMES], rows)


def tables(run):
    rows = []
    for restitution in 0.55, 1.0:
        found = [restitution_error(run, method, restitution, steps) for method, steps in (
            (OURS, PEER_STEPS), (OURS, 30), (ORDER_4, PEER_STEPS), (PLAIN, PEER_STEPS), (STOCK, PEER_STEPS),
            (STOCK_BODY, PEER_STEPS))]
        rows.append([fixed(restitution, 2), "2e-2, its bound", *found])
    return [Table(
        "Spheral: two spheres with a linear spring",
        f"Root mean square of the relative error of the restitution, {PHASES} head-on impacts whose first touches "
        "fall at different moments of a step. k = 1e4 N/m, mass 0.25 kg each, 1 m/s each, 50 steps per contact. "
        "Spheral's test has a bound and no figure.",
        ["e", "Spheral", "ours, 50 steps", "ours, 30 steps", "ours, order 4, 50 steps", "nve/sphere/ab, 50 steps",
         "nve/sphere, 50 steps", "multisphere, 50 steps"], rows), composite(run)]
