// SPDX-License-Identifier: GPL-2.0-or-later
// multisphere/ab with `events yes`: the order of the integrator through collisions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "deck.h"
#include "liggghts_run.h"
#include "campaigns/accuracy/accuracy.h"
#include "table.h"

using namespace rodpack::test;

namespace {

rodpack::AccuracySummary measured(const std::string& scene, const std::string& method) {
  rodpack::AccuracySettings settings;
  settings.liggghts.program = RODPACK_BIN "/liggghts";
  settings.inputs = RODPACK_REPOSITORY "/inputs";
  settings.scenes = {scene};
  settings.methods = {method};
  settings.steps = {28.37, 57.37, 114.37, 229.37};
  settings.repeats = 1;
  settings.timed_steps = 100;
  std::ostringstream progress;
  const auto rows = rodpack::measure_accuracy(settings, fresh_folder().string(), progress);
  return rodpack::summarise(rows, rodpack::accuracy_scene(scene).contact_time / rodpack::paper_step,
                            25, 1e-11);
}

using Vars = std::map<std::string, std::string>;

const char* with_events = "multisphere/ab order 3 planar yes events yes";
const char* without_events = "multisphere/ab order 3 planar yes events no";

// A deck's text, with one replacement.
std::string changed_deck(const std::string& name, const std::string& from, const std::string& to) {
  std::ifstream stream(RODPACK_REPOSITORY "/inputs/" + name);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  const auto at = text.find(from);
  if (at == std::string::npos) throw std::runtime_error(name + " has no '" + from + "'");
  return text.replace(at, from.size(), to);
}

Table end_of(const std::string& deck, const Vars& vars, int ranks = 1) {
  const auto run = run_liggghts(deck, vars, ranks);
  if (run.exit_code != 0) throw std::runtime_error(run.output);
  return read_dump(run.folder / "end.dump");
}

/// Largest difference of a column, over the largest value.
double difference(const Table& a, const Table& b, const std::string& name) {
  double worst = 0, scale = 0;
  for (std::size_t i = 0; i < a.rows(); ++i) {
    worst = std::max(worst, std::fabs(a.column(name)[i] - b.column(name)[i]));
    scale = std::max(scale, std::fabs(a.column(name)[i]));
  }
  return worst / scale;
}

// A rod of AR 5, tilted by 5 degrees, lands on its side: the 9 spheres touch one after the other.
Vars tilted_rod(const std::string& integrator) {
  return {{"integrator", integrator},
          {"rods", "8"},
          {"height", "0.0024"},
          {"orientation", exact(std::cos(M_PI / 72)) + " 0 0 " + exact(std::sin(M_PI / 72))}};
}

}  // namespace

// Head-on, the rebound speed against the closed form, at moments of touch all over the step; and
// the rod that falls on its end, with the law's own friction. Without events the same scenes are of
// first order once there is a dashpot.
TEST(ContactEvents, CollisionsAreOfThirdOrder) {
  const std::map<std::string, double> gain = {
      {"collision_0", 1}, {"collision_0.2", 12}, {"collision_0.5", 20}, {"rod_drop", 50}};
  for (const auto& [scene, factor] : gain) {
    const auto with = measured(scene, "ab3e"), without = measured(scene, "ab3");
    ASSERT_TRUE(with.order && with.paper_error && without.paper_error) << scene;
    EXPECT_GT(*with.order, 2.8) << scene;
    EXPECT_LT(*with.order, 3.7) << scene;  // at eta = 0.5 terms of two orders cancel in part
    EXPECT_LT(*with.paper_error * factor, *without.paper_error) << scene;
  }
}

// The contact begins to slide at touch and sticks later: the moment is found within the step, and
// the cap that the spring then carried from its value, rate and curvature.
TEST(ContactEvents, ChangeFromSlidingToStickingIsOfThirdOrder) {
  const auto with = measured("oblique_slip", "ab3e"), without = measured("oblique_slip", "ab3");
  ASSERT_TRUE(with.order && with.paper_error && without.paper_error);
  EXPECT_GT(*with.order, 2.8);
  EXPECT_LT(*with.paper_error * 12, *without.paper_error);
}

// A rod rocks on its ends and slaps down on all of its spheres within a step or two: what touches
// makes other contacts of the same body open, slide or stick in that very step. Left out, such
// coincidences would make it order 2.4.
TEST(ContactEvents, RodsThatSlapDownAreOfThirdOrder) {
  for (const std::string scene : {"rod_rocking", "rod_rocking_smooth"}) {
    const auto with = measured(scene, "ab3e");
    ASSERT_TRUE(with.order) << scene;
    EXPECT_GT(*with.order, 2.6) << scene;
  }
}

