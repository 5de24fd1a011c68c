// SPDX-License-Identifier: GPL-2.0-or-later
#include "campaigns/accuracy/accuracy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "../physics/collision_reference.h"
#include "liggghts_run.h"
#include "campaigns/accuracy/accuracy_references.h"
#include "rodpack/contact/contact_law.h"
#include "reading/data_error.h"
#include "rodpack/geometry/mass_properties.h"
#include "reading/number_text.h"
#include "reading/table.h"
#include "rodpack/version.h"

namespace {

using namespace rodpack;
using testing::HasSubstr;
namespace fs = std::filesystem;

constexpr Scheme schemes[] = {Scheme::runge_kutta_4, Scheme::dormand_prince_5};

SpherePair spheres() {
  SpherePair pair;
  pair.radius = 1.5e-3;
  pair.mass = 2500 * 4.0 / 3.0 * M_PI * std::pow(pair.radius, 3);
  return pair;
}

double contact_time(const SpherePair& pair) {
  return M_PI * std::sqrt(0.5 * pair.mass / pair.law.kn);
}

RodOnFloor smooth_rod() {
  const ChainShape shape{5, 3e-3, 0.5, 0, 3e-3};
  const auto solid = mass_properties(shape, 2500, MassRule::reference, false);
  RodOnFloor rod;
  rod.mass = solid.mass;
  rod.inertia = solid.inertia[2];
  rod.radius = 1.5e-3;
  for (const auto& centre : sphere_centres(shape)) rod.places.push_back(centre[0]);
  return rod;
}

std::vector<AccuracyRow> rows(const std::vector<double>& steps, const std::vector<double>& errors) {
  std::vector<AccuracyRow> result;
  for (std::size_t i = 0; i < steps.size(); ++i)
    result.push_back({"scene", "ab3", 3, steps[i], errors[i], 2 * steps[i], 1e-5 * steps[i]});
  return result;
}

}  // namespace

// Schwager and Poeschel's closed form, which knows nothing of an integration
TEST(AccuracyReference, HeadOnCollisionHasTheRestitutionOfTheClosedForm) {
  for (const Scheme scheme : schemes) {
    for (const double eta : {0.0, 0.1, 0.2, 0.35, 0.5}) {
      SpherePair pair = spheres();
      pair.law.eta_n = eta;
      const auto end = collide(pair, contact_time(pair) / 3000, scheme);
      EXPECT_NEAR(-end.vx / (2 * pair.speed), restitution_coefficient(eta), 1e-12) << eta;
      EXPECT_EQ(end.omega, 0);
    }
  }
}

// The events are located, so that each scheme keeps its order: 4 means a factor of 16
TEST(AccuracyReference, SchemesKeepTheirOrderThroughTheEvents) {
  SpherePair pair = spheres();
  pair.offset = 1.5e-3;
  const double contact = contact_time(pair);
  const auto exact = collide(pair, contact / 3000, Scheme::dormand_prince_5);
  const auto error = [&](double steps) {
    return std::fabs(collide(pair, contact / steps, Scheme::runge_kutta_4).vy - exact.vy);
  };
  EXPECT_NEAR(std::log2(error(40) / error(80)), 4, 0.5);
}

// CollisionReference has no events: its cap acts at the ends of steps of 1/100000 of a contact
TEST(AccuracyReference, ObliqueCollisionAgreesWithTheOtherIntegration) {
  for (const double offset : {0.5e-3, 1.5e-3}) {
    rodpack::test::CollisionReference other;
    SpherePair pair = spheres();
    other.offset = pair.offset = offset;
    const auto expected = other.at(1);
    const auto end = collide(pair, contact_time(pair) / 1000, Scheme::dormand_prince_5);
    EXPECT_NEAR(end.vx, expected[rodpack::test::CollisionReference::U], 1e-5) << offset;
    EXPECT_NEAR(end.vy, expected[rodpack::test::CollisionReference::V], 1e-5) << offset;
    EXPECT_NEAR(pair.radius * end.omega,
                pair.radius * expected[rodpack::test::CollisionReference::OMEGA], 1e-4)
        << offset;
  }
}

