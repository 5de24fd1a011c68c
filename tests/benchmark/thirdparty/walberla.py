# SPDX-License-Identifier: GPL-2.0-or-later
"""waLBerla's test of integrators: a harmonic oscillator (tests/mesa_pd/kernel/IntegratorAccuracy.cpp)."""
from math import cos, pi, sin, sqrt

import laws
from page import Table
from scene import OURS, ORDER_4, PLAIN, STOCK, STOCK_BODY, sphere, spring_scene

AMPLITUDE, STIFFNESS, MASS, STEP = 1.5, 0.1, 0.9, 0.2
RADIUS, SQUEEZE = 10.0, 2.0  # of a sphere between two walls, which both push all the time


def errors(run, method, dt, periods):
    """Of the largest position and velocity, of the path over the amplitude, and of the energy at the end."""
    omega = sqrt(STIFFNESS / MASS)
    steps = round(periods * 2 * pi / omega / dt)
    density = MASS / laws.sphere_mass(RADIUS, 1)
    wall = RADIUS - SQUEEZE
    scene = spring_scene([sphere(y=AMPLITUDE, radius=RADIUS, density=density)], dt, steps, kn=STIFFNESS / 2,
                         kt=STIFFNESS / 2, walls=2, floor=-wall, ceiling=wall, half=20, skin=2,
                         kick=(0, -omega**2 * AMPLITUDE), effective_mass=MASS)
    frames = [(t, states[0]["y"], states[0]["vy"]) for t, states in run(scene, method)]
    exact = [(AMPLITUDE * cos(omega * t), -AMPLITUDE * omega * sin(omega * t)) for t, _, _ in frames]
    largest = [max(abs(f[n + 1]) for f in frames[1:]) / max(abs(e[n]) for e in exact[1:]) - 1 for n in range(2)]
    path = max(abs(f[1] - e[0]) for f, e in zip(frames, exact)) / AMPLITUDE
    _, y, vy = frames[-1]
    return (*largest, path, (y**2 + (vy / omega)**2) / AMPLITUDE**2 - 1)


def tables(run):
    period = 2 * pi * sqrt(MASS / STIFFNESS)
    rows = []
    for periods, measures in (1.1, (0, 1, 2, 3)), (20, (2, 3)):
        found = [errors(run, method, dt, periods) for method, dt in (
            (OURS, STEP), (OURS, period / 60), (ORDER_4, STEP), (PLAIN, STEP), (STOCK, STEP), (STOCK_BODY, STEP))]
        for n in measures:
            name = ("largest position", "largest velocity", "path", "energy")[n]
            rows.append([f"{periods}", name, "1e-2, its bound" if n < 2 else None, *(f[n] for f in found)])
    return [Table(
        "waLBerla: a harmonic oscillator",
        f"Relative errors. k = 0.1, mass 0.9, amplitude 1.5, step 0.2: {period / STEP / 2:.0f} steps in half a period. "
        "Here a sphere between two walls that both press on it. waLBerla's bound is that for velocity Verlet.",
        ["periods", "", "waLBerla", "ours, 0.2", "ours, 30 steps", "ours, order 4, 0.2", "nve/sphere/ab, 0.2",
         "nve/sphere, 0.2", "multisphere, 0.2"], rows)]
