# SPDX-License-Identifier: GPL-2.0-or-later
"""Closed forms and converged solutions, written down without the program's own code."""
from math import acos, atan2, cos, erf, exp, gamma, log, pi, sin, sqrt


def root(function, low, high):
    """Where a continuous function changes its sign between low and high, to the last bits."""
    below = function(low) < 0
    for _ in range(200):
        middle = 0.5 * (low + high)
        if middle in (low, high):
            break
        if (function(middle) < 0) == below:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


def sphere_mass(radius, density):
    return 4 / 3 * pi * radius**3 * density


def contact_time(stiffness, mass):
    """Half a period of the undamped spring, s: what "steps per contact" counts."""
    return pi * sqrt(mass / stiffness)


def restitution_without_tension(eta):
    """Schwager and Poeschel, Granular Matter 9, 465 (2007): the contact ends with its force."""
    return exp(-2 * eta * acos(eta) / sqrt(1 - eta**2))


def damping_ratio_without_tension(restitution):
    """Its inverse. With eta = cos(alpha), -ln e = 2 alpha / tan(alpha), which falls from 2 to 0 in alpha."""
    if restitution == 1:
        return 0.0
    alpha = root(lambda a: 2 * a / (sin(a) / cos(a)) + log(restitution), 1e-9, pi / 2)
    return cos(alpha)


def damping_ratio_with_tension(restitution):
    """MFiX and others: the contact ends with its overlap, e = exp(-pi eta / sqrt(1 - eta^2))."""
    return -log(restitution) / sqrt(pi**2 + log(restitution)**2)


def hertz_input_for(restitution):
    """What LIGGGHTS's `model hertz` has to be told for a sphere to rebound with `restitution` under
    `limitForce on`.

    F = k d^(3/2) + eta sqrt(5 k m) d^(1/4) d', eta from `coefficientRestitution` as in
    damping_ratio_with_tension. In the time s, ds = d^(1/4) dt, z = d^(5/4) is the linear spring and dashpot,
    z'' + sqrt(5 k / m) eta z' + 5 k / (4 m) z = 0, with z' = 5/4 d' (Antypov and Elliott, EPL 94, 50004,
    2011). Its force is zero where that of the linear law is, so the restitution of the contact without
    tension is the linear law's, too.
    """
    eta = damping_ratio_without_tension(restitution)
    return exp(-pi * eta / sqrt(1 - eta**2))


def hertz_restitution(told):
    """Its inverse: with which restitution a sphere rebounds that is told `told`."""
    return restitution_without_tension(damping_ratio_with_tension(told))


class Impact:
    """A sphere that touches a wall at time 0 with the closing speed `speed`, under a gravity that presses it on.

    m d'' = m g - k d - c d', solved in closed form. `tension`: the contact ends with its overlap, else where
    its force k d + c d' falls to zero.
    """

    def __init__(self, mass, stiffness, eta, speed, gravity=0.0, tension=False):
        self.frequency = sqrt(stiffness / mass)
        self.decay = eta * self.frequency
        self.damped = self.frequency * sqrt(1 - eta**2)
        self.rest = gravity / self.frequency**2
        self.cosine = -self.rest
        self.sine = (speed + self.decay * self.cosine) / self.damped
        # The first zero lies between the turn of the way in and a full period.
        turn = atan2(speed, self.decay * self.sine + self.damped * self.rest) / self.damped
        ends = self.overlap if tension else self.force
        later = turn
        while ends(later) > 0:
            later += 0.01 / self.frequency
            if later > 4 * pi / self.frequency:
                raise ValueError("the sphere does not leave the wall")
        self.end = root(ends, turn, later)
        self.end_overlap, self.end_speed = self.overlap(self.end), -self.rate(self.end)

    def overlap(self, t):
        return self.rest + exp(-self.decay * t) * (
            self.cosine * cos(self.damped * t) + self.sine * sin(self.damped * t))

    def rate(self, t):
        a, b = self.cosine, self.sine
        return exp(-self.decay * t) * ((self.damped * b - self.decay * a) * cos(self.damped * t)
                                       - (self.damped * a + self.decay * b) * sin(self.damped * t))

    def force(self, t):
        """Over the mass."""
        return self.frequency**2 * self.overlap(t) + 2 * self.decay * self.rate(t)