// Springs alone give the energy back: m/4 (u^2 + v^2) + I/4 (sum of spins)^2, without spin before.
// With k_t / k_n = 2/7 the tangential spring has let go when the contact ends.
TEST(AccuracyReference, StickingContactOfSpringsKeepsTheEnergy) {
  SpherePair pair = spheres();
  pair.law = {1000, 1000 * 2.0 / 7.0, 0, 0, 100};
  pair.offset = 1.5e-3;
  const auto end = collide(pair, contact_time(pair) / 3000, Scheme::dormand_prince_5);
  const double inertia_over_mass = 0.4 * pair.radius * pair.radius;
  const double before = std::pow(2 * pair.speed, 2);
  const double after =
      end.vx * end.vx + end.vy * end.vy + inertia_over_mass * end.omega * end.omega;
  EXPECT_GT(inertia_over_mass * end.omega * end.omega / before, 0.1);
  EXPECT_NEAR(after / before, 1, 1e-3);
}

// Upright, the rod's centre is above its contact: a mass on a spring-dashpot, m_ij = m
TEST(AccuracyReference, UprightRodBouncesLikeASphere) {
  const RodOnFloor rod = smooth_rod();
  const auto end =
      move(rod, {0, 7.6e-3, M_PI / 2, 0, -0.5, 0}, 4e-3, 1e-6, Scheme::dormand_prince_5);
  EXPECT_NEAR(end.vy / 0.5, restitution_coefficient(0.2), 1e-12);
  EXPECT_NEAR(end.omega, 0, 1e-9);
}

// Springs only, so that friction is mu times the normal force, against the end's velocity along x,
// vx + (r + a sin) omega < 0 with a = 6 mm to the end at 60 degrees: the impulses are m (mu, 1)
// dvy, and their moment is that of the contact point at (-a cos, -a sin - r), but for its way
// during the contact and half the overlap.
TEST(AccuracyReference, SlidingRodTurnsByTheMomentOfItsImpulses) {
  RodOnFloor rod = smooth_rod();
  rod.law = {1e5, 5e4, 0, 0, 0.1};  // stiff: a short contact, in which the rod hardly turns
  const double angle = M_PI / 3, a = 6e-3, r = rod.radius;
  const PlanarState start = {0, r + a * std::sin(angle) + 1e-6, angle, 0, -0.5, -100};
  const auto end = move(rod, start, 5e-4, 1e-7, Scheme::dormand_prince_5);
  const double impulse = rod.mass * (end.vy - start.vy);
  EXPECT_GT(impulse, 0);
  EXPECT_NEAR(end.vx * rod.mass / impulse, 0.1, 1e-9);
  const double moment = -a * std::cos(angle) + 0.1 * (a * std::sin(angle) + r);
  EXPECT_NEAR((end.omega - start.omega) * rod.inertia / (moment * impulse), 1, 0.05);
}

