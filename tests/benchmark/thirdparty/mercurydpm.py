# SPDX-License-Identifier: GPL-2.0-or-later
"""MercuryDPM's particle on an inclined plane (Drivers/UnitTests/inclined_plane.cpp), rolling and sliding."""
from math import cos, pi, sin, sqrt, tan

import laws
from page import Table, fixed
from scene import OURS, ORDER_4, PLAIN, STOCK, STOCK_BODY, sphere, spring_scene

RADIUS, DENSITY, STIFFNESS, SLOPE, GRAVITY, SECONDS, PEER_STEP = 0.005, 2000, 1e4, 15 * pi / 180, 9.8, 1.0, 2e-6


def final_velocity(run, method, friction, dt):
    """And its time, s."""
    mass = laws.sphere_mass(RADIUS, DENSITY)
    gravity = GRAVITY * sin(SLOPE), -GRAVITY * cos(SLOPE)
    steps = round(SECONDS / dt)
    ball = sphere(y=RADIUS, x=-0.9, radius=RADIUS, density=DENSITY)
    scene = spring_scene([ball], SECONDS / steps, steps, every=steps, kn=STIFFNESS, kt=STIFFNESS, mu=friction,
                         gx=gravity[0], gy=gravity[1], walls=1, half=1.2, skin=0.1, kick=gravity, effective_mass=mass)
    seconds, (state,) = run(scene, method)[-1]
    return state["vx"], seconds


def tables(run):
    mass = laws.sphere_mass(RADIUS, DENSITY)
    omega = sqrt(STIFFNESS / mass)
    coarse = laws.contact_time(STIFFNESS, mass) / 30
    pressing = GRAVITY * cos(SLOPE)
    rows = []
    for friction in 0.5, 0.05:
        rolls = friction > 2 / 7 * tan(SLOPE)

        def exact(t):
            if rolls:
                return 5 / 7 * GRAVITY * sin(SLOPE) * t
            return GRAVITY * sin(SLOPE) * t - friction * pressing * (t - sin(omega * t) / omega)

        found = [final_velocity(run, method, friction, dt) for method, dt in (
            (OURS, PEER_STEP), (OURS, coarse), (ORDER_4, PEER_STEP), (PLAIN, PEER_STEP), (STOCK, PEER_STEP),
            (STOCK_BODY, PEER_STEP))]
        rows.append([f"{friction}", "rolls" if rolls else "slides", None, fixed(exact(SECONDS), 6),
                     *(velocity / exact(t) - 1 for velocity, t in found)])
    return [Table(
        "MercuryDPM: a particle on an inclined plane",
        "Velocity after 1 s down a slope of 15°, m/s, and its relative error. Radius 5 mm, 2000 kg/m³, k = k_t = "
        "1e4 N/m, no dashpots, step 2 µs; μ = 0.5 as in MercuryDPM's case, which states no expected value, and "
        "μ = 0.05, below 2/7 tan 15°. The particle starts without overlap and bobs on both springs. The closed form "
        "of rolling, 5/7 g sin θ t, is that of the rigid particle, from which the bobbing differs by up to 2e-4; that "
        "of sliding has the bobbing in it.",
        ["μ", "", "MercuryDPM", "exact", "ours, 2 µs", "ours, 30 steps", "ours, order 4, 2 µs", "nve/sphere/ab, 2 µs",
         "nve/sphere, 2 µs", "multisphere, 2 µs"], rows)]
