// SPDX-License-Identifier: GPL-2.0-or-later
// fix multisphere/ab mass_scaling: the frequency of a rod on the floor, and what it allows.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "deck.h"
#include "liggghts_run.h"
#include "rodpack/motion/stability_limit.h"

namespace {

using namespace rodpack::test;
using rodpack::stability_limit;
using testing::HasSubstr;
using Vars = std::map<std::string, std::string>;

// A smooth rod of AR 5 lies on the floor, nine spheres of 1000 N/m each. Its inertia is that of
// five spheres in a row, 2/5 m R^2 along it and 8.4 m R^2 across; the squares of the arms of the
// nine sum up to 60 R^2. In the plane the weight of its contacts is 9 + (60 + 9) / 8.4, in space
// also 9 times 1/0.4 about its axis and once more (60 + 9) / 8.4.
const double kn = 1000, radius = 1.5e-3;
const double mass = 2500 * M_PI * std::pow(radius, 3) * (12 - 40.0 / 12);
const double in_plane = 9 + 69 / 8.4, in_space = in_plane + 9 / 0.4 + 69 / 8.4;
const double frequency = std::sqrt(9 * kn / mass);  // 1/s, without mass scaling

Run rod_on_floor(int order, double eta, double timestep, const std::string& options,
                 Vars more = {}) {
  more.insert({{"order", std::to_string(order)},
               {"eta", exact(eta)},
               {"spheres", "9"},
               {"options", options},
               {"timestep", exact(timestep)}});
  auto run = run_liggghts("accuracy/in.stability", more);
  EXPECT_EQ(run.exit_code, 0) << run.output;
  return run;
}

bool has_grown(const Run& run) { return std::filesystem::exists(run.folder / "grown.txt"); }

/// Angular frequency times the time step, from the times between changes of sign of the excursion.
double measured_frequency(const Run& run) {
  const Table table = read_table(run.folder / "early.txt");
  const std::vector<double>& out = table.column("out");
  double first = -1, last = -1;
  int crossings = 0;
  for (std::size_t k = 1; k < out.size(); ++k) {
    if (out[k - 1] * out[k] > 0) continue;
    last = static_cast<double>(k) - out[k] / (out[k] - out[k - 1]);
    if (crossings++ == 0) first = last;
  }
  return crossings < 3 ? 0 : M_PI * (crossings - 1) / (last - first);
}

}  // namespace

// sqrt(9 k / (f m)), f = weight / S^2: 4.30 in the plane with S = 2, 5.33 in space with S = 3.
TEST(MassScaling, ARodOnTheFloorOscillatesSlowerByTheRootOfTheFactor) {
  const double timestep = 0.05 / frequency;
  EXPECT_NEAR(measured_frequency(rod_on_floor(4, 0, timestep, "events no")) / 0.05, 1, 1e-3);
  EXPECT_NEAR(measured_frequency(rod_on_floor(4, 0, timestep, "events no mass_scaling 2")) / 0.05,
              2 / std::sqrt(in_plane), 1e-3);
  EXPECT_NEAR(
      measured_frequency(rod_on_floor(4, 0, timestep, "events no planar no mass_scaling 3")) / 0.05,
      3 / std::sqrt(in_space), 1e-3);
}

// The damping ratio is that of nine dashpots, 3 eta, over the root of the factor. Both sides of the
// limit; the check knows it, too.
TEST(MassScaling, ItsStepIsThatOfTheSlowerOscillation) {
  const double eta = 0.2, slower = 2 / std::sqrt(in_plane);
  const double plain = stability_limit(2, 3 * eta) / frequency;
  const double scaled = stability_limit(2, 3 * eta * slower) / (slower * frequency);
  ASSERT_GT(scaled, 1.5 * plain);
  const std::string with = "events no mass_scaling 2";
  EXPECT_TRUE(has_grown(rod_on_floor(2, eta, 1.02 * plain, "events no")));
  const auto below = rod_on_floor(2, eta, 0.98 * scaled, with);
  EXPECT_FALSE(has_grown(below));
  EXPECT_TRUE(has_grown(rod_on_floor(2, eta, 1.02 * scaled, with)));
  EXPECT_NEAR(read_table(below.folder / "check.txt").column("limit").at(0) / scaled, 1, 1e-3);
}