// Against Euler's equations in the body frame, by Runge-Kutta
TEST(AccuracyReference, SymmetricTopFollowsEulersEquations) {
  const double along = 1, across = 7, time = 0.05;
  const std::array<double, 4> start = {0.5, 0.5, 0.5, 0.5};  // body x, y, z along space y, z, x
  const std::array<double, 3> omega = {120, 200, -80};
  std::array<double, 7> y = {0.5, 0.5, 0.5, 0.5, 200, -80, 120};
  const auto rate = [&](const std::array<double, 7>& s) {
    const double *q = &s[0], *w = &s[4];
    return std::array<double, 7>{0.5 * (-q[1] * w[0] - q[2] * w[1] - q[3] * w[2]),
                                 0.5 * (q[0] * w[0] + q[2] * w[2] - q[3] * w[1]),
                                 0.5 * (q[0] * w[1] + q[3] * w[0] - q[1] * w[2]),
                                 0.5 * (q[0] * w[2] + q[1] * w[1] - q[2] * w[0]),
                                 0,
                                 (across - along) * w[2] * w[0] / across,
                                 (along - across) * w[0] * w[1] / across};
  };
  const int steps = 20000;
  const double h = time / steps;
  const auto at = [&](const std::array<double, 7>& k, double weight) {
    auto z = y;
    for (int i = 0; i < 7; ++i) z[i] += weight * h * k[i];
    return z;
  };
  for (int n = 0; n < steps; ++n) {
    const auto k1 = rate(y), k2 = rate(at(k1, 0.5)), k3 = rate(at(k2, 0.5)), k4 = rate(at(k3, 1));
    for (int i = 0; i < 7; ++i) y[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
  }
  const auto q = symmetric_top(start, omega, along, across, time);
  const double sign = q[0] * y[0] + q[1] * y[1] + q[2] * y[2] + q[3] * y[3] > 0 ? 1 : -1;
  for (int d = 0; d < 4; ++d) EXPECT_NEAR(q[d], sign * y[d], 1e-10) << d;
}

TEST(AccuracyReference, TwoSchemesAgreeInEveryScene) {
  for (const auto& name : accuracy_scene_names())
    EXPECT_LT(accuracy_scene(name).agreement, 1e-10) << name;
}

// error = 3 steps^-2.5 in between; a blow-up before, rounding after, both left out
TEST(AccuracySummary, OrderIsThatOfTheAsymptoticRange) {
  const auto law = [](double n) { return 3 * std::pow(n, -2.5); };
  const std::vector<double> steps = {10, 26, 30, 60, 120, 240, 1e5};
  const auto order = observed_order(steps, {4, 0.3, law(30), law(60), law(120), law(240), 1e-10});
  ASSERT_TRUE(order);
  EXPECT_NEAR(*order, 2.5, 1e-12);
  EXPECT_FALSE(observed_order({30, 60}, {law(30), law(60)}));
  EXPECT_FALSE(observed_order({30, 60, 120}, {1e-13, 1e-13, 1e-13}));
}

// error = 10 / steps: 1e-3 at 1e4 steps, which are 2e4 evaluations and 0.1 s
TEST(AccuracySummary, CostIsReadBetweenRows) {
  const auto s = summarise(rows({9e4, 30, 3000}, {10 / 9e4, 10 / 30., 10 / 3000.}), 300);
  ASSERT_TRUE(s.evaluations && s.seconds && s.paper_error);
  EXPECT_NEAR(*s.evaluations, 2e4, 1);
  EXPECT_NEAR(*s.seconds, 0.1, 1e-5);
  EXPECT_NEAR(*s.paper_error, 10 / 300., 1e-9);
  EXPECT_FALSE(s.at_once);
}

TEST(AccuracySummary, CostNeedsErrorsThatStayBelow) {
  EXPECT_FALSE(summarise(rows({10, 100}, {1e-4, 2e-3}), 38).evaluations);
  const auto s = summarise(rows({10, 100, 1000}, {1e-4, 2e-4, 1e-5}), 38);
  EXPECT_TRUE(s.at_once);
  EXPECT_EQ(*s.evaluations, 20);
  const auto after_a_blow_up = summarise(rows({10, 100}, {INFINITY, 1e-5}), 38);
  EXPECT_EQ(*after_a_blow_up.evaluations, 200);
  EXPECT_FALSE(after_a_blow_up.at_once);
}

TEST(AccuracyScene, NamesThatAreNoneAreRefused) {
  try {
    accuracy_scene("collision_7");
    FAIL();
  } catch (const DataError& error) {
    EXPECT_THAT(error.what(), HasSubstr("scene 'collision_7': expected one of collision_0, "));
  }
  EXPECT_THROW(accuracy_method("ab5"), DataError);
}

// Touches spread over a step: pair p first touches p/12 of a step after the first pair
TEST(AccuracyScene, FirstTouchesSpreadOverOneStep) {
  const auto scene = accuracy_scene("collision_0.2");
  const double dt = 1.1e-5;
  const auto variables = scene.variables_for(accuracy_method("ab3"), dt, 100);
  EXPECT_NEAR(std::stod(variables.at("shift")) * scene.copies, 1.0 * dt, 1e-18);
  EXPECT_EQ(variables.at("integrator"), "multisphere/ab order 3 events no planar yes");
  EXPECT_EQ(scene.variables_for(accuracy_method("ab3e"), dt, 1).at("integrator"),
            "multisphere/ab order 3 events yes planar yes");
  EXPECT_EQ(scene.variables_for(accuracy_method("builtin"), dt, 1).at("integrator"), "multisphere");
}

// Born with half a kick of gravity too much, g dt/2, which stock multisphere never takes back
TEST(AccuracyScene, StockBodiesStartWithHalfAKickLess) {
  const auto scene = accuracy_scene("rod_rocking");
  const double dt = 1.1e-5;
  const auto vy = [&](const char* method) {
    return std::stod(scene.variables_for(accuracy_method(method), dt, 100).at("vy"));
  };
  EXPECT_NEAR(vy("builtin") - vy("ab3"), 0.5 * 9.81 * dt, 1e-15);
  EXPECT_EQ(vy("ab3"), -0.05);
}

// A program that leaves the exact end of spin_planar, turned by 1e-3 rad, and counts its runs
class AccuracyRun : public testing::Test {
 protected:
  AccuracyRun() {
    const auto scene = accuracy_scene("spin_planar");
    const double half = 0.5 * (800 * scene.duration + 1e-3);
    std::ofstream(folder_ / "fake")
        << "#!/bin/sh\necho run >> '" << (folder_ / "runs").string()
        << "'\ncat > end.dump << EOD\nITEM: TIMESTEP\n1\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX "
           "BOUNDS "
           "ff ff ff\n0 1\n0 1\n0 1\nITEM: ATOMS id qw qx qy qz\n1 "
        << number_text(std::cos(half), 17) << " 0 0 " << number_text(std::sin(half), 17)
        << "\nEOD\necho 'Loop time of 3 on 1 procs for 1 steps with 9 atoms'\n"
           "echo 'Loop time of 0.5 on 1 procs for 20000 steps with 9 atoms'\n";
    fs::permissions(folder_ / "fake", fs::perms::owner_all);
  }
  auto accuracy(const std::string& more = "--steps 30,60,90") {
    return rodpack::test::run_command("'" RODPACK_BIN
                                      "/rodpack' accuracy out --liggghts ./fake "
                                      "--scenes spin_planar --methods ab3 --repeats 2 " +
                                          more,
                                      folder_);
  }
  long runs() {
    long lines = 0;
    std::ifstream in(folder_ / "runs");
    for (std::string line; std::getline(in, line);) ++lines;
    return lines;
  }

  fs::path folder_ = rodpack::test::fresh_folder();
};

TEST_F(AccuracyRun, RowsHoldErrorAndCost) {
  const auto run = accuracy();
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_EQ(runs(), 5);  // two timed ones and one per step
  const auto table = read_table((folder_ / "out/accuracy.csv").string());
  EXPECT_THAT(table.names(), testing::ElementsAre("scene", "method", "order", "steps_per_contact",
                                                  "error", "force_evaluations", "seconds"));
  ASSERT_EQ(table.rows(), 3u);
  const long steps = accuracy_scene("spin_planar").steps(30);
  EXPECT_EQ(table.words("scene")[0], "spin_planar");
  EXPECT_EQ(table.words("method")[0], "ab3");
  EXPECT_EQ(table.whole_numbers("order")[0], 3);
  EXPECT_NEAR(table.column("steps_per_contact")[0], 30, 0.1);
  EXPECT_NEAR(table.column("error")[0], 1e-3, 1e-9);
  EXPECT_EQ(table.whole_numbers("force_evaluations")[0], steps);
  EXPECT_NEAR(table.column("seconds")[0], 0.5 / 20000 * steps, 1e-6);
  for (const char* file : {"accuracy.md", "spin_planar_evaluations.png", "spin_planar_seconds.svg"})
    EXPECT_TRUE(fs::exists(folder_ / "out" / file)) << file;
}

TEST_F(AccuracyRun, OnlyWhatIsMissingIsRun) {
  ASSERT_EQ(accuracy().exit_code, 0);
  const auto file = folder_ / "out/accuracy.csv";
  const auto whole = rodpack::test::text_of(file);
  ASSERT_EQ(accuracy().exit_code, 0);
  EXPECT_EQ(runs(), 5);
  std::ofstream(file) << whole.substr(0, whole.size() - 9);  // interrupted within the last row
  ASSERT_EQ(accuracy().exit_code, 0);
  EXPECT_EQ(runs(), 6);
  EXPECT_EQ(rodpack::test::text_of(file), whole);
}

TEST_F(AccuracyRun, GoesOnInAFolderOfAnOlderRodpack) {
  ASSERT_EQ(accuracy().exit_code, 0);
  auto settings = nlohmann::json::parse(rodpack::test::text_of(folder_ / "out/settings.json"));
  EXPECT_EQ(settings["rodpack"]["version"], version());
  EXPECT_EQ(settings["rodpack"]["commit"], commit());
  settings["rodpack"]["version"] = "0.0";
  std::ofstream(folder_ / "out/settings.json") << settings;
  EXPECT_EQ(accuracy().exit_code, 0);
  settings.erase("rodpack");  // rodpack 0.1 did not write it
  std::ofstream(folder_ / "out/settings.json") << settings;
  EXPECT_EQ(accuracy().exit_code, 0);
  EXPECT_EQ(runs(), 5);
}

TEST_F(AccuracyRun, OtherSettingsAndMalformedRowsAreOneLineErrors) {
  ASSERT_EQ(accuracy().exit_code, 0);
  const auto other = accuracy("--steps 31,60");
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_THAT(other.output, HasSubstr("settings.json: steps is [30.0,60.0,90.0], expected [31.0,"));
  fs::remove(folder_ / "out/settings.json");
  EXPECT_THAT(accuracy().output, HasSubstr("settings.json: expected the settings of the rows"));
  fs::remove_all(folder_ / "out");
  EXPECT_EQ(accuracy("--inputs /").exit_code, 1);  // leaves no rows behind
  ASSERT_EQ(accuracy().exit_code, 0);
  std::ofstream(folder_ / "out/accuracy.csv", std::ios::app) << "spin_planar,ab3,many\n";
  const auto malformed = accuracy();
  EXPECT_EQ(malformed.exit_code, 1);
  EXPECT_THAT(malformed.output, HasSubstr("accuracy.csv:5: expected scene,method,"));
  // Rows that no run leaves, which have made a cost or a figure of infinity.
  const std::string head = "scene,method,order,steps_per_contact,error,force_evaluations,seconds\n";
  const std::pair<const char*, const char*> rows[] = {
      {"spin_planar,ab3,3,30,nan,100,1\n", "2: expected an error of 0 or more, found 'nan'"},
      {"spin_planar,ab3,3,30,-1,100,1\n", "2: expected an error of 0 or more, found '-1'"},
      {"spin_planar,ab3,3,30,0,0,1\n", "2: expected a number above 0, found '0'"},
      {"spin_planar,ab3,3,inf,0,100,1\n", "2: expected a finite number, found 'inf'"},
      {"spin_planar,ab3,3,30,0,100,0\n", "2: expected a time above 0, found '0'"}};
  for (const auto& [row, expected] : rows) {
    std::ofstream(folder_ / "out/accuracy.csv") << head << row;
    const auto wrong = accuracy();
    EXPECT_EQ(wrong.exit_code, 1);
    EXPECT_THAT(wrong.output, HasSubstr(std::string("accuracy.csv:") + expected));
  }
}

TEST_F(AccuracyRun, WrongCommandLinesNameTheValue) {
  for (const auto& [more, expected] :
       {std::pair("--methods ab5", "--methods: expected one of"),
        {"--scenes up", "--scenes: expected one of"},
        {"--steps 1", "--steps: expected a number of 3 to 100000, found"},
        // What would run twice, or not at all.
        {"--methods ab3,ab3", "--methods: expected each once, found 'ab3' twice"},
        {"--scenes beds,beds", "--scenes: expected each once, found 'beds' twice"},
        {"--steps 28,30,28", "--steps: expected each once, found '28' twice"},
        {"--comparisons engine,engine", "--comparisons: expected each once, found 'engine' twice"},
        {"--scenes spin_3d --comparisons engine", "--comparisons: expected with the scene beds"},
        {"--scenes beds --aspect-ratio 2",
         "--aspect-ratio: expected with --comparisons other than surface, found no --comparisons"},
        {"--scenes beds --surface coarse --comparisons surface",
         "--surface: expected with --comparisons other than surface, found surface"},
        {"--surface rough", "--surface: expected one of smooth, coarse, found 'rough'"},
        {"--quick --seeds 2", "--seeds: expected with the scene beds"},
        {"--scenes stability --per-line 2", "--per-line: expected with the scene beds"},
        {"--scenes beds --steps 28", "--steps: expected with a scene other than beds"}}) {
    const auto run = rodpack::test::run_rodpack(std::string("accuracy o ") + more);
    EXPECT_EQ(run.exit_code, 2) << more;
    EXPECT_THAT(run.output, HasSubstr(expected));
  }
}
