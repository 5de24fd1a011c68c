# SPDX-License-Identifier: GPL-2.0-or-later
"""MFiX's verification cases DEM01 to DEM06 (tests/dem of its sources, chapter 4 of its verification manual).

MFiX's own figures are those of its stored results, tests/dem/*/AUTOTEST/POST_*.dat.
"""
from math import cos, radians, sin, sqrt

import laws
from page import Table, fixed
from scene import OURS, ORDER_4, PLAIN, STOCK, STOCK_BODY, sphere, spring_scene

GRAVITY = 9.80665  # m/s^2, MFiX's default
# MFiX takes a fiftieth of the contact time of two of its particles: against a wall sqrt(2) times as many.
PEER_STEPS = 50 * sqrt(2)
METHODS = [(OURS, PEER_STEPS), (OURS, 30), (ORDER_4, PEER_STEPS), (PLAIN, PEER_STEPS), (STOCK, PEER_STEPS),
           (STOCK_BODY, PEER_STEPS)]
NAMES = ["ours, MFiX's step", "ours, 30 steps", "ours, order 4, MFiX's step", "nve/sphere/ab, MFiX's step",
         "nve/sphere, MFiX's step", "multisphere, MFiX's step"]
BALL = dict(radius=0.1, density=2600)
MASS = laws.sphere_mass(**BALL)


def drop(run, method, stiffness, eta, steps_per_contact, seconds, every=1):
    dt = laws.contact_time(stiffness, MASS) / steps_per_contact
    scene = spring_scene([sphere(y=0.5, **BALL)], dt, round(seconds / dt), every=every, kn=stiffness, kt=stiffness,
                         eta_n=eta, gy=-GRAVITY, walls=1, skin=0.01, kick=(0, -GRAVITY), effective_mass=MASS)
    return run(scene, method)


def exact_drop(stiffness, eta, bounces, tension=False):
    return laws.Bounces(BALL["radius"], MASS, stiffness, eta, 0.5, GRAVITY, bounces, tension)


def dem01(run):
    # MFiX's largest error in contact and until 0.5 s, m, with its Adams-Bashforth scheme.
    published = {(2.5e4, 1.0): (5.727e-5, 6.745e-5), (5e4, 1.0): (3.871e-5, 4.517e-5),
                 (1e5, 1.0): (2.080e-5, 1.3683e-4), (5e4, 0.8): (3.468e-5, 6.1605e-4),
                 (1e5, 0.6): (1.6542e-4, 3.61625e-3)}
    rows = []
    for (stiffness, restitution), peer in published.items():
        eta = laws.damping_ratio_with_tension(restitution)
        exact = exact_drop(stiffness, eta, 1)
        touch, impact = exact.impacts[0]
        errors = []
        for method, steps in METHODS:
            frames = drop(run, method, stiffness, eta, steps, 0.5)
            each = [(abs(rows_[0]["y"] - exact.height(t)), touch < t < touch + impact.end) for t, rows_ in frames]
            errors.append((max(e for e, inside in each if inside), max(e for e, _ in each)))
        for phase in range(2):
            rows.append([f"{stiffness:.3g}", f"{restitution}", ("in contact", "until 0.5 s")[phase],
                         peer[phase], *(e[phase] for e in errors)])
    return Table(
        "MFiX DEM01: a freely falling particle",
        "Largest error of the height, m, against the closed form of fall, contact and flight. Radius 0.1 m, "
        "density 2600 kg/m³, from 0.5 m. At e < 1 MFiX's contact ends with its overlap, ours with its force, at "
        "the same damping ratio: each is held against its own closed form.",
        ["k, N/m", "MFiX's e", "phase", "MFiX", *NAMES], rows)


