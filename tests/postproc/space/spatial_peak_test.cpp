// SPDX-License-Identifier: GPL-2.0-or-later
// Configurations of the pairs behind a peak of G(r) in space.
#include "analysis/space/pairs/spatial_peak.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "../synthetic_packing.h"
#include "analysis/space/spatial_rdf.h"
#include "liggghts_run.h"
#include "reading/angles.h"
#include "reading/table.h"
#include "spatial_scene.h"

namespace {
using namespace rodpack;
using rodpack::test::fresh_folder;
using rodpack::test::put;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double d = 2e-3;  // of spatial_bodies(), whose rods have AR = 5
const double arm = 5 / std::sqrt(12.0);
const ChainShape rod{5, 1, 0.5, 0, 1};

using Matrix = std::array<Vector3, 3>;  // rows

Vector3 times(const Matrix& m, const Vector3& a) {
  Vector3 result{};
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) result[r] += m[r][c] * a[c];
  return result;
}

Vector3 minus(const Vector3& a) { return {-a[0], -a[1], -a[2]}; }

// A random orthogonal matrix, of a rotation or of one with a mirror: Gram and Schmidt's of Gaussian
// vectors.
Matrix random_isometry(std::mt19937& random) {
  std::normal_distribution<double> normal;
  Matrix m{};
  for (std::size_t r = 0; r < 3; ++r) {
    for (auto& each : m[r]) each = normal(random);
    for (std::size_t k = 0; k < r; ++k) {
      double part = 0;
      for (std::size_t c = 0; c < 3; ++c) part += m[r][c] * m[k][c];
      for (std::size_t c = 0; c < 3; ++c) m[r][c] -= part * m[k][c];
    }
    const double size = std::hypot(m[r][0], m[r][1], m[r][2]);
    for (auto& each : m[r]) each /= size;
  }
  return m;
}

// Pairs of rods far from one another, each turned, mirrored, and told from either particle at
// random; lengths in d_p.
struct Pairs {
  std::mt19937 random{5};
  std::vector<Vector3> places, axes;
  void add(const SpatialConfiguration& pair) {
    const auto n = places.size() / 2, layer = n / 25, row = n / 5 % 5;
    const auto on_lattice = [](std::size_t k) { return 20.0 + 20 * static_cast<double>(k); };
    const Vector3 at{on_lattice(n % 5), on_lattice(row), on_lattice(layer)};
    const auto turn = random_isometry(random);
    auto to = times(turn, pair.place), own = times(turn, Vector3{1, 0, 0}),
         other = times(turn, pair.axis);
    if (random() % 2) {
      to = minus(to);
      std::swap(own, other);
    }
    places.push_back({d * at[0], d * at[1], d * at[2]});
    places.push_back({d * (at[0] + to[0]), d * (at[1] + to[1]), d * (at[2] + to[2])});
    axes.push_back(random() % 2 ? own : minus(own));
    axes.push_back(random() % 2 ? other : minus(other));
  }
  std::string text(int spheres = 9) const {
    return rodpack::test::spatial_bodies(places, axes, {d * 120, d * 120, d * 120}, "ff ff ff",
                                         spheres);
  }
};

SpatialPacking packing_of(const Frame& frame) {
  SpaceOptions space;
  space.vertical = "z";
  auto packing = read_spatial_packing(frame, {}, space);
  packing.surface = d * 120;
  return packing;
}

RdfOptions whole_box() {
  RdfOptions options;
  options.margin = 0;
  return options;
}

RdfPeak bins(std::size_t first, std::size_t last) {
  RdfPeak peak;
  peak.first = first;
  peak.last = last;
  return peak;
}

PeakExplanation explain(const std::string& text, const RdfPeak& peak) {
  const auto frame = last_frame({put(fresh_folder() / "bodies.7.dump", text)});
  SpatialPeakSample sample(whole_box(), peak);
  sample.add(frame, packing_of(frame));
  return sample.result();
}

