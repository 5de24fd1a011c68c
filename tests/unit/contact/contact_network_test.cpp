// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/contact/contact_network.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "rodpack/motion/stability_limit.h"

namespace rodpack {
namespace {

const double k = 1000, radius = 1.5e-3, mass = 3.5e-5;

/// A sphere in the x-y plane.
NetworkBody sphere(double m = mass) {
  const double moment = 0.4 * m * radius * radius;
  return {
      m, {{moment, 0, 0}, {0, moment, 0}, {0, 0, moment}}, {true, true, false, false, false, true}};
}

/// A contact of two bodies along x, or of a body and a wall (j < 0) along y.
NetworkContact contact(int i, int j, double eta_n, double kt = 0, double eta_t = 0) {
  NetworkContact c = {};
  c.i = i;
  c.j = j;
  c.normal[j < 0 ? 1 : 0] = -1;
  c.arm_i[j < 0 ? 1 : 0] = j < 0 ? -radius : radius;
  if (j >= 0) c.arm_j[0] = -radius;
  const double effective = j < 0 ? mass : 0.5 * mass;
  c.stiffness_n = k;
  c.stiffness_t = kt;
  c.damping_n = 2 * eta_n * std::sqrt(effective * k);
  c.damping_t = 2 * eta_t * std::sqrt(effective * kt);
  return c;
}

TEST(ContactNetwork, ASphereOnAWallWithoutFriction) {
  const NetworkLimit limit = network_limit(3, {sphere()}, {contact(0, -1, 0.2)});
  EXPECT_NEAR(limit.stiffness / (k / mass), 1, 1e-12);
  EXPECT_NEAR(limit.timestep * std::sqrt(k / mass) / stability_limit(3, 0.2), 1, 1e-9);
  EXPECT_EQ(limit.stiffest, 0);
  EXPECT_EQ(limit.contacts, 1);
}

// Sliding against a spring in the plane of contact it also turns: k_t (1/m + r^2/I) = 7/2 k_t / m,
// with the damping ratio sqrt(7/2) eta_t.
TEST(ContactNetwork, FrictionHoldsTranslationAndRotation) {
  const double kt = 500;
  for (const int order : {0, 3}) {
    const NetworkLimit limit = network_limit(order, {sphere()}, {contact(0, -1, 0.1, kt, 0.2)});
    EXPECT_NEAR(limit.stiffness / (3.5 * kt / mass), 1, 1e-12);
    EXPECT_NEAR(
        limit.timestep * std::sqrt(3.5 * kt / mass) / stability_limit(order, std::sqrt(3.5) * 0.2),
        1, 1e-9)
        << order;
  }
}

// Against a spring of rolling it turns alone: k_r / I, with the damping ratio c_r / 2 sqrt(I k_r);
// two spheres turn against each other.
TEST(ContactNetwork, RollingFrictionHoldsRotation) {
  const double kr = 20 * k * radius * radius, moment = 0.4 * mass * radius * radius;
  for (const bool wall : {true, false}) {
    NetworkContact rolling = contact(0, wall ? -1 : 1, 0.1);
    const double reduced = wall ? moment : 0.5 * moment;
    rolling.stiffness_r = kr;
    rolling.damping_r = 2 * 0.15 * std::sqrt(reduced * kr);
    const NetworkLimit limit = network_limit(0, {sphere(), sphere()}, {rolling});
    EXPECT_NEAR(limit.stiffness / (kr / reduced), 1, 1e-9) << wall;
    EXPECT_NEAR(limit.timestep * std::sqrt(kr / reduced) / stability_limit(0, 0.15), 1, 1e-6);
  }
  NetworkContact wrong = contact(0, -1, 0.1);
  wrong.stiffness_r = -1;
  EXPECT_THROW(network_limit(0, {sphere()}, {wrong}), std::invalid_argument);
}

// In three dimensions there are two such directions, not one of twice the stiffness.
TEST(ContactNetwork, BothDirectionsInThePlaneOfContact) {
  NetworkBody body = sphere();
  body.is_free.fill(true);
  const NetworkLimit limit = network_limit(3, {body}, {contact(0, -1, 0, 500, 0)});
  EXPECT_NEAR(limit.stiffness / (3.5 * 500 / mass), 1, 1e-12);
}

// omega^2 = k / m_ij, for equal masses and others: k (1/m_1 + 1/m_2).
TEST(ContactNetwork, TwoSpheresThatMeet) {
  for (const double other : {mass, 10 * mass}) {
    const NetworkLimit limit = network_limit(3, {sphere(), sphere(other)}, {contact(0, 1, 0)});
    const double squared = k * (1 / mass + 1 / other);
    EXPECT_NEAR(limit.stiffness / squared, 1, 1e-9);
    EXPECT_NEAR(limit.timestep * std::sqrt(squared) / stability_limit(3, 0), 1, 1e-9);
  }
}

// A row of n equal spheres: omega^2 = 4 k/m sin^2(pi (n - 1) / (2 n)), up to 4 k/m.
// A body that is held is a wall, whatever its mass and on whichever side of the contact.
TEST(ContactNetwork, ABodyThatIsHeldIsAWall) {
  NetworkContact with_wall = contact(0, 1, 0.2, 500, 0.1);
  with_wall.j = -1;
  const NetworkLimit wall = network_limit(3, {sphere()}, {with_wall});
  for (const double m : {1e-3 * mass, 1e3 * mass}) {
    NetworkBody held = sphere(m);
    held.is_free.fill(false);
    const NetworkLimit second = network_limit(3, {sphere(), held}, {contact(0, 1, 0.2, 500, 0.1)}),
                       first = network_limit(3, {held, sphere()}, {contact(0, 1, 0.2, 500, 0.1)});
    for (const NetworkLimit& found : {first, second}) {
      EXPECT_NEAR(found.timestep / wall.timestep, 1, 1e-12) << m;
      EXPECT_NEAR(found.stiffness / wall.stiffness, 1, 1e-12) << m;
    }
    EXPECT_EQ(second.stiffest, 0);
    EXPECT_EQ(first.stiffest, 1);
  }
}

TEST(ContactNetwork, ARowOfSpheresIsBoundedFromAboveAndClosely) {
  for (const int n : {3, 5, 20}) {
    std::vector<NetworkBody> bodies(n, sphere());
    std::vector<NetworkContact> contacts;
    for (int i = 0; i + 1 < n; ++i) contacts.push_back(contact(i, i + 1, 0));
    const double exact = 4 * k / mass * std::pow(std::sin(M_PI * (n - 1) / (2.0 * n)), 2);
    const double bound = network_limit(3, bodies, contacts).stiffness;
    EXPECT_GE(bound, exact * (1 - 1e-12)) << n;
    EXPECT_LE(bound, 1.05 * exact) << n;
  }
}

// N equal contacts beside each other: omega^2 = N k / m, and the damping ratio grows as sqrt(N).
// From N = 25 on, at eta = 0.2, the motion no longer oscillates.
TEST(ContactNetwork, ManyContactsOfOneBodyAreStronglyDamped) {
  for (const int n : {4, 30}) {
    const std::vector<NetworkContact> contacts(n, contact(0, -1, 0.2));
    const NetworkLimit limit = network_limit(3, {sphere()}, contacts);
    EXPECT_NEAR(
        limit.timestep * std::sqrt(n * k / mass) / stability_limit(3, 0.2 * std::sqrt(1.0 * n)), 1,
        1e-9)
        << n;
    EXPECT_EQ(limit.contacts, n);
  }
}

// Stiff contacts along y, and along x softer ones with a long delay c/k: the motion along y is the
// fast one, that along x is overdamped. Both have their own limit, which the corner of all bounds
// would undercut.
TEST(ContactNetwork, StiffAndSlowContactsAreNotMixed) {
  std::vector<NetworkContact> contacts(30, contact(0, -1, 0.2));
  NetworkContact slow = {};
  slow.j = -1;
  slow.normal[0] = 1;
  slow.stiffness_n = 10 * k;
  slow.damping_n = 0.9 * 30 * contacts[0].damping_n;
  contacts.push_back(slow);
  const auto own = [](double stiffness, double damping) {
    const double omega = std::sqrt(stiffness / mass);
    return stability_limit(3, damping / mass / (2 * omega)) / omega;
  };
  const double exact =
      std::min(own(30 * k, 30 * contacts[0].damping_n), own(slow.stiffness_n, slow.damping_n));
  const double limit = network_limit(3, {sphere()}, contacts).timestep;
  EXPECT_LE(limit, exact * (1 + 1e-9));
  EXPECT_GE(limit, 0.97 * exact);
  const double delay = slow.damping_n / slow.stiffness_n;
  const double corner = timestep_limit(
      3, {30 * k / mass, 30 * contacts[0].damping_n / mass, contacts[0].damping_n / k, delay});
  EXPECT_LT(corner, 0.9 * exact);
}

// In three coordinates, or in all six as soon as another body may leave the plane. The rods' arms
// lead out of the plane, too.
TEST(ContactNetwork, APlaneIsLookedAtAsSpaceIs) {
  NetworkBody rod = sphere();
  rod.moments[2][2] *= 8;
  rod.moments[1][2] = rod.moments[2][1] = 0.3 * rod.moments[2][2];
  std::vector<NetworkBody> bodies(5, rod);
  std::vector<NetworkContact> contacts;
  for (int c = 0; c < 9; ++c) {
    NetworkContact one = contact(c % 5, c < 7 ? (c + 1 + c % 2) % 5 : -1, 0.2, 0.5 * k, 0.3);
    const double angle = 1 + 2 * c;
    const double normal[3] = {std::cos(angle), std::sin(angle), 0};
    const double arm[3] = {radius * c, radius * (3 - c), 0.2 * radius};
    std::copy_n(normal, 3, one.normal);
    std::copy_n(arm, 3, one.arm_i);
    std::copy_n(arm, 3, one.arm_j);
    one.stiffness_r = c * 1e-4;
    one.damping_r = 1e-7;
    contacts.push_back(one);
  }
  bodies[2].is_free.fill(false);
  std::vector<NetworkBody> with_another = bodies;
  with_another.push_back(sphere());
  with_another.back().is_free.fill(true);
  for (const int order : {0, 3}) {
    const NetworkLimit plane = network_limit(order, bodies, contacts),
                       space = network_limit(order, with_another, contacts);
    EXPECT_NEAR(plane.timestep / space.timestep, 1, 1e-12);
    EXPECT_NEAR(plane.stiffness / space.stiffness, 1, 1e-12);
    EXPECT_NEAR(plane.damping / space.damping, 1, 1e-12);
    EXPECT_EQ(plane.stiffest, space.stiffest);
  }
}

TEST(ContactNetwork, WithoutContactsOrFreeMotionThereIsNoLimit) {
  EXPECT_TRUE(std::isinf(network_limit(3, {sphere()}, {}).timestep));
  EXPECT_EQ(network_limit(3, {sphere()}, {}).stiffest, -1);
  NetworkBody held = sphere();
  held.is_free.fill(false);
  EXPECT_TRUE(std::isinf(network_limit(3, {held}, {contact(0, -1, 0.2)}).timestep));
}

TEST(ContactNetwork, RefusesWhatMakesNoSense) {
  EXPECT_THROW(network_limit(3, {sphere()}, {contact(1, -1, 0)}), std::invalid_argument);
  EXPECT_THROW(network_limit(3, {sphere()}, {contact(0, 1, 0)}), std::invalid_argument);
  EXPECT_THROW(network_limit(3, {sphere()}, {contact(0, 0, 0)}), std::invalid_argument);
  EXPECT_THROW(network_limit(3, {sphere(-1)}, {contact(0, -1, 0)}), std::invalid_argument);
  NetworkContact soft = contact(0, -1, 0);
  soft.stiffness_n = 0;
  EXPECT_THROW(network_limit(3, {sphere()}, {soft}), std::invalid_argument);
  EXPECT_THROW(network_limit(7, {sphere()}, {contact(0, -1, 0)}), std::invalid_argument);
}

}  // namespace
}  // namespace rodpack
