# SPDX-License-Identifier: GPL-2.0-or-later
"""A small form of the benchmarks that have closed forms, as tests of the suite.

With h = omega dt = pi / N at N steps per contact, order 3 changes an undamped amplitude by -3/8 h^4 a step, so by
3 pi / 8 h^3 in a contact (theory.md, "Energy of an undamped contact"). That is the scale of all bounds here.
"""
import os
import sys
import unittest
from math import exp, log2, pi, sqrt
from pathlib import Path

sys.dont_write_bytecode = True

import chung_ooi  # noqa: E402
import laws  # noqa: E402
import mercurydpm_fields  # noqa: E402
import mfix  # noqa: E402
import schwager_poeschel  # noqa: E402
import spheral  # noqa: E402
import thornton  # noqa: E402
import vyas  # noqa: E402
from scene import ORDER_4, OURS, Method, Runner, sphere, spring_scene  # noqa: E402

REPOSITORY = Path(__file__).resolve().parents[3]
RUN = Runner(Path(os.environ.get("RODPACK_BIN", REPOSITORY / "build" / "bin"), "liggghts").resolve())


def lost_in_contact(steps_per_contact):
    """Fraction of an undamped amplitude that order 3 loses in a contact."""
    return 3 * pi / 8 * (pi / steps_per_contact)**3


GROSS_ETA = 0.5


def gross_sliding(method, cap, steps_per_contact):
    """A sphere that slides all through an impact: what it loses along the wall, over mu v_n, and gains across, over v_n."""
    radius, stiffness, friction, speed, slip = 1.5e-3, 2000, 0.3, 0.5, 5.0
    dt = laws.contact_time(stiffness, laws.sphere_mass(radius, 2500)) / steps_per_contact
    ball = sphere(y=radius + 3.37 * dt * speed, vy=-speed, vx=slip, radius=radius)
    count = 3 * steps_per_contact
    scene = spring_scene([ball], dt, count, every=count, kn=stiffness, kt=1000, eta_n=GROSS_ETA, eta_t=GROSS_ETA,
                         mu=friction, walls=1, half=0.1, cap=cap)
    end = RUN(scene, method)[-1][1][0]
    return (slip - end["vx"]) / (friction * speed), (end["vy"] + speed) / speed


