// SPDX-License-Identifier: GPL-2.0-or-later
// Fields over the height on an inclined plane, against closed forms.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "analysis/incline/chute_motion.h"
#include "analysis/incline/chute_profile.h"
#include "liggghts_run.h"
#include "synthetic_packing.h"

namespace {
using namespace rodpack;
using test::fresh_folder;
using test::put;
using testing::HasSubstr;

constexpr double d = 1e-3, width = 10 * d, mass = 2e-6;
const double pi = std::acos(-1.0);
const double area = pi * d * d / 4;
const Slope slope{0.3, 9.81};

struct Disc {
  double x, y, vx, vy;
};

// i < 0: a wall at (x, y) acts on disc j.
struct Touch {
  int j, i;
  double x, y, fx, fy;
};

std::string bodies_text(const std::vector<Disc>& discs, long step) {
  std::ostringstream rows;
  rows.precision(17);
  int id = 0;
  for (const auto& each : discs)
    rows << ++id << " 1 1 " << each.x << ' ' << each.y << " 0 0 " << each.vx << ' ' << each.vy
         << " 0 0 0 0 1 0 0 0 " << d / 2 << ' ' << d / 2 << " 0 " << area << ' ' << mass << '\n';
  return test::frame_head(step, discs.size(), width, 1,
                          "id type nspheres x y z angle vx vy vz omegax omegay omegaz qw qx qy qz "
                          "half_length radius curvature area mass",
                          "pp ff ff") +
         rows.str();
}

std::string contacts_text(const std::vector<Disc>& discs, const std::vector<Touch>& touches,
                          long step) {
  std::ostringstream rows;
  rows.precision(17);
  for (const auto& each : touches) {
    const auto& on = discs[static_cast<std::size_t>(each.j)];
    const bool wall = each.i < 0;
    const double x = wall ? each.x : discs[static_cast<std::size_t>(each.i)].x;
    const double y = wall ? each.y : discs[static_cast<std::size_t>(each.i)].y;
    rows << each.j + 1 << ' ' << (wall ? 0 : each.i + 1) << ' ' << each.j + 1 << ' '
         << (wall ? 0 : each.i + 1) << ' ' << wall << ' ' << (wall ? x : (on.x + x) / 2) << ' '
         << (wall ? y : (on.y + y) / 2) << " 0 " << each.fx << ' ' << each.fy << " 0 " << on.x
         << ' ' << on.y << " 0 " << x << ' ' << y << " 0 1e-6 0 0 1 0\n";
  }
  return test::frame_head(step, touches.size(), width, 1,
                          "body_i body_j sphere_i sphere_j wall x y z fx fy fz bix biy biz bjx bjy "
                          "bjz overlap_n overlap_t nx ny nz",
                          "pp ff ff") +
         rows.str();
}

// A column of `count` discs a diameter apart, leaning by d/4 each. What is above a disc rests on it
// by a force of that weight, down the slope and onto it, and the lowest one on the base.
struct Column {
  std::vector<Disc> discs;
  std::vector<Touch> touches;

