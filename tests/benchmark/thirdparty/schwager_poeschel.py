# SPDX-License-Identifier: GPL-2.0-or-later
"""Restitution of the linear law without tension: Schwager and Poeschel, Granular Matter 9, 465 (2007)."""
from math import sqrt

import laws
from page import Table, fixed
from scene import OURS, ORDER_4, PLAIN, STOCK, STOCK_BODY, sphere, spring_scene

RADIUS, DENSITY, STIFFNESS, SPEED = 1.5e-3, 2500, 2000, 0.5
PHASES = 16


def restitution_error(run, method, eta, steps_per_contact):
    """Root mean square over first touches that fall at different moments of a step."""
    mass = laws.sphere_mass(RADIUS, DENSITY)
    dt = laws.contact_time(STIFFNESS, mass) / steps_per_contact
    spheres = [sphere(x=-0.06 + 0.008 * n, y=RADIUS + (3 + (n + 0.5) / PHASES) * SPEED * dt, vy=-SPEED,
                      radius=RADIUS, density=DENSITY) for n in range(PHASES)]
    steps = round(2 * steps_per_contact) + 20
    scene = spring_scene(spheres, dt, steps, every=steps, kn=STIFFNESS, kt=STIFFNESS, eta_n=eta, walls=1, half=0.1,
                         effective_mass=mass)
    exact = laws.restitution_without_tension(eta)
    states = run(scene, method)[-1][1]
    return sqrt(sum((s["vy"] / SPEED - exact)**2 for s in states) / len(states))


def tables(run):
    columns = [(OURS, 30), (OURS, 60), (ORDER_4, 30), (PLAIN, 30), (STOCK, 30), (STOCK_BODY, 30)]
    rows = []
    for eta, published in (0.05, 0.858758), (0.1, 0.744079), (0.2, 0.571740), (0.3, 0.450975), (0.5, 0.298436):
        rows.append([f"{eta}", fixed(published, 6), fixed(laws.restitution_without_tension(eta), 6),
                     *(restitution_error(run, method, eta, steps) for method, steps in columns)])
    return [Table(
        "Schwager and Pöschel: restitution without tension",
        f"e of a sphere on a wall, and its root mean square error over {PHASES} phases of the first touch within a "
        "step. The published values are those of the closed form; the second column is evaluated here.",
        ["η", "published", "e = exp(−2 η acos η / √(1 − η²))", "ours, 30 steps", "ours, 60 steps",
         "ours, order 4, 30 steps", "nve/sphere/ab, 30 steps", "nve/sphere, 30 steps", "multisphere, 30 steps"], rows)]