SpatialConfiguration random_pair(std::mt19937& random) {
  std::normal_distribution<double> normal;
  Vector3 to{}, u{};
  for (auto& each : to) each = normal(random);
  for (auto& each : u) each = normal(random);
  const double size = std::hypot(u[0], u[1], u[2]);
  for (auto& each : u) each /= size;
  return spatial_configuration(to, {1, 0, 0}, u);
}

// By its definition: the root of the mean square over points of the axis, at the best of many
// turns.
TEST(SpatialConfigurations, DistanceIsTheLeastOverAllTurnsAboutTheAxis) {
  std::mt19937 random(1);
  for (int k = 0; k < 20; ++k) {
    const auto a = random_pair(random), b = random_pair(random);
    double least = 1e9;
    constexpr int turns = 20000;
    for (int t = 0; t < turns; ++t) {
      const double c = std::cos(2 * pi * t / turns), s = std::sin(2 * pi * t / turns);
      const auto turned = [&](const Vector3& v) {
        return Vector3{v[0], c * v[1] - s * v[2], s * v[1] + c * v[2]};
      };
      const auto place = turned(b.place), axis = turned(b.axis);
      // The mean over the axis is a quadratic in the way along it, which three points integrate.
      double square = 0;
      for (const auto& [way, weight] :
           {std::pair(-std::sqrt(0.6), 5.0 / 18), std::pair(0.0, 4.0 / 9),
            std::pair(std::sqrt(0.6), 5.0 / 18)})
        for (std::size_t i = 0; i < 3; ++i)
          square += weight * std::pow(place[i] - a.place[i] + 2.5 * way * (axis[i] - a.axis[i]), 2);
      least = std::min(least, std::sqrt(square));
    }
    EXPECT_NEAR(distance_between(a, b, arm), least, 1e-6);
  }
}

TEST(SpatialConfigurations, AreTheSameFromEitherEndTurnedAndMirrored) {
  std::mt19937 random(2);
  for (int k = 0; k < 200; ++k) {
    const auto pair = random_pair(random);
    const auto m = random_isometry(random);
    const auto to = times(m, pair.place), own = times(m, Vector3{1, 0, 0}),
               other = times(m, pair.axis);
    const auto reported = reported_configuration(pair);
    for (const auto& again :
         {spatial_configuration(to, own, other), spatial_configuration(minus(to), other, own),
          spatial_configuration(to, minus(own), other),
          spatial_configuration(to, own, minus(other))}) {
      const auto same = reported_configuration(again);
      EXPECT_NEAR(same.along(), reported.along(), 1e-9);
      EXPECT_NEAR(same.across(), reported.across(), 1e-9);
      for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(same.axis[c], reported.axis[c], 1e-9);
      EXPECT_NEAR(same.turn(), std::acos(std::abs(pair.axis[0])), 1e-9);
    }
    EXPECT_EQ(equal_configurations(pair).size(), 16U);
    EXPECT_LT(distance_between(pair, equal_configurations(pair)[0], arm), 1e-12);
  }
}

TEST(SpatialConfigurations, NamesFollowTheirGeometricRules) {
  const auto name = [](double along, double across, const Vector3& axis) {
    return configuration_name(
        reported_configuration(spatial_configuration({along, across, 0}, {1, 0, 0}, axis)), rod);
  };
  const auto at = [](double degrees) {
    return std::array{std::cos(degrees * degree), std::sin(degrees * degree)};
  };
  EXPECT_EQ(name(0, 1, {1, 0, 0}), "side by side");
  EXPECT_EQ(name(0.5, std::sqrt(0.75), {1, 0, 0}), "side by side shifted by half a sphere");
  EXPECT_EQ(name(5, 0, {1, 0, 0}), "end to end");
  EXPECT_EQ(name(0, 1, {0, 0, 1}), "crossed");
  EXPECT_EQ(name(0, 1.6, {0, 0, 1}), "crossed and apart");
  EXPECT_EQ(name(0, 3, {0, 1, 0}), "T");
  EXPECT_EQ(name(0, 1, {at(40)[0], 0, at(40)[1]}), "side by side twisted by 40°");
  EXPECT_EQ(name(0, 1, {at(8)[0], 0, at(8)[1]}), "side by side");
  EXPECT_EQ(name(0, 1.7, {at(40)[0], 0, at(40)[1]}), "apart twisted by 40°");
  EXPECT_EQ(name(0, 2, {at(40)[0], at(40)[1], 0}), "oblique at 40° flank on");
  EXPECT_EQ(name(0, 2, {at(60)[0], at(60)[1], 0}), "oblique at 60° end on");
}