class Bounces:
    """A sphere dropped from rest at the height `start` of its centre over a wall at y = 0."""

    def __init__(self, radius, mass, stiffness, eta, start, gravity, number, tension=False):
        self.radius, self.gravity = radius, gravity
        self.impacts, self.apexes = [], [start]  # impacts: (time of touch, Impact)
        touch = sqrt(2 * (start - radius) / gravity)
        speed = gravity * touch
        for _ in range(number):
            impact = Impact(mass, stiffness, eta, speed, gravity, tension)
            self.impacts.append((touch, impact))
            apex = radius - impact.end_overlap + impact.end_speed**2 / (2 * gravity)
            self.apexes.append(apex)
            speed = sqrt(2 * gravity * (apex - radius))
            touch += impact.end + (impact.end_speed + speed) / gravity

    def height(self, t):
        touch, impact = None, None
        for begin, candidate in self.impacts:
            if begin <= t:
                touch, impact = begin, candidate
        if impact is None:
            return self.apexes[0] - 0.5 * self.gravity * t**2
        since = t - touch
        if since < impact.end:
            return self.radius - impact.overlap(since)
        since -= impact.end
        return self.radius - impact.end_overlap + impact.end_speed * since - 0.5 * self.gravity * since**2


def hertz_duration(radius, mass, modulus, speed):
    """Of an undamped impact under F = 4/3 E* sqrt(R) d^(3/2), s; and its largest overlap, m."""
    stiffness = 4 / 3 * modulus * sqrt(radius)
    depth = (1.25 * mass * speed**2 / stiffness)**0.4
    # 2 int_0^1 dx / sqrt(1 - x^(5/2)) = 2.9433
    return 2 * sqrt(pi) * gamma(1.4) / gamma(0.9) * depth / speed, depth


def elastic_overlaps(mass, stiffness, exponent, speed, duration, steps):
    """Overlaps at the 2 steps + 1 ends and middles of steps of an impact under F = k d^(1 + exponent)."""
    dt = duration / steps
    if exponent == 0:
        omega = sqrt(stiffness / mass)
        return dt, [speed / omega * sin(omega * 0.5 * dt * n) for n in range(2 * steps + 1)]

    def rates(d, v):
        return v, -stiffness / mass * max(d, 0.0)**(1 + exponent)

    h, d, v, overlaps = 0.5 * dt, 0.0, speed, [0.0]
    for _ in range(2 * steps):
        a = rates(d, v)
        b = rates(d + 0.5 * h * a[0], v + 0.5 * h * a[1])
        c = rates(d + 0.5 * h * b[0], v + 0.5 * h * b[1])
        e = rates(d + h * c[0], v + h * c[1])
        d += h / 6 * (a[0] + 2 * b[0] + 2 * c[0] + e[0])
        v += h / 6 * (a[1] + 2 * b[1] + 2 * c[1] + e[1])
        overlaps.append(max(d, 0.0))
    return dt, overlaps


class ObliqueImpact:
    """A sphere without gravity and without dashpots meets a wall obliquely; Coulomb's cap mu F_n.

    `partner`: a second sphere (radius, mass) at rest in place of the wall; the velocities are then relative
    ones. F_n = kn d^(1 + exponent), F_t = kt d^exponent s: linear, or Hertz's with the exponent 1/2. The
    tangential motion is integrated by the midpoint rule in `steps` steps of the contact, of `duration` (s)
    where it is not linear, with the spring cut to the cap at the end of each (second order in the step).
    `lever` gives the lever of the friction force for a radius and an overlap.
    """

    def __init__(self, radius, mass, kn, kt, friction, normal_speed, tangential_speed, spin=0.0,
                 lever=lambda r, d: r - 0.5 * d, exponent=0.0, duration=None, steps=20000, partner=None):
        spheres = [(radius, mass)] + ([partner] if partner else [])
        mass = 1 / sum(1 / m for _, m in spheres)
        duration = duration or contact_time(kn, mass)
        dt, overlaps = elastic_overlaps(mass, kn, exponent, normal_speed, duration, steps)
        spins = [spin, 0.0][:len(spheres)]
        v, spring = tangential_speed, 0.0

        def turns(force, overlap):
            """Rates of the spins."""
            return [force * lever(r, overlap) / (0.4 * m * r**2) for r, m in spheres]

        def slip(velocity, spins, overlap):
            """Spins are counted so that friction changes them and the velocity with the same sign."""
            return velocity + sum(lever(r, overlap) * w for (r, _), w in zip(spheres, spins))

        for begin, middle, end in zip(overlaps[0::2], overlaps[1::2], overlaps[2::2]):
            force = -kt * begin**exponent * spring
            half_v = v + 0.5 * dt * force / mass
            half_spins = [w + 0.5 * dt * rate for w, rate in zip(spins, turns(force, begin))]
            force = -kt * middle**exponent * (spring + 0.5 * dt * slip(v, spins, middle))
            cap = friction * kn * middle**(1 + exponent)
            force = max(-cap, min(cap, force))
            longest = friction * kn / kt * end
            spring = max(-longest, min(longest, spring + dt * slip(half_v, half_spins, middle)))
            v += dt * force / mass
            spins = [w + dt * rate for w, rate in zip(spins, turns(force, middle))]
        self.velocity, self.spin, self.spins = v, spins[0], spins


