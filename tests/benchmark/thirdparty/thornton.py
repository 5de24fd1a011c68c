# SPDX-License-Identifier: GPL-2.0-or-later
"""Oblique impacts with a linear law, in the dimensionless terms of Thornton et al., Powder Technol. 210, 30 (2011)
and 233, 30 (2013): k_t/k_n = 2/7, angle of impact psi = tan(theta) / mu."""
from math import sqrt

import laws
from page import Table, fixed
from scene import OURS, ORDER_4, PLAIN, STOCK, STOCK_BODY, sphere, spring_scene

RADIUS, DENSITY, STIFFNESS, FRICTION, SPEED, RATIO = 1.5e-3, 2500, 2000, 0.3, 0.5, 2 / 7
PHASES = 24
MASS = laws.sphere_mass(RADIUS, DENSITY)


def slips(run, method, psi, eta, steps_per_contact, cap="off"):
    """`cap`: whether friction is capped by the whole normal force. Slip of the surface after the rebound over mu v_n, for first touches at different moments of a step."""
    dt = laws.contact_time(STIFFNESS, MASS) / steps_per_contact
    spheres = [sphere(x=-0.1 + 0.008 * n, y=RADIUS + (3 + (n + 0.5) / PHASES) * SPEED * dt, vy=-SPEED,
                      vx=psi * FRICTION * SPEED, radius=RADIUS, density=DENSITY) for n in range(PHASES)]
    steps = round(2.2 * steps_per_contact) + 20
    scene = spring_scene(spheres, dt, steps, every=steps, kn=STIFFNESS, kt=RATIO * STIFFNESS, eta_n=eta, eta_t=eta,
                         mu=FRICTION, walls=1, half=0.25, effective_mass=MASS, cap=cap)
    return [(s["vx"] + RADIUS * s["omegaz"]) / (FRICTION * SPEED) for s in run(scene, method)[-1][1]]


def elastic(run):
    rows = []
    for psi in 0.5, 1, 2, 3, 4, 5, 6:
        impact = laws.ObliqueImpact(RADIUS, MASS, STIFFNESS, RATIO * STIFFNESS, FRICTION, SPEED,
                                    psi * FRICTION * SPEED)
        exact = (impact.velocity + RADIUS * impact.spin) / (FRICTION * SPEED)
        errors = []
        for method, steps in (OURS, 30), (OURS, 100), (ORDER_4, 30), (PLAIN, 30), (STOCK, 30), (STOCK_BODY, 30):
            found = slips(run, method, psi, 0.0, steps)
            errors.append(sqrt(sum((s - exact)**2 for s in found) / PHASES))
        rows.append([f"{psi}", None, fixed(exact, 5), *errors])
    return Table(
        "Thornton et al.: elastic oblique impacts, linear law",
        f"Slip of the surface after the rebound over μ v_n, and its root mean square error over {PHASES} phases of the "
        "first touch. No dashpots, so that all caps of friction are the same. Thornton et al. print curves.",
        ["tan θ / μ", "Thornton", "converged", "ours, 30 steps", "ours, 100 steps", "ours, order 4, 30 steps",
         "nve/sphere/ab, 30 steps", "nve/sphere, 30 steps", "multisphere, 30 steps"], rows)


def spread(run):
    eta = laws.damping_ratio_without_tension(0.5)
    rows = []
    for cap, name in ("off", "μ k_n δ"), ("on", "μ F_n"):
        for psi in 1, 3, 4, 4.18, 4.3, 4.6, 5, 6:
            row = [name, f"{psi}"]
            for steps in 30, 120, 480:
                found = slips(run, OURS, psi, eta, steps, cap)
                row += [fixed(sum(found) / PHASES, 4), max(found) - min(found)]
            rows.append(row)
    return Table(
        "The same at e = 0.5, η_t = η_n: where the law has no limit",
        f"Slip of the surface after the rebound over μ v_n: mean, and largest less smallest over {PHASES} phases of "
        "the first touch, `multisphere/ab`; under the paper's cap, μ k_n δ, and that of Thornton, MFiX and LAMMPS, μ F_n "
        "with the dashpot (`totalForceCap on`). Where a contact comes to a stop while its cap falls (tan θ / μ from 4.16 "
        "to about 4.8, or from 4.22 to 5.15), the spread stays whatever the step: the law itself, not the integrator "
        "(gran_model_spring_dashpot.md). Elsewhere it falls like the cube of the step, near the band like its "
        "square. Under μ F_n a slide all through (the last row) loses 7/2 (1 + e) of the slip but for the lever, r − δ/2.",
        ["cap", "tan θ / μ", "30 steps", "spread", "120 steps", "spread", "480 steps", "spread"], rows)


def tables(run):
    return [elastic(run), spread(run)]