// Of smooth rods of AR 5: half are crossed at their middles, others side by side or half-way
// between, all 1 apart.
TEST(SpatialPeak, KnownOnesInKnownShares) {
  Pairs pairs;
  const double half = std::sqrt(0.5);
  for (int k = 0; k < 100; ++k)
    pairs.add(k % 10 < 5   ? SpatialConfiguration{{0, 1, 0}, {0, 0, 1}}
              : k % 10 < 8 ? SpatialConfiguration{{0, 1, 0}, {1, 0, 0}}
                           : SpatialConfiguration{{0, 1, 0}, {half, 0, half}});
  const auto found = explain(pairs.text(), bins(9, 10));
  EXPECT_TRUE(found.in_space);
  EXPECT_DOUBLE_EQ(found.pairs, 200);  // from both ends
  ASSERT_EQ(found.configurations.size(), 3U);
  const char* const names[] = {"crossed", "side by side", "side by side twisted by 45°"};
  const double shares[] = {0.5, 0.3, 0.2}, turns[] = {90, 0, 45};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& each = found.configurations[k];
    EXPECT_EQ(each.name, names[k]);
    EXPECT_DOUBLE_EQ(each.share, shares[k]);
    EXPECT_NEAR(each.pair.along, 0, 1e-7);
    EXPECT_NEAR(each.pair.across, 1, 1e-7);
    EXPECT_NEAR(each.pair.angle, turns[k] * degree, 1e-7);
    EXPECT_LT(each.spread, 1e-6);
    EXPECT_DOUBLE_EQ(each.near_share, 1);
    EXPECT_DOUBLE_EQ(each.touching_share, 1);
  }
  EXPECT_DOUBLE_EQ(found.other_share, 0);
}

// What is shifted by 0.04 forwards or backwards is its own mirror image on the whole.
TEST(SpatialPeak, NearlySymmetricOnesAreReportedAsSymmetric) {
  Pairs pairs;
  for (int k = 0; k < 40; ++k) pairs.add({{k % 2 ? 0.04 : -0.04, 1, 0}, {0, 0, 1}});
  const auto found = explain(pairs.text(), bins(9, 10));
  ASSERT_EQ(found.configurations.size(), 1U);
  EXPECT_EQ(found.configurations[0].name, "crossed");
  EXPECT_NEAR(found.configurations[0].pair.along, 0, 1e-9);
  EXPECT_NEAR(found.configurations[0].spread, 0.04, 0.01);
}

// Close packing: neighbours that touch; across two triangles of a layer, or of layers on either
// side; at sqrt(8/3) across the two tetrahedra that share a triangle, as hexagonal packing has
// them.
TEST(SpatialPeak, SpheresOfAHexagonalPacking) {
  std::vector<Vector3> places;
  for (int k = 0; k < 10; ++k)
    for (int j = 0; j < 12; ++j)
      for (int i = 0; i < 12; ++i)
        places.push_back({d * (5 + i + 0.5 * ((j + k) % 2)),
                          d * (5 + std::sqrt(0.75) * (j + (k % 2) / 3.0)),
                          d * (5 + std::sqrt(2.0 / 3) * k)});
  auto text = rodpack::test::spatial_bodies(places, std::vector<Vector3>(places.size(), {1, 0, 0}),
                                            {d * 30, d * 30, d * 30}, "ff ff ff", 1);
  for (auto at = text.find(" 0.005 0.001"); at != std::string::npos;
       at = text.find(" 0.005 0.001", at))
    text.replace(at, 12, " 0.001 0.001");
  EXPECT_EQ(explain(text, bins(9, 10)).configurations.at(0).name, "touching");
  const auto two = explain(text, bins(16, 16));
  EXPECT_EQ(two.configurations.at(0).name, "across two tetrahedra");
  EXPECT_NEAR(two.configurations.at(0).distance, std::sqrt(8.0 / 3), 1e-9);
  EXPECT_EQ(explain(text, bins(17, 17)).configurations.at(0).name, "across two triangles");
  EXPECT_EQ(explain(text, bins(19, 20)).configurations.at(0).name, "in a row of three");
}