// Oblique, stuck from touch to end (mu so large that no step sees the cap), with dashpots along
// both directions: the tangential force jumps at both ends. The reference is the same method at a
// step 16 times finer than the finest, which the method without events approaches too.
TEST(ContactEvents, ObliqueStickingCollisionIsOfThirdOrder) {
  const double contact = 4.176e-4, time = 3.2e-4 + 2.2 * contact;
  for (const std::string eta : {"0", "0.2", "0.5"}) {
    const auto end = [&](const char* integrator, double per_contact) {
      const double dt = contact / per_contact;
      return end_of("accuracy/in.collision", {{"integrator", integrator},
                                              {"dt", exact(dt)},
                                              {"steps", std::to_string(std::lround(time / dt))},
                                              {"pairs", "8"},
                                              {"shift", exact(contact / 20 / 6)},
                                              {"offset", "1e-3"},
                                              {"eta_n", eta},
                                              {"eta_t", eta},
                                              {"mu", "1e6"}});
    };
    const Table reference = end(with_events, 162.96 * 16);
    const auto error = [&](const char* integrator, double per_contact) {
      const Table found = end(integrator, per_contact);
      double sum = 0;
      for (std::size_t i = 0; i < found.rows(); ++i)
        for (const auto& [name, scale] :
             {std::pair("vx", 1.0), std::pair("vy", 1.0), std::pair("omegaz", 1.5e-3)})
          sum += std::pow(scale * (found.column(name)[i] - reference.column(name)[i]), 2);
      return std::sqrt(sum / found.rows());
    };
    const double coarse = error(with_events, 40.74), fine = error(with_events, 162.96);
    std::printf("eta %s: %.2e, %.2e, order %.2f\n", eta.c_str(), coarse, fine,
                observed_order(coarse, fine, 4));
    EXPECT_GT(observed_order(coarse, fine, 4), 2.8) << eta;
    const double plain_coarse = error(without_events, 40.74),
                 plain_fine = error(without_events, 162.96);
    EXPECT_NEAR(observed_order(plain_coarse, plain_fine, 4), 1, 0.3) << eta;
    EXPECT_LT(coarse * 9, plain_coarse) << eta;
  }
}

// Other forces act at the time of touch (here 50 times gravity), so that the closing speed is not
// constant: what is guessed of the force's slope at touch is made good one step later. Without
// friction, so that touch and end are the only events; the dashpot along the contact is there.
TEST(ContactEvents, TouchUnderOtherForcesIsOfThirdOrder) {
  const double time = 1.6e-3;
  const auto end = [&](int steps) {
    return end_of("accuracy/in.rods", {{"integrator", with_events},
                                       {"dt", exact(time / steps)},
                                       {"steps", std::to_string(steps)},
                                       {"rods", "4"},
                                       {"height", "0.00724"},
                                       {"shift", "3.1e-7"},
                                       {"gravity", "500"},
                                       {"mu", "0"}});
  };
  const Table reference = end(120 * 64);
  const auto error = [&](int steps) {
    const Table found = end(steps);
    double sum = 0;
    for (std::size_t i = 0; i < found.rows(); ++i)
      for (const auto& [name, scale] : {std::pair("vy", 1.0), std::pair("omegaz", 5e-3)})
        sum += std::pow(scale * (found.column(name)[i] - reference.column(name)[i]), 2);
    return std::sqrt(sum / found.rows());
  };
  const double coarse = error(120), fine = error(480);
  EXPECT_GT(observed_order(coarse, fine, 4), 2.8);
  EXPECT_LT(coarse, 2e-5);
  for (const double vx : reference.column("vx")) EXPECT_EQ(vx, 0);  // no friction
}