def simpson(function, end, steps=2000):
    """Integral from 0 to `end`."""
    weights = [1, *[4, 2] * (steps // 2 - 1), 4, 1]
    return end / steps / 3 * sum(w * function(n * end / steps) for n, w in enumerate(weights))


class Laws(unittest.TestCase):
    """The references themselves."""

    def test_restitution_without_tension_is_that_of_the_path(self):
        for eta in 0.05, 0.2, 0.5, 0.9:
            closed = laws.restitution_without_tension(eta)
            self.assertAlmostEqual(laws.Impact(1.0, 1.0, eta, 1.0).end_speed, closed, delta=1e-12)
            self.assertAlmostEqual(laws.damping_ratio_without_tension(closed), eta, delta=1e-12)

    def test_restitution_has_the_values_of_schwager_and_poeschel(self):
        for eta, published in (0.05, 0.858758), (0.1, 0.744079), (0.2, 0.571740), (0.3, 0.450975), (0.5, 0.298436):
            self.assertAlmostEqual(laws.restitution_without_tension(eta), published, delta=5e-7)

    def test_an_impact_with_tension_has_the_other_restitution(self):
        eta = laws.damping_ratio_with_tension(0.7)
        self.assertAlmostEqual(laws.Impact(1.0, 1.0, eta, 1.0, tension=True).end_speed, 0.7, delta=1e-12)

    def test_hertz_with_its_dashpot_rebounds_like_the_linear_law(self):
        # d'' = -d^(3/2) - sqrt(5) eta d^(1/4) d' until its force is zero, by Runge-Kutta. It starts a little
        # behind touch, where d = t and the dashpot has taken 4/5 sqrt(5) eta d^(5/4) off the speed.
        for told in 0.4, 0.8:
            eta = laws.damping_ratio_with_tension(told)

            def force(d, v):
                return -d**1.5 - sqrt(5) * eta * d**0.25 * v

            d, dt = 1e-9, 1e-4
            v = 1 - 0.8 * sqrt(5) * eta * d**1.25
            while force(d, v) < 0:
                a = v, force(d, v)
                b = v + 0.5 * dt * a[1], force(d + 0.5 * dt * a[0], v + 0.5 * dt * a[1])
                c = v + 0.5 * dt * b[1], force(d + 0.5 * dt * b[0], v + 0.5 * dt * b[1])
                e = v + dt * c[1], force(d + dt * c[0], v + dt * c[1])
                before = v
                d, v = (x + dt / 6 * (p + 2 * q + 2 * r + s) for x, p, q, r, s in zip((d, v), a, b, c, e))
            # The root d^(1/4) at touch limits the order to 5/4.
            self.assertAlmostEqual(-before, laws.hertz_restitution(told), delta=5 * dt**1.25)
            self.assertAlmostEqual(laws.hertz_input_for(laws.hertz_restitution(told)), told, delta=1e-12)

    def test_two_unequal_spheres_share_the_impulse_of_the_cap(self):
        # Sliding all through, the slip loses (1/m1 + 1/m2)(1 + 5/2) times 2 mu v m, m the reduced mass, for
        # thin overlaps.
        radius, mass, speed, friction = 1.0, 1.0, 1e-6, 0.1
        rebound = laws.ObliqueImpact(radius, mass, 1.0, 1.0, friction, speed, 1.0, partner=(1.5, 3.0))
        lost = 1.0 - rebound.velocity - rebound.spins[0] - 1.5 * rebound.spins[1]
        self.assertAlmostEqual(lost / (7 * friction * speed), 1.0, delta=1e-6)
        self.assertAlmostEqual(rebound.spins[1] / rebound.spins[0], 1 / 1.5 / 3, delta=1e-6)

    def test_a_partner_that_cannot_move_is_a_wall(self):
        duration, _ = laws.hertz_duration(1.0, 1.0, 0.75, 0.01)
        wall, heavy = (laws.ObliqueImpact(1.0, 1.0, 1.0, 0.8, 0.3, 0.01, 0.004, exponent=0.5,
                                          duration=duration, partner=partner) for partner in (None, (5.0, 1e15)))
        self.assertAlmostEqual(heavy.spin, wall.spin, delta=1e-14)

    def test_dumbbells_that_meet_off_centre_tend_to_the_impulse_of_rigid_bodies(self):
        # While a stiff contact lasts the bodies turn by an angle of the order k^(-1/2), which changes the
        # line of impact to and fro: what is left is of second order in that angle, 1/k. Undamped, energy is
        # kept at any stiffness.
        mass, inertia, spacing, radius = 0.5, 0.02, 0.25, 0.25
        push = laws.impulse([mass] * 2, [inertia] * 2, [0.5 * spacing] * 2, 2.0, 1.0)
        stiff, off = (1.0 - push / mass, 0.5 * spacing * push / inertia), []
        for stiffness in 1e4, 1e5:
            vx, vy, spin = laws.parallel_dumbbells(mass, inertia, spacing, radius, stiffness, 0.0, 1.0)
            self.assertAlmostEqual(mass * (vx**2 + vy**2) + inertia * spin**2, mass, delta=1e-11)
            off.append((vx - stiff[0], spin - stiff[1]))
        for coarse, fine in zip(*off):
            self.assertAlmostEqual(coarse / fine, 10.0, delta=0.1)

    def test_a_sphere_in_a_gas_has_stokes_motion_and_the_terminal_velocity(self):
        # Linear drag c u: v = v_t (1 - exp(-c t / m)), v_t = stream - weight / c. Without density the drag is
        # Stokes'.
        c = laws.schiller_naumann(2.0, 0.1, 0.0, 1.0)
        self.assertAlmostEqual(c, 3 * pi * 0.1 * 2.0, delta=1e-15)
        times = [0.5, 1.0]
        for t, (y, v) in zip(times, laws.in_gas(1.0, 3.0, lambda u: c * u, 0.4, times)):
            terminal = 0.4 - 3.0 / c
            self.assertAlmostEqual(v, terminal * (1 - exp(-c * t)), delta=1e-11)
            self.assertAlmostEqual(y, terminal * (t - (1 - exp(-c * t)) / c), delta=1e-11)
        weight = mfix.GRAIN_MASS * 9.8
        (_, v), = laws.in_gas(mfix.GRAIN_MASS, weight, mfix.grain_drag, 0.4, [3.0], 6000)
        self.assertAlmostEqual(mfix.grain_drag(0.4 - v) / weight, 1.0, delta=1e-12)

    def test_kernels_are_normalised_and_have_their_standard_deviation(self):
        # Simpson's rule in the distance, weighted by the circle or sphere; the variance of the distance is D
        # scale^2. Up to its radius Lucy's kernel is a polynomial of degree 4, times at most q^4 here; the
        # Gaussian is smooth.
        profiles = {"lucy": lambda q: (1 + 3 * q) * (1 - q)**3, "heaviside": lambda q: 1.0}
        kernels = [(dimension, radius, lambda r, peak=laws.KERNEL_PEAK[kernel, dimension] / radius**dimension,
                    radius=radius, kernel=kernel: peak * profiles[kernel](r / radius))
                   for (kernel, dimension), radius in laws.KERNEL_RADIUS.items()]
        kernels += [(dimension, cut, lambda r, peak=laws.gaussian_peak(1, dimension, cut): peak * exp(-r**2 / 2))
                    for dimension in (2, 3) for cut in (3.0, 9.0)]
        for dimension, radius, kernel in kernels:
            shell = {2: 2 * pi, 3: 4 * pi}[dimension]
            moments = [simpson(lambda r: shell * r**power * kernel(r), radius)
                       for power in (dimension - 1, dimension + 1)]
            self.assertAlmostEqual(moments[0], 1.0, delta=1e-11)
            if radius != 3:  # a Gaussian that is cut there has less
                self.assertAlmostEqual(moments[1] / dimension, 1.0, delta=1e-11)

    def test_kernels_have_their_integral_along_a_line(self):
        peak = laws.KERNEL_PEAK["lucy", 3]
        line = 2 * simpson(lambda q: peak * (1 + 3 * q) * (1 - q)**3, 1.0)
        self.assertAlmostEqual(line, laws.LUCY_LINE, delta=1e-11)

        def half(end, dimension):
            return simpson(lambda r: laws.gaussian_peak(1, dimension) * exp(-r**2 / 2), end)

        self.assertAlmostEqual(2 * half(0.7, 3), laws.gaussian_line(1, 1.4), delta=1e-12)
        self.assertAlmostEqual(half(2.0, 1) - half(1.0, 1), laws.gaussian_between(1, 2.0, -1.0), delta=1e-12)

    def test_gross_sliding_has_the_impulse_of_the_cap(self):
        # mu k d integrated is 2 mu m v; its moment at the lever r - d/2 lacks mu k / 2 times the integral of d^2.
        radius, mass, speed, friction = 1.0, 1.0, 1e-3, 0.1
        impact = laws.ObliqueImpact(radius, mass, 1.0, 1.0, friction, speed, 1.0)
        self.assertAlmostEqual(1.0 - impact.velocity, 2 * friction * speed, delta=1e-12)
        expected = -2.5 * friction * speed * (2 * radius - pi / 4 * speed)
        self.assertAlmostEqual(impact.spin, expected, delta=1e-8 * abs(expected))


class Page(unittest.TestCase):
    def test_the_deck_of_the_contact_models_page_turns_restitution_into_damping(self):
        page = (REPOSITORY / "liggghts-src-ext/doc/gran_model_spring_dashpot.md").read_text()
        deck = page[page.index("variable   e equal"):page.index("fix        dn")]
        for restitution in 0.2, 0.5, 0.9:
            text = deck.replace("e equal 0.5", f"e equal {restitution}") + 'print "found ${eta}"\n'
            found = float(RUN.output_of(text).rsplit("found ", 1)[1].split()[0])
            exact = laws.damping_ratio_without_tension(restitution)
            self.assertAlmostEqual(found, exact, delta=1e-12 * exact)


class ClosedForms(unittest.TestCase):
    def test_an_undamped_bounce_loses_the_energy_that_the_order_loses(self):
        # 3/4 pi h^3 of it at order 3. The next term of the error is smaller by h, and so is all of order 4.
        steps = 50 * sqrt(2)
        lost = {}
        for method in OURS, ORDER_4:
            apexes = mfix.apexes(mfix.drop(RUN, method, 5e4, 0.0, steps, 0.7 * 14, every=5))
            lost[method] = (0.5 - apexes[13]) / 13 / 0.4
        expected, h = 0.75 * pi**4 / steps**3, pi / steps
        self.assertAlmostEqual(lost[OURS] / expected, 1.0, delta=h)
        self.assertAlmostEqual(lost[ORDER_4] / expected, 0.0, delta=h)

    def test_restitution_converges_in_third_order(self):
        for eta in 0.1, 0.3:
            coarse, fine = (schwager_poeschel.restitution_error(RUN, OURS, eta, n) for n in (30, 60))
            self.assertLess(coarse, lost_in_contact(30))
            self.assertAlmostEqual(log2(coarse / fine), 3, delta=0.3)

    def test_friction_outlives_the_normal_force(self):
        # Sliding all through: mu k times the integral of the overlap to its end, behind the end of the force in flight
        # at e w, is mu m w (1 + e - 2 eta^2 e); with the cap mu F_n it is mu m w (1 + e), Thornton et al.'s rebound.
        steps, e = 60, laws.restitution_without_tension(GROSS_ETA)
        for cap, exact in ("off", 1 + e - 2 * GROSS_ETA**2 * e), ("on", 1 + e):
            lost, _ = gross_sliding(OURS, cap, steps)
            self.assertAlmostEqual(lost, exact, delta=lost_in_contact(steps))

    def test_friction_under_the_total_cap_is_mu_times_the_normal_impulse(self):
        # Whatever the integrator makes of the normal force, its events too: it makes the same of friction, to rounding.
        # The elastic cap is below on the way in and above on the way out, and lacks a tenth of it in the end.
        methods = [Method(name, name, bodies, "spring_dashpot") for name, bodies in
                   (("nve/sphere", 0), ("multisphere", 1), ("multisphere/ab order 3 events no", 1),
                    *((f"multisphere/ab order {n}", 1) for n in (1, 2, 3, 4)),
                    *((f"nve/sphere/ab order {n}", 0) for n in (1, 2, 3, 4)))]
        for method in methods:
            lost, gained = gross_sliding(method, "on", 30)
            self.assertAlmostEqual(lost / gained, 1.0, delta=1e-13, msg=method.name)
        lost, gained = gross_sliding(OURS, "off", 30)
        self.assertLess(lost / gained, 0.9)

    def test_oblique_impacts_under_the_total_cap_approach_their_limit(self):
        # Stuck from touch on, sliding first and last, sliding all through: the mean over all phases of touch, against
        # the reference, whose error is of first order in 1/20000 of the impact; and its spread, of third order but for
        # a few moments of touch where several changes meet in a step. Compared over mu v_n.
        eta = laws.damping_ratio_without_tension(0.5)
        unit = thornton.FRICTION * thornton.SPEED
        for psi, delta in (1, 0.2), (3, 0.4), (6, 0.2):
            exact = laws.damped_slip(thornton.RADIUS, thornton.MASS, thornton.STIFFNESS,
                                     thornton.RATIO * thornton.STIFFNESS, eta, thornton.FRICTION, thornton.SPEED,
                                     psi * unit) / unit
            spreads = []
            for steps in 120, 480:
                found = thornton.slips(RUN, OURS, psi, eta, steps, "on")
                self.assertAlmostEqual(sum(found) / len(found), exact, delta=1e-3, msg=f"{psi}, {steps} steps")
                spreads.append(max(found) - min(found))
            self.assertAlmostEqual(log2(spreads[0] / spreads[1]) / 2, 3, delta=delta, msg=f"{psi}")

    def test_friction_acts_half_way_into_the_overlap_at_a_wall(self):
        radius, density, stiffness, friction, speed, steps = 2.5e-3, 4000, 1.72e7, 0.092, 2.0, 100
        mass = laws.sphere_mass(radius, density)
        dt = laws.contact_time(stiffness, mass) / steps
        ball = sphere(y=radius + 3.37 * dt * speed, vy=-speed, vx=5.0, radius=radius, density=density)
        scene = spring_scene([ball], dt, 2 * steps, every=2 * steps, kn=stiffness, kt=0.86 * stiffness, mu=friction,
                             walls=1, half=0.05, skin=radius)
        depth = speed * sqrt(mass / stiffness)
        spin = 2.5 * friction * speed * (2 * radius - pi / 4 * depth) / radius**2
        found = -RUN(scene, OURS)[-1][1][0]["omegaz"] / spin
        # A lever r would be off by pi/8 of the depth over the radius.
        self.assertGreater(pi / 8 * depth / radius, 10 * lost_in_contact(steps))
        self.assertAlmostEqual(found, 1.0, delta=lost_in_contact(steps))

    def test_fields_of_a_few_particles_meet_mercurydpms_checks(self):
        # Where MercuryDPM has a bound that is it, but for the roundings of sums over thousands of places in
        # files of 15 digits; elsewhere that of the column's overlaps, 1e-16 / 5e-5 and some more.
        for scene in mercurydpm_fields.SCENES:
            for row in scene(RUN):
                for found in (row.ours, row.rodpack):
                    if found is not None:
                        self.assertAlmostEqual(found / row.exact, 1.0, delta=max(row.bound or 1e-11, 3e-14),
                                               msg=f"{scene.__name__}: {row.measure}")

    def test_a_composite_meets_a_sphere_with_the_restitution_of_its_whole_mass(self):
        restitution, duration, momentum = spheral.head_on(RUN, ORDER_4, 0.8, 50)
        self.assertLess(restitution, lost_in_contact(50) * pi / 50)
        self.assertLess(momentum, 1e-13)
        _, duration, _ = spheral.head_on(RUN, ORDER_4, 1.0, 50)
        self.assertLess(duration, lost_in_contact(50))

    def test_composites_that_meet_off_centre_share_the_impulse_in_third_order(self):
        stiffness = spheral.STIFFNESS * spheral.OFF_CENTRE_MASS
        damping = 2 * laws.damping_ratio_without_tension(0.8) * sqrt(stiffness)
        exact, _, spin = laws.parallel_dumbbells(spheral.PAIR_MASS, spheral.INERTIA, spheral.SPACING,
                                                 spheral.RADIUS, spheral.STIFFNESS, damping, spheral.SPEED)
        errors = []
        for steps in 30, 60:
            eta = damping / (2 * sqrt(spheral.STIFFNESS * 0.5 * spheral.PAIR_MASS))
            velocities, spins, _ = spheral.off_centre(RUN, OURS, eta, steps)
            errors.append(spheral.root_mean_square([v - exact for v in velocities]))
            self.assertLess(spheral.root_mean_square([w / spin - 1 for w in spins]), lost_in_contact(steps))
        self.assertAlmostEqual(log2(errors[0] / errors[1]), 3, delta=0.3)

    def test_hertz_rebounds_as_it_has_been_told_for_the_contact_without_tension(self):
        # Test 3 of Chung and Ooi. At 100 steps per contact what the kink of touch leaves is below 1e-3.
        contact, _ = laws.hertz_duration(0.0025, laws.sphere_mass(0.0025, 4000), 1e10, 3.9)
        for restitution in 0.8, 0.4:
            _, _, rebound = chung_ooi.impact(RUN, OURS._replace(law="hertz"), 100, contact, 0.0025, 4000,
                                             2e10 * 0.91, 0.3, 3.9, laws.hertz_input_for(restitution), False)
            self.assertAlmostEqual(rebound / 3.9, restitution, delta=1e-3)

    def test_two_unequal_spheres_that_slide_all_through_lose_mu_times_the_normal_impulse(self):
        # Test 8 of Chung and Ooi with e = 0.5: 7/2 mu (1 + e) v_n of the slip, whatever the masses. The lever
        # r - d/2 takes 5/7 of d/(2 r) off, 2e-4 here.
        lost, slip = 3.5 * chung_ooi.FRICTION * 1.5 * chung_ooi.SPEED, 1.0
        for partner in chung_ooi.HEAVY, chung_ooi.LIGHT:
            left = chung_ooi.slip_after(RUN, OURS._replace(law="hertz_spring"), 100, partner, 0.0, slip,
                                        cap="on", restitution=laws.hertz_input_for(0.5))
            self.assertAlmostEqual((slip - left) / lost, 1.0, delta=1e-3)

    def test_a_grain_in_a_gas_is_followed_in_third_order(self):
        coarse, fine = (mfix.errors_in_gas(RUN, OURS, dt)[0] for dt in (1e-3, 0.5e-3))
        self.assertAlmostEqual(log2(coarse / fine), 3, delta=0.3)

    def test_two_stacked_particles_follow_their_linear_motion(self):
        radius, height, stiffness, gravity, seconds = 0.5e-3, 1.8e-3, 1e3, mfix.GRAVITY, 1e-3
        masses = [laws.sphere_mass(radius, d) for d in (2e4, 1e4)]
        start = 0.25 * height, 0.75 * height
        exact = laws.stacked(start, (0, 0), seconds, masses, radius, stiffness, (0.1,) * 3, height, gravity)
        errors = []
        for steps in 250, 500:
            spheres = [sphere(y=y, radius=radius, density=d) for y, d in zip(start, (2e4, 1e4))]
            scene = spring_scene(spheres, seconds / steps, steps, kn=stiffness, kt=stiffness, eta_n=0.1, gy=-gravity,
                                 walls=2, floor=0, ceiling=height, half=0.01, skin=1e-4)
            time, states = RUN(scene, OURS)[-1]
            self.assertAlmostEqual(time, seconds, delta=1e-12)
            errors.append(abs(states[1]["y"] - exact[1]))
        self.assertAlmostEqual(log2(errors[0] / errors[1]), 3, delta=0.3)

    def test_a_sphere_that_bobs_stops_slipping_when_its_friction_has_stopped_it(self):
        # Bobbing decays by 3/8 h^4 a step; the slip's end moves by less than what is lost of its last swing.
        friction = 0.6
        exact, dimensionless, omega = mfix.slip_end(friction)
        found = mfix.measured_slip_end(RUN, OURS, friction, exact, 50)
        count = exact / (pi / omega / 50)
        bound = friction * mfix.GRAVITY / 0.1 / omega * 3 / 8 * (pi / 50)**4 * count
        self.assertAlmostEqual(found, dimensionless, delta=bound)

    def test_a_grain_rolls_off_two_large_ones_and_falls(self):
        # Read off between frames that are exact/500 apart, along a motion that grows like exp(rate t): the chord is off
        # by rate (exact/500)^2 / 8 in time.
        ratio = 10
        small = vyas.LARGE / ratio
        exact = vyas.rolling_time(small, vyas.FROM, vyas.TO)
        step = laws.contact_time(vyas.STIFFNESS, laws.sphere_mass(small, vyas.DENSITY)) / 30
        time, falls = vyas.roll(RUN, OURS, ratio, step, 4 * exact)
        rho = sqrt((vyas.LARGE + small)**2 - vyas.LARGE**2)
        rate = sqrt(vyas.GRAVITY * rho / (rho**2 + 0.4 * (vyas.LARGE + small)**2))
        self.assertAlmostEqual(time / exact, 1.0, delta=rate * exact / 500**2 / 8)
        self.assertTrue(falls)


if __name__ == "__main__":
    unittest.main()
