// SPDX-License-Identifier: GPL-2.0-or-later
// Events of the engine: what contacts report arrives at the bodies, and what jumps did to the
// bodies at their contacts.
#include "planar/events.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "rodpack/contact/normal_history.h"

namespace rodpack {
namespace {

const double radius = 1e-3, k = 1000, c = 0.4, dt = 1e-5;

PlanarKinematics at_rest(double x, double y) { return {x, y, 1, 0, {0, 0, 0}, radius}; }

PlanarContact contact_of(int i, int j) {
  PlanarContact contact = {};
  contact.body_i = i;
  contact.body_j = j;
  contact.radi = radius;
  contact.radj = radius;
  contact.kn = k;
  contact.gamman = c;
  return contact;
}

/// Three bodies of this rank, two in a part; ghosts behind them.
PlanarEvents events_of_three() {
  PlanarParts parts = {3, 2};
  PlanarEvents events(parts);
  events.resize(3);
  return events;
}

struct ChangedBody {
  int body;
  PlanarChangeSums sum;
  bool jumps;
};

std::vector<ChangedBody> changes(const PlanarEvents& events, int part) {
  std::vector<ChangedBody> result;
  events.each_changed(part, [&](int body, bool jumps) {
    result.push_back({body, events.changes(body), jumps});
  });
  return result;
}

ChangedBody only_change(const PlanarEvents& events, int part) {
  const std::vector<ChangedBody> all = changes(events, part);
  EXPECT_EQ(all.size(), 1u);
  return all.at(0);
}

bool any_jumped(PlanarEvents& events) {
  PlanarForceArguments forces = PlanarForceArguments();
  events.set_arguments(forces);
  return forces.jumped != nullptr;
}

}  // namespace

// Two spheres, each at the end of an arm of 4 mm along x of its body, meet head-on along y: s ago,
// at the speed w. Each body misses the impulse J = k w s^2/2 + c w s along its side of y, and the
// torque arm x J about its centre of mass, whose rate has the parts of force and arm.
TEST(PlanarEvents, TouchChangesForceAndTorqueOfBothBodies) {
  const double w = 0.2, s = 0.5 * dt, arm = 4e-3;
  PlanarKinematics i = at_rest(0, 2 * radius - w * s), j = at_rest(0, 0);
  i.velocity[1] = -w;
  PlanarContact contact = contact_of(0, 2);
  contact.offset_i[0] = contact.offset_j[0] = arm;
  place_pair(contact, i, j);
  PlanarEvents events = events_of_three();
  NormalHistory history;
  follow_normal_force(contact, history, viscoelastic_force(k, contact.deltan, c, contact.vn), false,
                      dt, &events);
  const double impulse = k * w * s * s / 2 + c * w * s;
  for (const int part : {0, 1}) {  // bodies 0 and 2
    const ChangedBody change = only_change(events, part);
    const double sign = part == 0 ? 1 : -1;
    EXPECT_EQ(change.body, part == 0 ? 0 : 2);
    EXPECT_TRUE(change.jumps);
    EXPECT_NEAR(change.sum.impulse.d[1], sign * impulse, 1e-9 * impulse);
    EXPECT_NEAR(change.sum.now.d[1], sign * (k * w * s + c * w), 1e-9 * c * w);
    EXPECT_EQ(change.sum.impulse.d[0], 0);
    EXPECT_NEAR(change.sum.impulse.d[2], sign * arm * impulse, 1e-9 * arm * impulse);
    EXPECT_NEAR(change.sum.rate.d[2], sign * arm * k * w, 1e-9 * arm * k * w);
  }
  events.forget_changes(0);
  EXPECT_TRUE(changes(events, 0).empty());
  EXPECT_EQ(changes(events, 1).size(), 1u);
}

// The lever L of a force from the centre of mass is the arm to the centre of the sphere, which
// turns at the spin w of the body, and the lever from there to the contact, against the normal n:
//   L = arm - r n,   L' = w x arm - r' n - r n',   r = R - delta/2,  r' = v_n/2,  n' = v_t/|x_i -
//   x_j|
// with the relative velocity (v_t, v_n) of the centres. The torque L x D of a change D has the rate
// L x D' + L' x D, and its impulse is the integral of (L - (now - t) L') x D.
TEST(PlanarEvents, TheArmOfABodyThatSpinsTurns) {
  const double spin = 30, arm = 4e-3, distance = 1.9 * radius, slip = 0.3, r = 0.95 * radius;
  PlanarKinematics i = at_rest(0, distance), j = at_rest(0, 0);
  i.velocity[2] = spin;
  j.velocity[0] = -slip;
  PlanarContact contact = contact_of(0, 2);
  contact.offset_i[0] = contact.offset_j[0] = arm;
  place_pair(contact, i, j);
  const double vn = spin * arm;
  const ForceChange change = {{2, 3, 0}, {5e4, -7e4, 0}, {1e-6, 4e-6, 0}, {3e-11, -5e-11, 0}};
  PlanarEvents events = events_of_three();
  events.add(contact, change, false);
  const auto product = [](const double(&lever)[2], const double(&force)[3]) {
    return lever[0] * force[1] - lever[1] * force[0];
  };
  for (const int part : {0, 1}) {  // bodies 0 and 2
    const double side = part == 0 ? 1 : -1;
    const double lever[2] = {arm, -side * r};
    const double lever_rate[2] = {-side * r * slip / distance,
                                  (part == 0 ? spin * arm : 0.0) - side * vn / 2};
    const PlanarChangeSums sum = only_change(events, part).sum;
    const auto expect = [&](double value, double expected) {
      EXPECT_NEAR(value, side * expected, 1e-12 * std::fabs(expected));
    };
    expect(sum.now.d[2], product(lever, change.now));
    expect(sum.rate.d[2], product(lever, change.rate) + product(lever_rate, change.now));
    expect(sum.impulse.d[2],
           product(lever, change.impulse) - product(lever_rate, change.impulse_integral));
    expect(sum.impulse_integral.d[2], product(lever, change.impulse_integral));
  }
}

// Several contacts of a body add up; a wall keeps nothing.
TEST(PlanarEvents, ChangesOfABodyAddUp) {
  PlanarEvents events = events_of_three();
  PlanarContact contact = contact_of(1, -1);
  place_wall(contact, at_rest(0, 0.9 * radius), PlanarWall{1, 0.0, 0});
  const ForceChange change = linear_change({2, 3, 0}, {0, 0, 0}, 1e-6);
  events.add(contact, change, false);
  EXPECT_FALSE(only_change(events, 0).jumps);
  events.add(contact, change, true);
  const ChangedBody sum = only_change(events, 0);
  EXPECT_EQ(sum.body, 1);
  EXPECT_TRUE(sum.jumps);
  EXPECT_DOUBLE_EQ(sum.sum.now.d[0], 4);
  EXPECT_DOUBLE_EQ(sum.sum.impulse.d[1], 6e-6);
  // lever (0, -(R - delta/2)) x (4, 6) = (R - delta/2) 4
  EXPECT_NEAR(sum.sum.now.d[2], 4 * 0.95 * radius, 1e-15);
  EXPECT_TRUE(changes(events, 1).empty());
}

// Body 0 has jumped; its contact moves by v - w y and w x more, y and x from its centre of mass to
// the contact, in the direction of its orientation then. Without a jump there is nothing to say.
TEST(PlanarEvents, ContactsLearnOfJumpsInTheNextStep) {
  PlanarEvents events = events_of_three();
  PlanarContact contact = contact_of(0, 1);
  contact.offset_i[0] = 4e-3;
  place_pair(contact, at_rest(0, 1.9 * radius), at_rest(4e-3, 0));
  ContactJump jump;
  EXPECT_FALSE(any_jumped(events));
  EXPECT_FALSE(events.motion_changed(contact, jump));

  const PlanarJump of_body = {{3, -2, 700}, {0.1, 0.3, 20}, {1e-6, 2e-6, 4e-5}, 1, 0};
  events.set_jumped(0, of_body);
  ASSERT_TRUE(any_jumped(events));
  EXPECT_TRUE(events.jumped(0));
  EXPECT_FALSE(events.jumped(1));
  ASSERT_TRUE(events.motion_changed(contact, jump));
  const double x = 4e-3, y = -0.95 * radius;
  EXPECT_NEAR(jump.velocity[0], 0.1 - 20 * y, 1e-15);
  EXPECT_NEAR(jump.velocity[1], 0.3 + 20 * x, 1e-15);
  EXPECT_NEAR(jump.acceleration[0], 3 - 700 * y, 1e-12);
  EXPECT_NEAR(jump.displacement[1], 2e-6 + 4e-5 * x, 1e-20);

  // Moving with it, the other body leaves nothing of the jump of the centres.
  PlanarJump other = of_body;
  for (double* part : {other.acceleration, other.velocity, other.displacement}) part[2] = 0;
  events.set_jumped(1, other);
  ASSERT_TRUE(events.motion_changed(contact, jump));
  EXPECT_NEAR(jump.velocity[0], -20 * y, 1e-15);
  EXPECT_NEAR(jump.velocity[1], 20 * x, 1e-15);

  events.forget_jumps(0);
  EXPECT_FALSE(any_jumped(events));
  EXPECT_FALSE(events.motion_changed(contact, jump));
}

}  // namespace rodpack