// Beyond 2500 pairs only a part is sorted by density, and the others go with their nearest: shares
// stay exact. Frames pool.
TEST(SpatialPeak, ManyPairsOfSeveralFramesKeepExactShares) {
  Pairs pairs;
  for (int k = 0; k < 105; ++k)
    pairs.add(k % 7 < 5 ? SpatialConfiguration{{0, 1, 0}, {0, 0, 1}}
                        : SpatialConfiguration{{0, 1, 0}, {1, 0, 0}});
  const auto frame = last_frame({put(fresh_folder() / "bodies.7.dump", pairs.text())});
  const auto packing = packing_of(frame);
  SpatialPeakSample sample(whole_box(), bins(9, 10));
  for (int k = 0; k < 25; ++k) sample.add(frame, packing);
  const auto found = sample.result();
  EXPECT_DOUBLE_EQ(found.pairs, 25 * 210);
  ASSERT_EQ(found.configurations.size(), 2U);
  EXPECT_DOUBLE_EQ(found.configurations[0].share, 5.0 / 7);
  EXPECT_DOUBLE_EQ(found.configurations[1].share, 2.0 / 7);
}

TEST(SpatialPeak, OtherAndCurvedParticlesAreRefused) {
  Pairs pairs;
  for (int k = 0; k < 10; ++k) pairs.add({{0, 1, 0}, {0, 0, 1}});
  auto text = pairs.text();
  auto curved = text;
  const auto at = curved.rfind(" 0.001 0 2e-5");
  curved.replace(at, 13, " 0.001 1 2e-5");
  EXPECT_THAT([&] { explain(curved, bins(9, 10)); },
              ThrowsMessage<DataError>(HasSubstr(
                  "bodies.7.dump:29: column 'curvature': expected straight particles, found 1")));
  const auto other = text.rfind(" 1 9 ");
  text.replace(other, 5, " 1 5 ");
  EXPECT_THAT([&] { explain(text, bins(9, 10)); },
              ThrowsMessage<DataError>(HasSubstr("bodies.7.dump:29: a particle of 5 spheres")));
}

TEST(SpatialPeak, IsExplainedByTheSubcommand) {
  const auto folder = fresh_folder();
  Pairs pairs;
  for (int k = 0; k < 110; ++k)
    pairs.add(k % 5 ? SpatialConfiguration{{0, 1, 0}, {0, 0, 1}}
                    : SpatialConfiguration{{0, 1, 0}, {1, 0, 0}});
  put(folder / "bodies.7.dump", pairs.text());
  const auto run = [&](const std::string& arguments) {
    return rodpack::test::run_rodpack("rdf bodies.7.dump --vertical z --margin 0 " + arguments,
                                      folder);
  };
  const auto done = run("--explain 1 -o g");
  ASSERT_EQ(done.exit_code, 0) << done.output;
  EXPECT_THAT(done.output, HasSubstr(" %  crossed, spread"));
  const auto table = read_table((folder / "g_explained.csv").string());
  EXPECT_THAT(table.words("configuration"), ElementsAre("crossed", "side by side", "other"));
  EXPECT_NEAR(table.column("angle_deg")[0], 90, 1e-5);
  EXPECT_NEAR(table.column("axis_to_centres_deg")[0], 90, 1e-5);
  EXPECT_NEAR(table.column("share")[0], 0.8, 0.02);  // the bed's surface leaves a few out
  for (const std::string name : {"g_explained.png", "g_explained.svg"})
    EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  const auto nothing = run("--explain 5 -o none");
  EXPECT_EQ(nothing.exit_code, 1);
  EXPECT_THAT(nothing.output, HasSubstr("G(r) has no peak within 0.2 d_p of 5 d_p"));
}

}  // namespace
