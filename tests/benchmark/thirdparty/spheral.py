# SPDX-License-Identifier: GPL-2.0-or-later
"""Spheral's linear spring: two spheres head-on (tests/functional/DEM/LinearSpringDEM/TwoParticleCollision)."""
from math import sqrt

import laws
from page import Table, fixed
from scene import OURS, ORDER_4, PLAIN, STOCK, STOCK_BODY, sphere, spring_scene

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
         "nve/sphere, 50 steps", "multisphere, 50 steps"], rows)]