def apexes(frames):
    """Heights between the bounces, each from one state in flight: exact under gravity alone."""
    found, flight = [], []
    for _, (state,) in frames:
        if state["y"] > BALL["radius"]:
            flight.append(state)
        elif flight:
            middle = flight[len(flight) // 2]
            found.append(middle["y"] + middle["vy"]**2 / (2 * GRAVITY))
            flight = []
    return found


def dem02(run):
    # k, e, bounce, MFiX's height.
    published = [(5e4, 1.0, 1, 0.50002755), (5e4, 1.0, 13, 0.50038200), (5e5, 1.0, 13, 0.49981634),
                 (5e6, 1.0, 13, 0.50022158), (5e4, 0.9, 5, 0.22626641), (5e5, 0.8, 5, 0.13887269)]
    rows = []
    for stiffness, restitution, bounce, peer in published:
        exact = exact_drop(stiffness, laws.damping_ratio_without_tension(restitution), bounce).apexes[bounce]
        own = exact_drop(stiffness, laws.damping_ratio_with_tension(restitution), bounce, True).apexes[bounce]
        errors = []
        for method, steps in METHODS:
            frames = drop(run, method, stiffness, laws.damping_ratio_without_tension(restitution), steps,
                          0.7 * (bounce + 1), every=5)
            errors.append(apexes(frames)[bounce] - exact)
        hard = 0.1 + 0.4 * restitution**(2 * bounce)
        rows.append([f"{stiffness:.3g}", f"{restitution}", str(bounce), fixed(hard, 5), fixed(own, 5),
                     peer - own, fixed(exact, 5), *errors])
    return Table(
        "MFiX DEM02: a bouncing particle",
        "Height after a bounce, m, and its error. The hard sphere is MFiX's own reference; what it is held "
        "against here is the closed form of the soft one, in each program's law at the damping ratio that gives "
        "this e.",
        ["k, N/m", "e", "bounce", "hard sphere", "soft, with tension", "MFiX: error", "soft, without",
         *NAMES], rows)


def dem03(run):
    radius, height, stiffness, seconds = 0.5e-3, 1.8e-3, 1e3, 1e-3
    densities = 2e4, 1e4
    masses = [laws.sphere_mass(radius, d) for d in densities]
    pair = masses[0] * masses[1] / sum(masses)
    start = 0.25 * height, 0.75 * height
    peer_step = laws.contact_time(stiffness, masses[1] / 2) / 50
    coarse_step = laws.contact_time(stiffness, pair) / 30
    rows = []
    for restitution, peer in (1.0, (0.02688809, 0.08695381)), (0.8, (0.00696398, 0.01611446)), \
            (0.5, (0.00203077, 0.00662694)):
        eta = laws.damping_ratio_with_tension(restitution)
        forces = [stiffness * (radius - start[0]), stiffness * (2 * radius - start[1] + start[0]),
                  stiffness * (radius - height + start[1])]
        accelerations = [(below - above) / mass - GRAVITY for below, above, mass in zip(forces, forces[1:], masses)]
        errors = []
        for method, dt in zip((m for m, _ in METHODS), (peer_step, coarse_step, *(peer_step,) * 4)):
            spheres = [sphere(y=y, vy=0.0, radius=radius, density=d) for y, d in zip(start, densities)]
            if method is STOCK_BODY:
                for s, a in zip(spheres, accelerations):
                    s["vy"] = -0.5 * dt * a
            scene = spring_scene(spheres, dt, round(seconds / dt), kn=stiffness, kt=stiffness, eta_n=eta,
                                 gy=-GRAVITY, walls=2, floor=0, ceiling=height, half=0.01, skin=1e-4)
            frames = run(scene, method._replace(law="spring_dashpot"))
            worst = [0.0, 0.0]
            for t, states in frames[:: max(1, len(frames) // 40)] + frames[-1:]:
                exact = laws.stacked(start, (0, 0), t, masses, radius, stiffness, (eta,) * 3, height, GRAVITY, 2000)
                for n in range(2):
                    worst[n] = max(worst[n], abs(states[n]["y"] - exact[n]) / abs(exact[0]))
            errors.append(worst)
        for n in range(2):
            rows.append([f"{restitution}", ("lower", "upper")[n], 0.01 * peer[n], *(e[n] for e in errors)])
    return Table(
        "MFiX DEM03: two stacked, compressed particles",
        "Largest error of the height over that of the lower one, until 1 ms, against a Runge–Kutta solution that "
        "has converged. All three contacts push all the time, so that the laws are the same and there are no events. "
        "The built-in fixes run with our contact law here, since their own wants an atom type for each effective mass.",
        ["MFiX's e", "particle", "MFiX", *NAMES], rows)


ROLLER = dict(radius=0.5e-3, density=1e4)
ROLLER_STIFFNESS, ROLLER_SPEED = 1e4, 0.1
ROLLER_MASS = laws.sphere_mass(**ROLLER)
# Friction acts half-way into the overlap at rest.
ROLLER_ARM = ROLLER["radius"] - 0.5 * ROLLER_MASS * GRAVITY / ROLLER_STIFFNESS


def slip_end(friction):
    """Time at which the slip of DEM04 ends, s, the same as mu g t / u_0, and the frequency of the bobbing, 1/s.

    The particle starts without overlap, so that mu F_n / m = mu g (1 - cos(omega t)) slows its surface down.
    """
    omega = sqrt(ROLLER_STIFFNESS / ROLLER_MASS)
    share = 1 + 2.5 * (ROLLER_ARM / ROLLER["radius"])**2
    end = laws.root(lambda t: ROLLER_SPEED - share * friction * GRAVITY * (t - sin(omega * t) / omega), 1e-4, 0.03)
    return end, friction * GRAVITY / ROLLER_SPEED * end, omega


def measured_slip_end(run, method, friction, expected, steps_per_contact):
    """mu g t / u_0 at which the slip has fallen to zero, between two steps."""
    dt = laws.contact_time(ROLLER_STIFFNESS, ROLLER_MASS) / steps_per_contact
    scene = spring_scene([sphere(y=ROLLER["radius"], vx=ROLLER_SPEED, **ROLLER)], dt, round(1.1 * expected / dt),
                         kn=ROLLER_STIFFNESS, kt=ROLLER_STIFFNESS, mu=friction, gy=-GRAVITY, walls=1, half=0.01,
                         skin=1e-4, kick=(0, -GRAVITY), effective_mass=ROLLER_MASS)
    before = None
    for t, (state,) in run(scene, method):
        slip = state["vx"] + state["omegaz"] * ROLLER_ARM
        if slip <= 0:
            part = before[1] / (before[1] - slip)
            return (before[0] + part * (t - before[0])) * friction * GRAVITY / ROLLER_SPEED
        before = t, slip
    return None


def dem04(run):
    rows = []
    for friction, peer in (0.2, 0.28593282), (0.4, 0.28525487), (0.6, 0.28461681), (0.8, 0.28665064), \
            (1.0, 0.28732858):
        end, exact, _ = slip_end(friction)
        times = [measured_slip_end(run, method, friction, end, steps) for method, steps in METHODS]
        rows.append([f"{friction}", fixed(2 / 7, 5), fixed(exact, 5), peer - exact, *(t - exact for t in times)])
    return Table(
        "MFiX DEM04: slipping on a rough surface",
        "Time μ g t/u₀ at which slipping ends. 2/7 holds for a constant normal force; the particle starts without "
        "overlap and bobs undamped, for which the closed form is the third column. Errors against that one. MFiX takes "
        "the first step at which the slip is gone, so up to 1e-4 μ too late.",
        ["μ", "2/7", "exact", "MFiX: error", *NAMES], rows)


def dem05(run):
    law = dict(radius=2.5e-3, density=4000, kn=1.72e7, kt=1.48e7, friction=0.092)
    mass = laws.sphere_mass(law["radius"], law["density"])
    rows = []
    for degrees, peer in (2, 18.4169), (5, 68.2099), (10, 231.9435), (20, 538.0793), (30, 618.8437), \
            (45, 505.7470), (60, 357.9511):
        normal, along = 3.9 * cos(radians(degrees)), 3.9 * sin(radians(degrees))
        constants = law["radius"], mass, law["kn"], law["kt"], law["friction"], normal, along
        exact = laws.ObliqueImpact(*constants).spin
        own = laws.ObliqueImpact(*constants, lever=lambda r, d: r - d).spin
        errors = []
        for method, steps in METHODS:
            dt = laws.contact_time(law["kn"], mass) / steps
            ball = sphere(y=law["radius"] + 3.37 * dt * normal, vy=-normal, vx=along, radius=law["radius"],
                          density=law["density"])
            count = round(1.5 * steps) + 20
            scene = spring_scene([ball], dt, count, every=count, kn=law["kn"], kt=law["kt"], mu=law["friction"],
                                 walls=1, half=0.05, skin=law["radius"], effective_mass=mass)
            errors.append(run(scene, method)[-1][1][0]["omegaz"] / exact - 1)
        rows.append([f"{degrees}°", fixed(abs(own), 3), peer / abs(own) - 1, fixed(abs(exact), 3), *errors])
    return Table(
        "MFiX DEM05: oblique collision with a wall, linear law",
        "Spin after the rebound, rad/s, and its relative error. No dashpots; 3.9 m/s, angle from the normal. MFiX's "
        "friction acts at the lever r − δ, ours and LIGGGHTS's at r − δ/2, so that each has a reference of its own "
        "(closed normal motion, midpoint rule in 20000 steps of the contact for the tangential one). From 2° to 20°, "
        "where slip and stick change, MFiX's spring, which adds up Δt v_t, shows its first order.",
        ["angle", "lever r − δ", "MFiX: error", "lever r − δ/2", *NAMES], rows)


GRAIN = dict(radius=5e-5, density=2000)
GAS = dict(gas=1.8e-5, gas_density=1.2, stream=0.4)
GRAIN_MASS = laws.sphere_mass(**GRAIN)


def grain_drag(slip):
    return laws.schiller_naumann(2 * GRAIN["radius"], GAS["gas"], GAS["gas_density"], slip)


def errors_in_gas(run, method, dt):
    """Largest relative errors of velocity and height from 0.01 s to 0.35 s, the height from MFiX's floor."""
    start, gravity = 0.0925, GRAVITY * (1 - GAS["gas_density"] / GRAIN["density"])  # less by the buoyancy
    kick = grain_drag(GAS["stream"]) / GRAIN_MASS - gravity
    scene = spring_scene([sphere(y=0.0, **GRAIN)], dt, round(0.35 / dt) + 1, every=round(0.01 / dt), kn=0.1,
                         kt=0.1, gy=-gravity, half=0.1, skin=0.01, kick=(0, kick), effective_mass=GRAIN_MASS,
                         **GAS)
    frames = run(scene, method)[1:]
    exact = laws.in_gas(GRAIN_MASS, GRAIN_MASS * gravity, grain_drag, GAS["stream"], [t for t, _ in frames])
    return (max(abs(s["vy"] / v - 1) for (_, (s,)), (_, v) in zip(frames, exact)),
            max(abs((s["y"] - y) / (start + y)) for (_, (s,)), (y, _) in zip(frames, exact)))


def dem06(run):
    peer_step = laws.contact_time(0.1, GRAIN_MASS / 2) / 50
    rows = []
    for name, dt, peer in ("MFiX's, 4.5 µs", peer_step, (4.13e-5, 2.26e-6)), ("1 ms", 1e-3, (None, None)):
        found = [errors_in_gas(run, method, dt) for method in (OURS, ORDER_4, PLAIN, STOCK, STOCK_BODY)]
        for n, measure in enumerate(("velocity", "height")):
            rows.append([name, measure, peer[n], *(f[n] for f in found)])
    return Table(
        "MFiX DEM06: a grain in a stream of gas",
        "Largest relative errors at each hundredth of a second until 0.35 s, when the grain (0.1 mm, 2000 "
        "kg/m³), let go at 92.5 mm, has reached its terminal velocity in air that streams upwards at 0.4 "
        "m/s. Of MFiX's variants this is the one whose gas is given: LIGGGHTS's `fix addforce` has the "
        "drag, Schiller and Naumann's, of the velocity that forces see. The variants that solve for the "
        "gas have no place here, since there is no gas in this package; MFiX's velocities are then 0.5 to "
        "5 % off. Nothing touches, so that there is no contact time to count steps by: 1 ms is MFiX's step "
        "of the gas. Velocity Verlet's drag is that of half a step before, which is of first order like "
        "MFiX's; order 4 has its start, where the drag changes fastest, only in third order.",
        ["step", "", "MFiX", "ours", "ours, order 4", "nve/sphere/ab", "nve/sphere", "multisphere"], rows)


def tables(run):
    return [dem01(run), dem02(run), dem03(run), dem04(run), dem05(run), dem06(run)]
