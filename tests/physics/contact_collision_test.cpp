// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "collision_reference.h"
#include "deck.h"
#include "liggghts_run.h"
#include "rodpack/contact/contact_law.h"

using namespace rodpack::test;

namespace {

constexpr double paper_step = 1.1e-5;  // s

using Vars = std::map<std::string, std::string>;

Vars variables(const CollisionReference& collision, double dt, double time,
               const std::string& order) {
  const std::string steps = std::to_string(std::lround(time / dt));
  return {{"dt", exact(dt)},
          {"steps", steps},
          {"every", steps},
          {"order", order},
          {"k", exact(collision.kn)},
          {"kt", exact(collision.kt)},
          {"eta_n", exact(collision.eta_n)},
          {"eta_t", exact(collision.eta_t)},
          {"mu", exact(collision.mu)},
          {"speed", exact(collision.speed)},
          {"offset", exact(collision.offset)},
          {"spin", exact(collision.spin)}};
}

Run run_deck(const Vars& vars) {
  Run run = run_liggghts("verification/collision/in.collision", vars);
  if (run.exit_code != 0) throw std::runtime_error(run.output);
  return run;
}

/// What a pair is left with: relative velocity of its first sphere, sum of the spins.
struct Outcome {
  double u, v, omega;
  double kinetic;                 // J
  double momentum_x, momentum_y;  // over the mass of a sphere, m/s
};

std::vector<Outcome> collide(const CollisionReference& collision, double dt,
                             const std::string& order) {
  const auto run = run_deck(variables(collision, dt, 100 * paper_step, order));
  const Table bodies = read_dump(run.folder / "bodies.dump");
  const auto& vx = bodies.column("vx");
  const auto& vy = bodies.column("vy");
  const auto& omega = bodies.column("omegaz");
  std::vector<Outcome> pairs;
  for (std::size_t i = 0; i < bodies.rows(); i += 2) {
    const std::size_t j = i + 1;
    double kinetic = 0;
    for (const std::size_t k : {i, j})
      kinetic += collision.mass() * (0.5 * (vx[k] * vx[k] + vy[k] * vy[k]) +
                                     0.2 * std::pow(collision.radius * omega[k], 2));
    pairs.push_back(
        {vx[i] - vx[j], vy[i] - vy[j], omega[i] + omega[j], kinetic, vx[i] + vx[j], vy[i] + vy[j]});
  }
  return pairs;
}

/// Root mean square over the pairs, whose first touch falls anywhere within a step: the error
/// depends on where.
template <class Error>
double rms(const std::vector<Outcome>& pairs, Error error) {
  double sum = 0;
  for (const Outcome& pair : pairs) sum += std::pow(error(pair), 2);
  return std::sqrt(sum / pairs.size());
}

}  // namespace

// A contact that may not pull ends when k delta = c v, before the overlap is gone:
// e = exp(-2 eta acos(eta) / sqrt(1 - eta^2)) = 0.5717 for eta = 0.2. The dashpot makes the force
// jump at first touch, so every integrator that does not look for the touch is of first order.
TEST(Collision, HeadOnRestitutionConvergesToTheClosedForm) {
  const double expected = rodpack::restitution_coefficient(0.2);
  ASSERT_NEAR(expected, 0.5717, 5e-5);
  const CollisionReference collision;
  for (const char* order : {"0", "3"}) {
    const auto error = [&](double dt) {
      return rms(collide(collision, dt, order),
                 [&](const Outcome& end) { return -end.u / (2 * collision.speed) / expected - 1; });
    };
    const double coarse = error(paper_step), fine = error(paper_step / 8);
    std::printf("order %s: restitution error %.2e at the paper's step, %.2e at an eighth\n", order,
                coarse, fine);
    EXPECT_LT(coarse, 0.02) << order;
    EXPECT_LT(fine, 2.5e-3) << order;
    EXPECT_NEAR(observed_order(coarse, fine, 8), 1, 0.3) << order;
  }
}

// Springs alone give the energy back, but for the integrator. With h = omega dt, omega =
// sqrt(k/m_ij):
//
// Velocity Verlet keeps u^2/2 + omega^2 delta_n delta_{n+1} / 2 within a contact, u the velocity at
// half a step. Where the first overlap is theta u dt, 0 < theta < 1, that differs from u^2/2 before
// by -h^2 u^2 theta (1 - theta) / 2, and at the end by the same with the theta there: the energy
// changes by h^2 (theta_1 (1 - theta_1) - theta_2 (1 - theta_2)), at most h^2/4 in magnitude.
//
// Third-order Adams-Bashforth damps an oscillation by the factor 1 - 3/8 h^4 per step; over pi/h
// steps the energy changes by -(3/4) pi h^3 (1.3e-3 at the paper's step), plus what the kinks at
// touch and release contribute, which is of second order, with either sign, and averages out.
TEST(Collision, KineticEnergyIsRestoredWithoutDampingAndFriction) {
  CollisionReference collision;
  collision.eta_n = collision.eta_t = collision.mu = 0;
  const double at_start = collision.mass() * collision.speed * collision.speed;
  const double h = std::sqrt(collision.kn / (collision.mass() / 2)) * paper_step;
  const auto changes = [&](double dt, const char* order) {
    std::vector<double> result;
    for (const Outcome& end : collide(collision, dt, order))
      result.push_back(end.kinetic / at_start - 1);
    return result;
  };
  for (const double change : changes(paper_step, "0")) EXPECT_LT(std::fabs(change), h * h / 4);
  for (const double change : changes(paper_step / 4, "0"))
    EXPECT_LT(std::fabs(change), h * h / 4 / 16);

  double mean = 0;
  for (const double change : changes(paper_step, "3")) mean += change / 5;
  std::printf("energy change under AB3 at the paper's step: %.2e\n", mean);
  EXPECT_NEAR(mean / (-0.75 * M_PI * h * h * h), 1, 0.15);
  for (const double change : changes(paper_step / 4, "3")) EXPECT_LT(std::fabs(change), 1e-4);
}