// What one body of a contact gains, the other loses, whatever their masses and whichever rank owns
// them: with two ranks each pair collides across their border.
TEST(ContactEvents, MomentumIsConservedToRoundingOnAnyRanks) {
  std::string deck =
      changed_deck("accuracy/in.collision", "processors      1 1 1", "processors * 1 1");
  const auto replace = [&deck](const std::string& from, const std::string& to) {
    const auto at = deck.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    deck.replace(at, from.size(), to);
  };
  replace("fix             mix all",
          "fix heavy all particletemplate/multisphere/spherocylinder 1 atom_type 1 type 2 "
          "aspect_ratio 1 diameter 0.004 surface smooth density constant 2500 planar yes\n"
          "fix other all particledistribution/discrete 15485867 1 heavy 1.0\n"
          "fix             mix all");
  replace("fix             right${p} all insert/pack seed 32452843 distributiontemplate mix",
          "fix right${p} all insert/pack seed 32452843 distributiontemplate other");
  for (const int ranks : {1, 2}) {
    const Table end = end_of(deck,
                             {{"offset", "1e-3"},
                              {"spin", "150"},
                              {"distance", "3.6e-3"},
                              {"integrator", with_events},
                              {"pairs", "6"}},
                             ranks);
    const auto& mass = end.column("mass");
    const double before = 0.5 * (mass[0] - mass[1]);
    EXPECT_GT(std::fabs(before), 0.2 * mass[0]);
    for (std::size_t i = 0; i < end.rows(); i += 2) {
      const auto &vx = end.column("vx"), &vy = end.column("vy");
      EXPECT_GT(std::fabs(vy[i]), 1e-3);  // it has collided
      EXPECT_NEAR((mass[i] * vx[i] + mass[i + 1] * vx[i + 1]) / before, 1, 1e-13) << ranks;
      EXPECT_NEAR((mass[i] * vy[i] + mass[i + 1] * vy[i + 1]) / before, 0, 1e-13) << ranks;
    }
  }
}

// A run may end on any step, that of an event too: ghosts are made anew when the next one is set
// up.
TEST(ContactEvents, RunsOfOneStepAgreeWithOneLongRunOnTwoRanks) {
  std::string deck =
      changed_deck("accuracy/in.collision", "processors      1 1 1", "processors * 1 1");
  const std::string in_one = deck;
  const auto at = deck.find("run             ${steps}");
  ASSERT_NE(at, std::string::npos);
  deck.replace(at, std::string("run             ${steps}").size(),
               "variable stretch loop 70\nlabel again\nrun 1\nnext stretch\njump SELF again");
  const Vars vars = {
      {"offset", "1e-3"}, {"integrator", with_events}, {"pairs", "4"}, {"steps", "70"}};
  const Table long_run = end_of(in_one, vars, 2), short_runs = end_of(deck, vars, 2);
  for (const char* name : {"x", "y", "vx", "vy", "omegaz"})
    EXPECT_LT(difference(long_run, short_runs, name), 1e-10) << name;
}

// Planar motion is a special case of motion in space, and takes another path through the code.
TEST(ContactEvents, MotionInSpaceAgreesWithPlanarMotion) {
  Vars space = tilted_rod("multisphere/ab order 3 planar no events yes");
  space["planar"] = "0";
  const Table a = end_of("accuracy/in.rods", tilted_rod(with_events));
  const Table b = end_of("accuracy/in.rods", space);
  for (const char* name : {"x", "y", "vx", "vy", "omegaz"})
    EXPECT_LT(difference(a, b, name), 1e-7) << name;  // the quaternion's step is not exact
}

// With two ranks each pair collides across the border of the ranks at x = 0, and one rod lies
// across it; with four, two rods do.
TEST(ContactEvents, RanksAgreeWithOneRankToRounding) {
  const std::string pairs =
      changed_deck("accuracy/in.collision", "processors      1 1 1", "processors * 1 1");
  const std::string rods =
      changed_deck("accuracy/in.rods", "processors      1 1 1", "processors * 1 1");
  const Vars collision = {{"offset", "1e-3"}, {"integrator", with_events}, {"pairs", "6"}};
  const Table one_pair = end_of(pairs, collision), one_rod = end_of(rods, tilted_rod(with_events));
  for (const int ranks : {2, 4}) {
    const Table pair = end_of(pairs, collision, ranks);
    const Table rod = end_of(rods, tilted_rod(with_events), ranks);
    ASSERT_EQ(pair.rows(), one_pair.rows());
    ASSERT_EQ(rod.rows(), one_rod.rows());
    for (const char* name : {"x", "y", "vx", "vy", "omegaz"}) {
      EXPECT_LT(difference(one_pair, pair, name), 1e-10) << ranks << name;
      EXPECT_LT(difference(one_rod, rod, name), 1e-10) << ranks << name;
    }
  }
}

TEST(ContactEvents, AWrongValueIsAnError) {
  const auto run = run_liggghts("accuracy/in.collision",
                                {{"integrator", "multisphere/ab order 3 events maybe"}});
  EXPECT_NE(run.exit_code, 0);
  EXPECT_THAT(run.output, testing::HasSubstr("events"));
  EXPECT_THAT(run.output, testing::HasSubstr("maybe"));
}
