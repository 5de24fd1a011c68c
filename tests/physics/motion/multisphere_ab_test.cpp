// SPDX-License-Identifier: GPL-2.0-or-later
// fix multisphere/ab: trajectories of single bodies, and its observed order.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "deck.h"
#include "liggghts_run.h"

namespace {

using namespace rodpack::test;
using State = std::vector<double>;

std::string ab(int order, const std::string& rest = "") {
  return "multisphere/ab order " + std::to_string(order) + rest;
}

/// Classical Runge-Kutta of fourth order in `steps` steps: the reference where no closed form
/// exists.
State integrate(State y, double time, int steps, const std::function<State(const State&)>& rate) {
  const double h = time / steps;
  const auto at = [&](const State& k, double weight) {
    State z = y;
    for (size_t i = 0; i < z.size(); ++i) z[i] += weight * h * k[i];
    return z;
  };
  for (int n = 0; n < steps; ++n) {
    const State k1 = rate(y), k2 = rate(at(k1, 0.5)), k3 = rate(at(k2, 0.5)), k4 = rate(at(k3, 1));
    for (size_t i = 0; i < y.size(); ++i) y[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
  }
  return y;
}

/// Free rotation about the centre of mass by Euler's equations, in the body frame: quaternion
/// (w, x, y, z) and angular velocity.
State freely_rotating(const std::array<double, 4>& q, const std::array<double, 3>& body_omega,
                      const std::array<double, 3>& inertia, double time) {
  return integrate({q[0], q[1], q[2], q[3], body_omega[0], body_omega[1], body_omega[2]}, time,
                   20000, [&](const State& y) {
                     const double *p = &y[0], *w = &y[4];
                     return State{0.5 * (-p[1] * w[0] - p[2] * w[1] - p[3] * w[2]),
                                  0.5 * (p[0] * w[0] + p[2] * w[2] - p[3] * w[1]),
                                  0.5 * (p[0] * w[1] + p[3] * w[0] - p[1] * w[2]),
                                  0.5 * (p[0] * w[2] + p[1] * w[1] - p[2] * w[0]),
                                  (inertia[1] - inertia[2]) * w[1] * w[2] / inertia[0],
                                  (inertia[2] - inertia[0]) * w[2] * w[0] / inertia[1],
                                  (inertia[0] - inertia[1]) * w[0] * w[1] / inertia[2]};
                   });
}

Table last_state(const std::string& deck, const std::map<std::string, std::string>& vars) {
  const auto run = run_liggghts("verification/" + deck + "/in." + deck, vars);
  EXPECT_EQ(run.exit_code, 0) << run.output;
  return read_dump(run.folder / "state.dump");
}

const double flight_time = 0.1;  // s

Table fly(const std::string& integrator, int steps, std::map<std::string, std::string> vars = {}) {
  vars["integrator"] = integrator;
  vars["timestep"] = exact(flight_time / steps);
  vars["steps"] = vars["every"] = std::to_string(steps + 1);  // born in step 1
  return last_state("free_flight", vars);
}

/// Observed order of the orientation of a body that tumbles freely.
double orientation_order(int order) {
  // deck: orientation (0.8, 0, 0.6, 0), so R = rotation about y by 2 atan(0.6/0.8); omega in space
  const double c = 0.28, s = 0.96, w[3] = {60, 9, -15};
  const State solution =
      freely_rotating({0.8, 0, 0.6, 0}, {c * w[0] - s * w[2], w[1], s * w[0] + c * w[2]},
                      {1e-7, 2e-7, 4e-7}, flight_time);
  double error[2];
  for (int fine = 0; fine < 2; ++fine) {
    const Table state = fly(ab(order), (fine + 1) * 2000);
    error[fine] = 0;
    for (int d = 0; d < 4; ++d) {
      const double q = state.column("c_q[" + std::to_string(d + 1) + "]")[0];
      error[fine] += (q - solution[d]) * (q - solution[d]);
    }
  }
  return observed_order(std::sqrt(error[0]), std::sqrt(error[1]));
}

}  // namespace

// The force is constant: y = y0 + v t - g t^2/2 for every order that integrates a linear velocity
// exactly; order 1 takes the velocity at the start of each step and falls behind by g t dt/2.
TEST(MultisphereAb, FreeFallIsExactFromOrderTwoOn) {
  const int steps = 200;
  const double t = flight_time, g = 9.81, start = 4.6554481399503756e-10;  // within 1e-9 of 0
  for (int order = 1; order <= 4; ++order) {
    const Table state = fly(ab(order), steps);
    const double lag = order == 1 ? 0.5 * g * t * t / steps : 0.0;
    EXPECT_NEAR(state.column("c_x[2]")[0] - start, 0.2 * t - 0.5 * g * t * t + lag, 2e-9) << order;
    EXPECT_NEAR(state.column("c_v[2]")[0], 0.2 - g * t, 1e-13) << order;
    EXPECT_NEAR(state.column("c_x[1]")[0], 0.1 * t, 2e-9) << order;
  }
}

TEST(MultisphereAb, FreeRotationIsOfTheOrderAsked) {
  for (int order = 1; order <= 4; ++order)
    EXPECT_NEAR(orientation_order(order), order, 0.1) << "order " << order;
}

// Velocities are those of half a step before the positions.
TEST(MultisphereAb, LeapfrogFallsExactlyAndTurnsToSecondOrder) {
  const double t = flight_time, g = 9.81, start = 4.6554481399503756e-10;
  const Table state = fly(ab(0), 200);
  EXPECT_NEAR(state.column("c_x[2]")[0] - start, 0.2 * t - 0.5 * g * t * t, 2e-9);
  EXPECT_NEAR(state.column("c_v[2]")[0], 0.2 - g * (t - 0.5 * t / 200), 1e-13);
  EXPECT_NEAR(orientation_order(0), 2, 0.1);
}

TEST(MultisphereAb, FreeRotationKeepsTheAngularMomentum) {
  // no torque, so every increment of the angular momentum is 0: the last digit may not change
  const Table state = fly(ab(3), 500, {{"gravity", "0"}});
  EXPECT_EQ(state.column("c_l[1]")[0], 2.1379199999999997e-05);
  EXPECT_EQ(state.column("c_l[2]")[0], 1.7999999999999999e-06);
  EXPECT_EQ(state.column("c_l[3]")[0], 2.9856000000000011e-06);
}

TEST(MultisphereAb, PlanarRotationTurnsByOmegaTimesTime) {
  // constant omega: the angle is omega t at any order, and nothing leaves the plane
  const double half_angle = 0.5 * 37 * flight_time;
  for (int order = 1; order <= 4; ++order) {
    const Table state = fly(ab(order, " planar yes"), 500,
                            {{"omega", "0 0 37"}, {"orientation", "1 0 0 0"}, {"velocity_z", "0"}});
    EXPECT_NEAR(state.column("c_q[1]")[0], std::cos(half_angle), 1e-12) << order;
    EXPECT_NEAR(state.column("c_q[4]")[0], std::sin(half_angle), 1e-12) << order;
    for (const char* out_of_plane : {"c_q[2]", "c_q[3]", "c_w[1]", "c_w[2]", "c_v[3]"})
      EXPECT_EQ(state.column(out_of_plane)[0], 0) << order << " " << out_of_plane;
    EXPECT_LT(std::abs(state.column("c_x[3]")[0]), 1e-9) << order;
  }
}

TEST(MultisphereAb, PlanarAndSpatialStepsAgreeInThePlane) {
  // same method on the same motion; only the way of turning differs, by the error of the quaternion
  const std::map<std::string, std::string> vars = {
      {"omega", "0 0 37"}, {"orientation", "1 0 0 0"}, {"velocity_z", "0"}};
  const Table planar = fly(ab(3, " planar yes"), 1000, vars);
  const Table spatial = fly(ab(3, " planar no"), 1000, vars);
  for (const std::string& name : planar.names())
    EXPECT_NEAR(planar.column(name)[0], spatial.column(name)[0], 1e-6) << name;
  EXPECT_NEAR(planar.column("c_x[2]")[0], spatial.column("c_x[2]")[0], 1e-15);
}

TEST(MultisphereAb, PlanarAutoFollowsEnforce2d) {
  // the same steps, whether asked for or found out; enforce2d itself may round the orientation
  const Table asked = last_state("rocking_body", {{"integrator", ab(3, " planar yes")}});
  const Table found = last_state("rocking_body", {{"integrator", ab(3)}, {"flat", "1"}});
  for (const std::string& name : asked.names())
    EXPECT_NEAR(found.column(name)[0], asked.column(name)[0],
                1e-12 * std::abs(asked.column(name)[0]))
        << name;
}

TEST(MultisphereAb, BodyBornMidRunMovesLikeOneBornAtTheStart) {
  // born 300 steps later and 300 steps shorter in flight: same increments, hence the same motion
  const Table early = fly(ab(3), 700, {{"timestep", "1e-4"}});
  const auto run = run_liggghts("verification/free_flight/in.free_flight",
                                {{"integrator", ab(3)},
                                 {"timestep", exact(flight_time / 700)},
                                 {"steps", "1001"},
                                 {"every", "1001"},
                                 {"second", "301"}});
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const Table late = read_dump(run.folder / "state.dump");
  ASSERT_EQ(late.rows(), 2u);
  for (const std::string& name : early.names()) {
    if (name == "c_id") continue;
    const bool position = name.find("c_x") == 0;  // another place within 1e-9 of (0.05, 0, 0)
    const double shift = name == "c_x[1]" ? 0.05 : 0;
    EXPECT_NEAR(late.column(name)[1] - shift, early.column(name)[0], position ? 2e-9 : 1e-13)
        << name;
  }
}

// y, vy, angle and omega of the rocking body; equations and numbers in the deck's header
TEST(MultisphereAb, BodyInElasticContactIsOfTheOrderAsked) {
  const double m = 1e-3, moment = 2e-8, k = 1000, g = 981, r = 2e-3, arm = 4e-3, time = 1e-2;
  const State solution =
      integrate({0.0016000003565837314, 0, 0, 50}, time, 20000, [&](const State& y) {
        const double left = k * (r - (y[0] - arm * std::sin(y[2])));
        const double right = k * (r - (y[0] + arm * std::sin(y[2])));
        EXPECT_GT(std::min(left, right), 0) << "the contact opened";
        return State{y[1], (left + right) / m - g, y[3],
                     arm * std::cos(y[2]) * (right - left) / moment};
      });
  for (int order = 1; order <= 3; ++order) {
    double error[2];
    for (int fine = 0; fine < 2; ++fine) {
      const int steps = 2000 * (fine + 1);
      const Table state = last_state("rocking_body", {{"integrator", ab(order, " planar yes")},
                                                      {"timestep", exact(time / steps)},
                                                      {"steps", std::to_string(steps + 1)}});
      const double angle = 2 * std::atan2(state.column("c_q[4]")[0], state.column("c_q[1]")[0]);
      error[fine] = std::hypot((state.column("c_x[2]")[0] - solution[0]) / 1e-4,
                               (angle - solution[2]) / 4e-2);
    }
    EXPECT_NEAR(observed_order(error[0], error[1]), order, 0.1)
        << "order " << order << ", errors " << error[0] << " " << error[1];
  }
}