// Sliding, sticking and a change between them, with spin: against a separate integration of the
// law.
TEST(Collision, ObliqueCollisionFollowsTheReference) {
  struct Case {
    double offset, spin, mu;
  };
  for (const char* order : {"0", "3"}) {
    for (const Case& c : {Case{1.5e-3, 0, 0.3}, Case{0.5e-3, 200, 0.1}, Case{-0.5e-3, 100, 0.5}}) {
      CollisionReference collision;
      collision.offset = c.offset;
      collision.spin = c.spin;
      collision.mu = c.mu;
      const auto expected = collision.at(1);
      const auto error = [&](double dt) {
        return rms(collide(collision, dt, order), [&](const Outcome& end) {
          return std::hypot(end.u - expected[CollisionReference::U],
                            end.v - expected[CollisionReference::V],
                            collision.radius * (end.omega - expected[CollisionReference::OMEGA])) /
                 (2 * collision.speed);
        });
      };
      const double coarse = error(paper_step), fine = error(paper_step / 8);
      std::printf("order %s, offset %g, spin %g, mu %g: %.2e, %.2e\n", order, c.offset, c.spin,
                  c.mu, coarse, fine);
      EXPECT_LT(coarse, 0.02) << order << c.offset;
      EXPECT_LT(fine, 3e-3) << order << c.offset;
    }
  }
}

// The spring is the integral of the tangential velocity from first touch on, turned with the
// contact, and converges with the order of Adams-Bashforth. Springs of 1e-6 N/m do not bend the
// lines of flight, so that nothing but this integral is tested: the spheres pass through each
// other, with spin. (Stiff springs would add the error that the kink of the forces at touch leaves
// in the motion, of second order.) Velocity Verlet pairs the velocity of half a step with the plane
// of contact of the whole one, which is of first order.
TEST(Collision, SpringConvergesWithTheOrderOfTheIntegrator) {
  struct Method {
    const char* order;  // of Adams-Bashforth, 0: velocity Verlet
    double expected;    // order of convergence
  };
  CollisionReference collision;
  collision.kn = collision.kt = 1e-6;
  collision.eta_n = collision.eta_t = 0;
  collision.mu = 1e6;
  collision.offset = 1.5e-3;
  collision.spin = 300;
  const double time = 200 * paper_step;
  for (const Method& method : {Method{"0", 1}, Method{"1", 1}, Method{"2", 2}, Method{"3", 3}}) {
    const auto error = [&](double dt) {
      const auto run = run_deck(variables(collision, dt, time, method.order));
      const Table contacts = read_dump(run.folder / "contacts.dump");
      EXPECT_EQ(contacts.rows(), 5u);
      double sum = 0;
      for (std::size_t c = 0; c < contacts.rows(); ++c) {
        const double sphere =
            std::min(contacts.column("sphere_i")[c], contacts.column("sphere_j")[c]);
        CollisionReference pair = collision;
        pair.gap = 1e-4 + 0.5 * (sphere - 1) * 2.237e-6;
        const double spring = std::fabs(pair.at(time)[CollisionReference::S]);
        sum += std::pow(contacts.column("overlap_t")[c] / spring - 1, 2);
      }
      return std::sqrt(sum / 5);
    };
    const double coarse = error(4 * paper_step), fine = error(paper_step);
    std::printf("order %s: spring error %.2e, %.2e, order %.2f\n", method.order, coarse, fine,
                observed_order(coarse, fine, 4));
    EXPECT_NEAR(observed_order(coarse, fine, 4), method.expected, 0.4) << method.order;
  }
}

// Forces on the two spheres are equal and opposite.
TEST(Collision, MomentumIsConserved) {
  CollisionReference collision;
  collision.offset = 1e-3;
  collision.spin = 150;
  for (const Outcome& end : collide(collision, paper_step, "0")) {
    EXPECT_NEAR(end.momentum_x, 0, 1e-14);
    EXPECT_NEAR(end.momentum_y, 0, 1e-14);
  }
}
