// SPDX-License-Identifier: GPL-2.0-or-later
// The cap of friction that has the whole normal force in it, over the life of a contact: against
// closed forms of touch, slide, end and return. Of the elastic cap: tangential_history_test.cpp.
#include "rodpack/contact/friction_cap.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rodpack/contact/tangential_history.h"
#include "sample_contact.h"

namespace rodpack {
namespace {

const double dt = 1e-5, k = 1000, c = 0.4, mu = 0.3, kt = 500, gamma_t = 0.3;
const int slots = 3;
const TangentialStep step = {3, 1000, dt};

/// On the floor y = 0; it moves along x and leaves at `separation`.
SampleContact on_the_move(double overlap, double vx, double separation) {
  SampleContact contact = on_floor(overlap, vx, separation);
  contact.kn = k;
  contact.gamman = c;
  contact.kt = kt;
  contact.gammat = gamma_t;
  return contact;
}

double normal_force_of(const SampleContact& contact) {
  return viscoelastic_force(k, contact.deltan, c, contact.vn);
}

/// The speed of separation at which spring and dashpot push with `force`.
double separation_for(double force, double overlap) { return (k * overlap - force) / c; }

struct Friction {
  TangentialHistory history{slots};
  CapHistory cap;
  RecordedEvents told;

  /// Evaluated one step ago under the normal force `before`, with this spring, at the speed v.
  void lives(double before, double spring, double v, bool sliding) {
    history.spring[0] = spring;
    for (int n = 0; n < slots; ++n) history.velocity[n][0] = v;
    history.known = slots + 1;
    history.step = step.now - 1;
    history.sliding = sliding;
    cap.normal.viscoelastic = before;
  }