TEST(MassScaling, OtherContactModelsAreRefused) {
  const std::string lines = R"(
fix rods all particletemplate/multisphere/spherocylinder 1 atom_type 1 type 1 aspect_ratio 2 diameter 3e-3 surface smooth density constant 2500 planar yes
fix motion all multisphere/ab mass_scaling 3
fix in all insert/line 1 template rods 1 per_line 1 x 0.01 0.09 y 0.05 z 0 total 1 interval 1
run 1
)";
  EXPECT_THAT(run_liggghts(Deck().hertz().with(lines)).output,
              HasSubstr("Fix multisphere/ab (id motion): mass_scaling needs 'model "
                        "spring_dashpot', which counts contacts; the pair style has another"));
}

TEST(StableTimestep, IsTheFractionOfTheClosedForm) {
  // Order 2, S eta = 0.6: stability_limit.h; the mass as above; three digits, rounded down.
  const auto run = run_liggghts(R"(
stable_timestep step order 2 mass_scaling 3 stiffness 1000 damping_ratio 0.2 aspect_ratio 5 diameter 3e-3 density 2500 steps_per_collision 2
stable_timestep few order 2 mass_scaling 3 stiffness 1000 damping_ratio 0.2 aspect_ratio 5 diameter 3e-3 density 2500 steps_per_collision 100
stable_timestep relaxed order 0 mass_scaling 6.5 relaxation_steps 1 stiffness 1000 damping_ratio 0.2 aspect_ratio 5 diameter 3e-3 density 2500
print "step=${step} few=${few} relaxed=${relaxed}"
)");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const double of_pair = std::sqrt(2 * kn / mass);
  const double limit = stability_limit(2, 0.6) / (3 * of_pair);
  const double collision = M_PI / (of_pair * std::sqrt(1 - 0.04));
  const auto value = [&](const std::string& name) {
    return std::stod(run.output.substr(run.output.rfind(name + "=") + name.size() + 1));
  };
  // With y = S omega_0 dt: y^2 + 4 S eta y tanh(1/2) = 4.
  const double damped = 2 * 6.5 * 0.2 * std::tanh(0.5);
  const double relaxed = (std::sqrt(damped * damped + 4) - damped) / (6.5 * of_pair);
  for (const auto& [name, expected] :
       {std::make_pair("step", 0.9 * limit), std::make_pair("few", collision / 100),
        std::make_pair("relaxed", 0.9 * relaxed)}) {
    EXPECT_LE(value(name), expected * (1 + 1e-12)) << name;
    EXPECT_GT(value(name), 0.99 * expected) << name;
  }
}

TEST(StableTimestep, RefusesWhatItCannotUse) {
  const auto output = [](const std::string& words) {
    return run_liggghts("\nstable_timestep t " + words + "\n").output;
  };
  const std::string rest = " stiffness 1000 aspect_ratio 5 diameter 3e-3 density 2500";
  EXPECT_THAT(
      output("order 5 mass_scaling 3 damping_ratio 0.2" + rest),
      HasSubstr(
          "stable_timestep: order is '5', expected a whole number in [0, 4], 0 for leapfrog"));
  EXPECT_THAT(output("order 2 mass_scaling 3 damping_ratio 0.2 relaxation_steps 1" + rest),
              HasSubstr("relaxation_steps is '1' with order 2, expected 0, or order 0"));
  EXPECT_THAT(output("order 2 mass_scaling 0 damping_ratio 0.2" + rest),
              HasSubstr("mass_scaling is '0', expected a ratio of frequencies in [1, 1000]"));
  EXPECT_THAT(output("order 2 mass_scaling 3 damping_ratio 0" + rest),
              HasSubstr("no step of order 2 is stable without damping"));
  EXPECT_THAT(output("order 2 mass_scaling 3" + rest), HasSubstr("damping_ratio"));
  EXPECT_THAT(output("step 2"), HasSubstr("unknown keyword 'step'"));
}