def impulse(masses, inertias, arms, closing_speed, restitution):
    """Of two rigid bodies that meet without friction, kg m/s; `arms`: from their centres to its line, m."""
    reduced = 1 / sum(1 / m + h**2 / i for m, i, h in zip(masses, inertias, arms))
    return (1 + restitution) * closing_speed * reduced


def parallel_dumbbells(mass, inertia, spacing, radius, stiffness, damping, speed, steps=2000):
    """Velocity along x and spin of a dumbbell after it has met an equal one that comes the other way.

    Both stand across x, +- `speed`, offset so that a sphere of each meets one of the other head-on. Each
    turns about the point half-way between, as the other one does, so one sphere of one body says it all: at
    the angle w it is at r = (X, Y) + s/2 (-sin w, cos w) from that point, and F = k d + c d', d = 2 (R -
    |r|), pushes it away. Runge-Kutta's fourth order in `steps` steps of the contact from touch on, the last
    one cut where the force ends.
    """
    arm = 0.5 * spacing
    reduced = 0.5 / (1 / mass + arm**2 / inertia)
    dt = contact_time(stiffness, reduced) / steps

    def pushed(s):
        x, y, turned, vx, vy, w = s
        sine, cosine = sin(turned), cos(turned)
        rx, ry = x - arm * sine, y + arm * cosine
        distance = sqrt(rx**2 + ry**2)
        nx, ny = rx / distance, ry / distance
        rate = -2 * (nx * (vx - arm * cosine * w) + ny * (vy - arm * sine * w))
        return stiffness * 2 * (radius - distance) + damping * rate, nx, ny, arm * (-sine * ny - cosine * nx)

    def rates(s):
        force, nx, ny, lever = pushed(s)
        return (*s[3:], force * nx / mass, force * ny / mass, force * lever / inertia)

    def advanced(s, h):
        a = rates(s)
        b = rates([x + 0.5 * h * r for x, r in zip(s, a)])
        c = rates([x + 0.5 * h * r for x, r in zip(s, b)])
        d = rates([x + h * r for x, r in zip(s, c)])
        return [x + h / 6 * (p + 2 * q + 2 * r + t) for x, p, q, r, t in zip(s, a, b, c, d)]

    state = advanced([-radius, -arm, 0.0, speed, 0.0, 0.0], dt)
    while pushed(advanced(state, dt))[0] > 0:
        state = advanced(state, dt)
    last = root(lambda h: pushed(advanced(state, h))[0], 0.0, dt)
    _, _, _, vx, vy, w = advanced(state, last)
    return vx, vy, w


def damped_slip(radius, mass, kn, kt, eta, friction, normal_speed, slip, steps=20000):
    """Slip of the surface after an oblique impact with dashpots (eta along both directions) under the cap mu F_n.

    In the limit of small steps: closed normal motion, and in each of many small steps the friction of spring and
    dashpot, or the cap, which the spring alone then carries (first order in the step).
    """
    normal, damping = Impact(mass, kn, eta, normal_speed), 2 * eta * sqrt(mass * kt)
    inertia, dt = 0.4 * mass * radius**2, normal.end / steps
    v, w, spring = slip, 0.0, 0.0
    for n in range(steps):
        t = (n + 0.5) * dt
        arm, cap = radius - 0.5 * normal.overlap(t), friction * mass * max(0.0, normal.force(t))
        force = -kt * spring - damping * (v + arm * w)
        if abs(force) > cap:
            force = cap if force > 0 else -cap
            spring = -force / kt
        v, w = v + dt * force / mass, w + dt * force * arm / inertia
        spring += dt * (v + arm * w)
    return v + radius * w