  TangentialForce evaluate(const SampleContact& contact, bool renewed = true) {
    return tangential_contact_force(contact, history, TotalCap(mu, normal_force_of(contact), cap),
                                    renewed, step, static_cast<const RecordedEvents*>(&told),
                                    &told);
  }
};

void expect_change(const ForceChange& change, double now, double rate, double impulse,
                   double integral) {
  expect_component(change, 0, 1e-9, now, rate, impulse, integral);
  for (int d : {1, 2}) EXPECT_EQ(change.now[d], 0);
}

}  // namespace

// A closing dashpot raises the cap above mu k delta, an opening one lowers it; where the normal
// force is cut off at 0 there is none.
TEST(TotalCap, IsThatOfTheWholeNormalForce) {
  const double overlap = 2e-5;
  for (const double separation : {-0.02, 0.0, 0.02, 0.2}) {
    Friction friction;
    friction.lives(0.02, 1e-3, 1, true);
    const SampleContact contact = on_the_move(overlap, 1, separation);
    const double cap = mu * std::max(0.0, k * overlap - c * separation);
    EXPECT_NEAR(friction.evaluate(contact).force[0], -cap, 1e-15) << separation;
    EXPECT_EQ(cap > 0, separation < 0.1);
    EXPECT_NEAR(friction.history.spring[0], cap / kt, 1e-17);
    EXPECT_NEAR(friction.evaluate(contact, false).force[0], -cap, 1e-15);  // without a trace
  }
}

// Of two evaluations its rate is their difference, right for any force that is linear in time.
TEST(TotalCap, HasTheRateOfTheNormalForce) {
  const SampleContact contact = on_the_move(2e-5, 1, -0.03);
  const double now = k * 2e-5 + c * 0.03;
  for (const double before : {0.0301, 0.0323, -0.004}) {
    CapHistory history;
    history.normal.viscoelastic = before;
    TotalCap cap(mu, now, history);
    cap.renew(contact, true, dt, static_cast<const RecordedEvents*>(nullptr));
    EXPECT_NEAR(cap.now(contact), mu * now, 1e-16);
    EXPECT_NEAR(cap.rate(contact, dt), mu * (now - std::max(0.0, before)) / dt, 1e-9);
    EXPECT_EQ(history.normal.viscoelastic, now);
  }
}

// Too fast to stick, touched s ago at the closing speed w: friction is mu (k w t + c w) since then.
TEST(TotalCap, SlidingFrictionJumpsAtTouchByTheDashpot) {
  const double w = 0.2, s = 0.7 * dt;
  Friction friction;
  EXPECT_TRUE(friction.evaluate(on_the_move(w * s, 5, -w)).sliding);
  ASSERT_EQ(friction.told.events.size(), 1u);
  EXPECT_TRUE(friction.told.events[0].jumps);
  expect_change(friction.told.events[0].on_i, -mu * (k * w * s + c * w), -mu * k * w,
                -mu * (k * w * s * s / 2 + c * w * s),
                -mu * (k * w * s * s * s / 6 + c * w * s * s / 2));
}

// At touch the dashpots alone decide, gamma_t v against mu c w. Here that is too much by a tenth,
// and the contact slides, until it stands still: although at the end of the step the cap, which
// grows by mu k w per second, is above spring and dashpot.
TEST(TotalCap, AContactThatSlidAtTouchSlidesOn) {
  const double w = 0.2, v = 1.1 * mu * c * w / gamma_t;
  for (const double share : {0.1, 0.9}) {
    const double s = share * 20 * dt;
    const TangentialStep long_step = {3, 1000, 20 * dt};
    const SampleContact contact = on_the_move(w * s, v, -w);
    const double cap = mu * (k * w * s + c * w);
    EXPECT_EQ(kt * v * s + gamma_t * v > cap, share == 0.1);
    Friction friction;
    const TangentialForce force = tangential_contact_force(
        contact, friction.history, TotalCap(mu, normal_force_of(contact), friction.cap), true,
        long_step, static_cast<const RecordedEvents*>(&friction.told), &friction.told);
    EXPECT_TRUE(force.sliding);
    EXPECT_NEAR(force.force[0], -cap, 1e-14);
    ASSERT_EQ(friction.told.events.size(), 1u);
    EXPECT_NEAR(friction.told.events[0].on_i.rate[0], -mu * k * w, 1e-9);
  }
}

// The elastic cap would let the same contact slide: mu k w s = 4.2e-4 N. Spring and dashpot are
// those of a contact that sticks.
TEST(TotalCap, AContactSticksAtTouchWhereTheDashpotsAllowIt) {
  const double w = 0.2, s = 0.7 * dt, v = 0.05;
  ASSERT_GT(gamma_t * v, mu * k * w * s);
  Friction friction;
  EXPECT_FALSE(friction.evaluate(on_the_move(w * s, v, -w)).sliding);
  ASSERT_EQ(friction.told.events.size(), 1u);
  expect_change(friction.told.events[0].on_i, -(kt * v * s + gamma_t * v), -kt * v,
                -(kt * v * s * s / 2 + gamma_t * v * s),
                -(kt * v * s * s * s / 6 + gamma_t * v * s * s / 2));
}

// The normal force goes from a > 0 to -b < 0 along a straight line, through 0 s ago; friction would
// have turned round with it, -mu (-b), and is gone instead: D = -mu (b/s) t.
TEST(TotalCap, FrictionEndsWithTheNormalForce) {
  const double overlap = 2e-6, a = 0.001, b = 0.003, s = dt * b / (a + b);
  Friction friction;
  friction.lives(a, mu * a / kt, 1, true);
  const TangentialForce force =
      friction.evaluate(on_the_move(overlap, 1, separation_for(-b, overlap)));
  EXPECT_EQ(force.force[0], 0);
  EXPECT_EQ(friction.history.spring[0], 0);
  ASSERT_EQ(friction.told.events.size(), 1u);
  EXPECT_FALSE(friction.told.events[0].jumps);
  expect_change(friction.told.events[0].on_i, -mu * b, -mu * b / s, -mu * b * s / 2,
                -mu * b * s * s / 6);

  // From then on nothing more happens.
  friction.told.events.clear();
  friction.history.step = step.now - 1;
  EXPECT_EQ(friction.evaluate(on_the_move(overlap, 1, separation_for(-b, overlap))).force[0], 0);
  EXPECT_TRUE(friction.told.events.empty());
}

// The same where both the force and the overlap end in one step: the constants come from the
// history. A force that ended before has had its event.
TEST(TotalCap, FrictionEndsWithAContactThatOpens) {
  const double a = 0.001, vn = 0.01, overlap = -1e-8, b = c * vn - k * overlap;
  const double s = dt * b / (a + b);
  for (const bool ended : {false, true}) {
    Friction friction;
    friction.lives(ended ? -a : a, ended ? 0 : mu * a / kt, 1, true);
    friction.cap.stiffness = k;
    friction.cap.damping = c;
    end_tangential_force(on_the_move(overlap, 1, vn), friction.history,
                         TotalCap(mu, 0, friction.cap), step, friction.told);
    ASSERT_EQ(friction.told.events.size(), ended ? 0u : 1u);
    if (!ended)
      expect_change(friction.told.events[0].on_i, -mu * b, -mu * b / s, -mu * b * s / 2,
                    -mu * b * s * s / 6);
  }
}

// Pressed on again, from -b to a: friction begins anew, as if it had touched s ago, whatever the
// spring has been; sliding it grows with the cap from nothing.
TEST(TotalCap, FrictionBeginsAnewWithTheNormalForce) {
  const double overlap = 2e-6, a = 0.003, b = 0.001, s = dt * a / (a + b);
  for (const double v : {1.0, 1e-4}) {
    Friction friction;
    friction.lives(-b, 0, v, true);
    const TangentialForce force =
        friction.evaluate(on_the_move(overlap, v, separation_for(a, overlap)));
    ASSERT_EQ(force.sliding, v == 1.0);
    const double stuck = kt * v * s + gamma_t * v;
    EXPECT_NEAR(force.force[0], v == 1.0 ? -mu * a : -stuck, 1e-15);
    EXPECT_NEAR(friction.history.spring[0], v == 1.0 ? mu * a / kt : v * s, 1e-18);
    ASSERT_EQ(friction.told.events.size(), 1u);
    if (v == 1.0)
      expect_change(friction.told.events[0].on_i, -mu * a, -mu * a / s, -mu * a * s / 2,
                    -mu * a * s * s / 6);
  }
}

// The bodies' motion along the normal has jumped, by the acceleration a, the velocity v and the way
// x at the end of the last step: the normal dashpot has felt it, and with it a slide.
TEST(TotalCap, ASlideFeelsWhatTheNormalDashpotFeels) {
  const double a = 300, v = 2e-3, x = 1e-8;
  Friction friction;
  friction.lives(0.03, mu * 0.03 / kt, 1, true);
  friction.told.moved = true;
  friction.told.jump = {{0, a, 0}, {0, v, 0}, {0, x, 0}};
  friction.evaluate(on_the_move(2e-5, 1, -0.1));
  ASSERT_EQ(friction.told.events.size(), 1u);
  EXPECT_FALSE(friction.told.events[0].jumps);
  const double share = mu * c;  // against the slip, and the dashpot against the separation
  expect_change(friction.told.events[0].on_i, share * (v + a * dt), share * a,
                share * (x + v * dt + a * dt * dt / 2),
                share * (x * dt + v * dt * dt / 2 + a * dt * dt * dt / 6));
}

// With a force two evaluations ago as well: of the parabola through all three, which is right for
// any force that is quadratic in time; a cut-off force is on no parabola. A jump of the bodies'
// velocity and acceleration has changed what the dashpot would have been.
TEST(TotalCap, HasTheCurvatureOfTheNormalForce) {
  const double r = 800, g = -6e7, overlap = 1e-4, now = k * overlap + c * 0.03;
  const SampleContact contact = on_the_move(overlap, 1, -0.03);
  const auto force = [&](double t) { return now - r * t + g * t * t / 2; };
  for (const bool cut : {false, true})
    for (const bool jumps : {false, true}) {
      RecordedEvents told;
      told.moved = jumps;
      told.jump = {{0, 70, 0}, {0, 2e-3, 0}, {0, 0, 0}};
      const double unseen = jumps ? c : 0;  // times the velocity that the past did not know of
      CapHistory history;
      history.normal.viscoelastic = force(dt) + unseen * 2e-3;
      history.earlier = cut ? -0.01 : force(2 * dt) + unseen * (2e-3 - 70 * dt);
      history.has_earlier = true;
      TotalCap cap(mu, now, history);
      cap.renew(contact, true, dt, static_cast<const RecordedEvents*>(&told));
      const double chord = (now - force(dt)) / dt;
      EXPECT_NEAR(cap.rate(contact, dt), mu * (cut ? chord : r), 1e-9 * mu * r);
      EXPECT_NEAR(cap.curvature(contact, true, 0, dt), cut ? 0 : mu * g, 1e-7 * mu * std::fabs(g));
      EXPECT_NEAR(history.earlier, force(dt), 1e-12);
    }
}

// A slide at the speed -A t stands still s before the end of the step, under a normal force that
// changes by r per second. The spring that stays is what carried the cap then, mu (U - r s), and
// the way back since, A s^2 / 2.
TEST(TotalCap, StickKeepsTheSpringOfTheForceAtTheStandstill) {
  const double speed_up = 2000, s = 0.3 * dt, overlap = 1e-4, separation = 0.05;
  const double now = k * overlap - c * separation;
  for (const double r : {-300.0, 500.0}) {
    const auto v = [&](int n) { return -speed_up * (s - n * dt); };
    Friction friction;
    friction.lives(now - r * dt, mu * (now - r * dt) / kt, 0, true);
    for (int n = 0; n < slots; ++n) friction.history.velocity[n][0] = v(n + 1);
    const TangentialForce force = friction.evaluate(on_the_move(overlap, v(0), separation));
    EXPECT_FALSE(force.sliding);
    EXPECT_NEAR(friction.history.spring[0], mu * (now - r * s) / kt - speed_up * s * s / 2, 1e-15);
  }
}

}  // namespace rodpack