  explicit Column(int count) {
    const double gx = slope.gravity * std::sin(slope.angle);
    const double gy = slope.gravity * std::cos(slope.angle);
    for (int k = 0; k < count; ++k) {
      discs.push_back({5 * d + 0.25 * d * k, d / 2 + d * k, 0, 0});
      const double carried = mass * (count - k);
      touches.push_back({k, k - 1, 5 * d, 0, -carried * gx, carried * gy});
    }
  }
};

ChuteProfile profile_of(const std::vector<std::vector<Disc>>& frames,
                        const std::vector<Touch>& touches, std::optional<double> scale) {
  ChuteSample sample(slope, scale);
  const auto folder = fresh_folder();
  for (const auto& discs : frames) {
    const Frame bodies = last_frame({put(folder / "bodies.dump", bodies_text(discs, 1))});
    const Frame contacts =
        last_frame({put(folder / "contacts.dump", contacts_text(discs, touches, 1))});
    PackingOptions options;
    options.particle_diameter = d;
    sample.add(read_packing(bodies, options), bodies, contacts);
  }
  return sample.result();
}

// At rest d sigma_ay / dy = rho g_a + t_a holds for every height: with the forces of the base in
// the load, sigma_yy is the load onto and -sigma_xy the load down, to rounding, whatever the
// kernel.
TEST(ChuteProfile, AtRestTheStressesAreTheWeightAbove) {
  const Column column(12);
  for (const double scale : {0.3 * d, 1 * d, 2.5 * d}) {
    const auto profile = profile_of({column.discs}, column.touches, scale);
    const double all = 12 * mass * slope.gravity / width;
    for (std::size_t k = 0; k < profile.height.size(); ++k) {
      EXPECT_NEAR(profile.yy[k], profile.load_onto[k], 1e-12 * all) << scale << ' ' << k;
      EXPECT_NEAR(profile.xy[k], -profile.load_down[k], 1e-12 * all) << scale << ' ' << k;
    }
    EXPECT_LT(imbalance_of(profile).onto, 1e-12);
    // The load itself: six of the twelve are above y = 6 d, for a kernel of less than a diameter.
    if (scale > 0.5 * d) continue;
    const auto middle = static_cast<std::size_t>(std::lround(6 * d / (scale / 4)));
    ASSERT_NEAR(profile.height[middle], 6 * d, 1e-9);
    EXPECT_NEAR(profile.load_onto[middle], 6 * all / 12 * std::cos(slope.angle), 1e-9 * all);
    EXPECT_NEAR(profile.load_down[middle], 6 * all / 12 * std::sin(slope.angle), 1e-9 * all);
  }
}

// A contact less, and the balance is off by what it carried: 5 of the 12 discs.
TEST(ChuteProfile, MissingContactsShowAsImbalance) {
  Column column(12);
  column.touches.erase(column.touches.begin() + 7);
  const auto imbalance = imbalance_of(profile_of({column.discs}, column.touches, 0.2 * d));
  EXPECT_NEAR(imbalance.onto, 5. / 12, 0.02);
  EXPECT_NEAR(imbalance.down, 5. / 12 * std::tan(slope.angle), 0.02);
}

// Rows of discs so dense that sums are integrals, in a flow u = a (H^(3/2) - (H - y)^(3/2)), the
// profile of Bagnold: shear rate 3/2 a (H - y)^(1/2). Far from the ends the Gaussian of scale w
// makes of it 3/2 a (H - y)^(1/2) (1 - w^2 / (8 (H - y)^2) ...), 0.4 % at 3 w from the surface of
// 20 d.
TEST(ChuteProfile, ShearRateOfBagnoldsProfileGrowsWithTheRootOfTheDepth) {
  const double high = 20 * d, a = 100;
  std::vector<Disc> discs;
  constexpr int rows = 400;
  for (int k = 0; k < rows; ++k) {
    const double y = (k + 0.5) * high / rows;
    discs.push_back({5 * d, y, a * (std::pow(high, 1.5) - std::pow(high - y, 1.5)), 0});
  }
  // One contact without force, since there has to be one.
  auto profile = profile_of({discs}, {{0, 1, 0, 0, 0, 0}}, d);
  profile.surface = high;
  int seen = 0;
  for (std::size_t k = 0; k < profile.height.size(); ++k) {
    const double y = profile.height[k];
    if (y < 4 * d || y > high - 4 * d) continue;
    EXPECT_NEAR(profile.shear_rate[k], 1.5 * a * std::sqrt(high - y),
                0.01 * 1.5 * a * std::sqrt(high - y));
    ++seen;
  }
  EXPECT_GT(seen, 30);
  const auto shear = fit_shear(profile);
  ASSERT_TRUE(shear);
  EXPECT_NEAR(shear->exponent, 0.5, 0.01);
  EXPECT_LT(shear->exponent_error, 0.02);
}

// Two frames of one disc at u0 + v and u0 - v: the mean velocity is u0, the kinetic stress along y
// m v_y^2 phi, and across m v_x v_y phi, phi = 1 / (sqrt(2 pi) w W) at the disc.
TEST(ChuteProfile, KineticStressIsThatOfTheDeviationsFromTheMeanOfAllFrames) {
  const double u0 = 0.3, vx = 0.02, vy = 0.05, y = 2 * d;
  const std::vector<Disc> first{{5 * d, y, u0 + vx, vy}, {8 * d, y, u0 + vx, vy}};
  const std::vector<Disc> second{{5 * d, y, u0 - vx, -vy}, {8 * d, y, u0 - vx, -vy}};
  const auto profile = profile_of({first, second}, {{0, 1, 0, 0, 0, 0}}, d);
  const auto at = static_cast<std::size_t>(8);
  ASSERT_NEAR(profile.height[at], y, 1e-12);
  const double phi = 2 / (std::sqrt(2 * pi) * d * width);
  EXPECT_NEAR(profile.velocity[at], u0, 1e-12);
  EXPECT_NEAR(profile.kinetic_yy[at], mass * vy * vy * phi, 1e-12 * mass * phi);
  EXPECT_NEAR(profile.kinetic_xy[at], mass * vx * vy * phi, 1e-12 * mass * phi);
  EXPECT_NEAR(profile.solid_fraction[at], area * phi, 1e-12 * area * phi);
  EXPECT_NEAR(profile.shear_rate[at], 0, 1e-9);
}

// Velocities on a straight line have its slope; a tenth of the mean over all times is the border.
TEST(ChuteMotion, IsSteadyWhereItHardlyChanges) {
  const auto motion = [](double begin, double rate) {
    std::vector<double> time, velocity;
    for (int k = 0; k <= 10; ++k) {
      time.push_back(2 + 0.1 * k);
      velocity.push_back(begin + rate * 0.1 * k);
    }
    return measure_motion(time, velocity, 0.1);
  };
  EXPECT_NEAR(motion(1, 0.5).acceleration, 0.5, 1e-12);
  EXPECT_NEAR(motion(1, 0.5).velocity, 1.25, 1e-12);
  EXPECT_EQ(motion(1, 0.5).state, ChuteState::accelerating);
  EXPECT_EQ(motion(1, -0.5).state, ChuteState::slowing);
  EXPECT_EQ(motion(1, 0.104).state, ChuteState::steady);
  EXPECT_EQ(motion(1, 0.106).state, ChuteState::accelerating);
  EXPECT_EQ(motion(9e-5, 0).state, ChuteState::at_rest);
  EXPECT_EQ(motion(1.1e-4, 0).state, ChuteState::steady);
  EXPECT_THROW(measure_motion({1, 2}, {1, 1}, 0.1), TooFewParticles);
}

// A run folder of the column at rest through the command.
TEST(InclineCommand, MeasuresARunAndSaysWhatItIs) {
  const auto folder = fresh_folder();
  const Column column(12);
  const std::string parameters =
      "\"particle_diameter_m\": 1e-3, \"aspect_ratio\": 1, \"container_width_m\": 0.01, "
      "\"timestep_s\": 1e-5, \"gravity_m_s2\": 9.81, \"inclination_deg\": ";
  put(folder / "run/parameters.json",
      "{" + parameters + std::to_string(slope.angle * 180 / pi) + "}");
  for (const long step : {100L, 200L, 300L}) {
    const std::string name = "." + std::to_string(step) + ".dump";
    put(folder / "run/dumps" / ("bodies" + name), bodies_text(column.discs, step));
    put(folder / "run/dumps" / ("contacts" + name),
        contacts_text(column.discs, column.touches, step));
  }
  put(folder / "run/result.json", "{\"step\": 300}\n");
  const auto said = test::run_rodpack("incline run --scale-in-dp 0.5", folder);
  EXPECT_EQ(said.exit_code, 0) << said.output;
  EXPECT_THAT(said.output, HasSubstr("17.19 degrees (tan 0.3093), at rest, 1 frames"));
  EXPECT_THAT(said.output, HasSubstr("-sigma_xy / sigma_yy = 0.309"));
  for (const char* file : {"chute.csv", "chute.png", "chute.svg"})
    EXPECT_TRUE(std::filesystem::exists(folder / file)) << file;
  // What measures any planar bed says that this one is tilted, and fits no silo to it.
  const auto profile =
      test::run_rodpack("profile 'run/dumps/bodies.300.dump' --scale-in-dp 0.5", folder);
  EXPECT_EQ(profile.exit_code, 0) << profile.output;
  EXPECT_THAT(profile.output, HasSubstr("gravity is 17.19 degrees off -y: angles are to the base"));
  EXPECT_THAT(profile.output, HasSubstr("Janssen fit: none where gravity is off -y"));
  const auto twice = test::run_rodpack("incline run ./run", folder);
  EXPECT_EQ(twice.exit_code, 1);
  EXPECT_THAT(twice.output, HasSubstr("./run: expected each run once, found that of run again\n"));
  std::filesystem::copy(folder / "run", folder / "copy", std::filesystem::copy_options::recursive);
  const auto several = test::run_rodpack("incline run copy -o all --last 1", folder);
  EXPECT_EQ(several.exit_code, 0) << several.output;
  EXPECT_THAT(several.output, HasSubstr("none of the flows is steady: no figure"));
  EXPECT_THAT(test::text_of(folder / "all.csv"), HasSubstr("\nrun,17.18"));

  // So narrow a scale leaves nothing at the base, and nothing between the discs.
  const auto narrow = test::run_rodpack("incline run --scale-in-dp 0.01 -o narrow", folder);
  EXPECT_EQ(narrow.exit_code, 0) << narrow.output;
  EXPECT_TRUE(std::filesystem::exists(folder / "narrow.svg"));

  // Contacts of particles that are not there.
  put(folder / "copy/dumps/bodies.300.dump",
      bodies_text({column.discs.begin(), column.discs.begin() + 3}, 300));
  const auto foreign = test::run_rodpack("incline copy", folder);
  EXPECT_EQ(foreign.exit_code, 1);
  EXPECT_THAT(foreign.output, HasSubstr("expected contacts and bodies of one run"));
  auto weightless = parameters;
  weightless.replace(weightless.find("9.81"), 4, "0");
  put(folder / "copy/parameters.json", "{" + weightless + "10}");
  const auto light = test::run_rodpack("incline copy", folder);
  EXPECT_EQ(light.exit_code, 1);
  EXPECT_THAT(light.output, HasSubstr("key 'gravity_m_s2': expected a number above 0, found 0\n"));

  put(folder / "run/parameters.json", "{" + parameters + "95}");
  const auto steep = test::run_rodpack("incline run", folder);
  EXPECT_EQ(steep.exit_code, 1);
  EXPECT_THAT(steep.output, HasSubstr("key 'inclination_deg': expected"));
}

}  // namespace