def schiller_naumann(diameter, viscosity, density, slip):
    """Drag on a sphere in a gas that passes it at `slip` (m/s), N: C rho/2 slip^2 pi/4 d^2 with
    C = 24/Re (1 + 0.15 Re^0.687)."""
    reynolds = density * diameter * abs(slip) / viscosity
    return 3 * pi * viscosity * diameter * slip * (1 + 0.15 * reynolds**0.687)


def in_gas(mass, weight, drag, stream, times, steps=200):
    """Heights and velocities at `times` (s, rising) of a sphere that is let go at 0 in a gas that streams
    upwards.

    `drag(slip)`, N; Runge-Kutta's fourth order in `steps` steps between two of them.
    """
    y, v, begin, found = 0.0, 0.0, 0.0, []

    def rate(velocity):
        return (drag(stream - velocity) - weight) / mass

    for end in times:
        dt, begin = (end - begin) / steps, end
        for _ in range(steps):
            a = rate(v)
            b = rate(v + 0.5 * dt * a)
            c = rate(v + 0.5 * dt * b)
            d = rate(v + dt * c)
            y += dt * (v + dt / 6 * (a + b + c))
            v += dt / 6 * (a + 2 * b + 2 * c + d)
        found.append((y, v))
    return found


def stacked(y, v, seconds, masses, radius, stiffness, etas, height, gravity, steps=20000):
    """Two spheres, one on the other, squeezed between walls at 0 and `height`: positions after `seconds`.

    The motion is linear as long as all three contacts push; Runge-Kutta's fourth order in `steps` steps.
    `etas`: of floor, pair, ceiling, with the effective masses m1, m1 m2/(m1+m2), m2.
    """
    m1, m2 = masses
    c_floor, c_pair, c_ceiling = (2 * eta * sqrt(m * stiffness)
                                  for eta, m in zip(etas, (m1, m1 * m2 / (m1 + m2), m2)))

    def rates(s):
        y1, y2, v1, v2 = s
        floor = stiffness * (radius - y1) - c_floor * v1
        pair = stiffness * (2 * radius - y2 + y1) - c_pair * (v2 - v1)
        ceiling = stiffness * (radius - height + y2) + c_ceiling * v2
        return v1, v2, (floor - pair) / m1 - gravity, (pair - ceiling) / m2 - gravity

    state, dt = (*y, *v), seconds / steps
    for _ in range(steps):
        a = rates(state)
        b = rates([s + 0.5 * dt * r for s, r in zip(state, a)])
        c = rates([s + 0.5 * dt * r for s, r in zip(state, b)])
        d = rates([s + dt * r for s, r in zip(state, c)])
        state = [s + dt / 6 * (p + 2 * q + 2 * r + t) for s, p, q, r, t in zip(state, a, b, c, d)]
    return state[:2]


# Averaging kernels that end at a radius c: how many standard deviations (along an axis) c is, and their value
# in the middle times c^D. Lucy's is (1 + 3 q)(1 - q)^3, q = r / c; Heaviside's is even.
KERNEL_RADIUS = {("lucy", 2): sqrt(56 / 5), ("lucy", 3): sqrt(12), ("heaviside", 2): 2.0,
                 ("heaviside", 3): sqrt(5)}
KERNEL_PEAK = {("lucy", 2): 5 / pi, ("lucy", 3): 105 / (16 * pi), ("heaviside", 2): 1 / pi,
               ("heaviside", 3): 3 / (4 * pi)}
LUCY_LINE = 21 / (4 * pi)  # integral along a line through the middle, in space, times c^2


def gaussian_peak(scale, dimension, cut=None):
    """Of a Gaussian of the standard deviation `scale`, in the middle; `cut` off (2D, 3D) at so many of it."""
    if cut is None:
        kept = 1.0
    elif dimension == 2:
        kept = 1 - exp(-cut**2 / 2)
    else:
        kept = erf(cut / sqrt(2)) - sqrt(2 / pi) * cut * exp(-cut**2 / 2)
    return (2 * pi * scale**2)**(-dimension / 2) / kept


def gaussian_line(scale, length):
    """Integral of a Gaussian in space along a line of this length whose middle is its own."""
    return erf(length / (2 * sqrt(2) * scale)) / (2 * pi * scale**2)


def gaussian_between(scale, below, above):
    """Share of a Gaussian that lies between two planes, at these distances to either side of its middle."""
    return 0.5 * (erf(below / (sqrt(2) * scale)) + erf(above / (sqrt(2) * scale)))
