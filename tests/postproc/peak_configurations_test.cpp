// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/pairs/peak_configurations.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "analysis/pairs/density_clusters.h"
#include "liggghts_run.h"
#include "reading/angles.h"
#include "reading/table.h"
#include "synthetic_packing.h"

namespace {
using namespace rodpack;
using rodpack::test::frame_head;
using rodpack::test::fresh_folder;
using rodpack::test::put;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double d = 3e-3;

/// Alike particles placed by hand; lengths in d_p.
struct Placed {
  int spheres = 5;
  double aspect_ratio = 3, curvature = 0;  // smooth
  double width = 400, height = 400;
  std::vector<std::array<double, 3>> particles;  // x, y, angle

  std::string text(long step = 1) const {
    std::ostringstream rows;
    rows.precision(17);
    for (std::size_t i = 0; i < particles.size(); ++i)
      rows << i + 1 << " 1 " << spheres << ' ' << d * particles[i][0] << ' ' << d * particles[i][1]
           << " 0 " << particles[i][2] << " 0 0 " << d * aspect_ratio / 2 << ' ' << d / 2 << ' '
           << curvature << " 1e-5 1e-4\n";
    return frame_head(step, particles.size(), d * width, d * height,
                      "id type nspheres x y z angle vx vy half_length radius curvature area mass") +
           rows.str();
  }
  Frame frame() const { return last_frame({put(fresh_folder() / "bodies.dump", text())}); }
  Packing packing(const Frame& frame) const {
    PackingOptions options;
    options.particle_diameter = d;
    auto result = read_packing(frame, options);
    result.surface = d * height;
    return result;
  }
  /// A pair far from all others, turned by `turn` as a whole; each row holds 19 of them.
  void add_pair(const PairConfiguration& pair, double turn) {
    const auto n = particles.size() / 2, row = n / 19;
    const double x = 20 + 20 * static_cast<double>(n % 19);
    const double y = 20 + 20 * static_cast<double>(row);
    const double c = std::cos(turn), s = std::sin(turn);
    particles.push_back({{x, y, turn}});
    particles.push_back({{x + c * pair.along - s * pair.across,
                          y + s * pair.along + c * pair.across, turn + pair.angle}});
  }
};

/// The configurations of the pairs between `from` and `to`.
PeakExplanation explain(const Placed& placed, double from, double to) {
  const auto frame = placed.frame();
  const auto packing = placed.packing(frame);
  RdfOptions options;
  options.margin = 0;
  RdfSample rdf(options);
  rdf.add(packing);
  const auto peak = find_rdf_peak(rdf.result(), (from + to) / 2, (to - from) / 2 - 0.05);
  EXPECT_NEAR(peak.from, from, 1e-9);
  EXPECT_NEAR(peak.to, to, 1e-9);
  PeakSample sample(options, peak);
  sample.add(frame, packing);
  return sample.result();
}

Rdf table_of(const std::vector<double>& g, double error) {
  Rdf rdf;
  for (std::size_t k = 0; k < g.size(); ++k) {
    rdf.r.push_back(0.1 * (static_cast<double>(k) + 0.5));
    rdf.standard_error.push_back(error);
    rdf.pairs.push_back(100 * g[k]);
  }
  rdf.g = g;
  return rdf;
}

// A T of AR 3: from the bar the stem's centre is (3 + 1)/2 = 2 across; from the stem the bar's is 2
// along. One pair, told from the bar.
TEST(PairConfiguration, ATIsTheSameSeenFromBarAndStem) {
  const PairConfiguration from_bar{0, 2, pi / 2};
  const auto from_stem = from_neighbour(from_bar);
  EXPECT_NEAR(std::abs(from_stem.along), 2, 1e-15);
  EXPECT_NEAR(from_stem.across, 0, 1e-15);
  for (const auto& view : {from_bar, from_stem}) {
    const auto reported = reported_configuration(view, ParticleKind::straight);
    EXPECT_NEAR(reported.along, 0, 1e-15);
    EXPECT_NEAR(reported.across, 2, 1e-15);
    EXPECT_NEAR(reported.angle, pi / 2, 1e-15);
    EXPECT_EQ(configuration_name(reported, ParticleKind::straight, {3, 1, 0.5, 0, 1}, 0), "T");
  }
}

// Two arcs: the mirror x -> -x and the change of viewpoint lead to one description, but what lies
// on the bulging side is told from what lies on the open one.
TEST(PairConfiguration, CurvedParticlesKeepTheirOpenSide) {
  const auto reported = [](double along, double across, double degrees) {
    return reported_configuration({along, across, degrees * degree}, ParticleKind::curved);
  };
  const auto name = [](const PairConfiguration& pair) {
    return configuration_name(pair, ParticleKind::curved, {5, 1, 0.5, pi / 2, 1}, 0);
  };
  const auto left = reported(-0.7, 1.2, 25), right = reported(0.7, 1.2, -25);
  EXPECT_NEAR(left.along, right.along, 1e-15);
  EXPECT_NEAR(left.angle, right.angle, 1e-15);
  // Arcs over 90 degrees touch near their ends, one step of 1 / cos 45 degrees = 1.41 apart; that
  // is told from the inner one.
  EXPECT_EQ(name(reported(0, -1.41, 0)), "nested arcs");
  EXPECT_NEAR(reported(0, -1.41, 0).across, 1.41, 1e-15);
  EXPECT_EQ(name(reported(0, 2.82, 0)), "nested arcs apart");
  EXPECT_EQ(name(reported(0, -1.3, 150)), "open sides facing turned by 30°");
  EXPECT_EQ(name(reported(0, -1.3, 90)), "turned by 90°");
  EXPECT_EQ(name(reported(0, 1.3, 180)), "back to back");
  EXPECT_EQ(name(reported(0, -1.3, 180)), "open sides facing");
  EXPECT_NEAR(reported(0, -1.3, 180).across, -1.3, 1e-15);
}

TEST(PairConfiguration, NamesFollowTheirGeometricRules) {
  const auto name = [](double along, double across, double degrees, double aspect_ratio) {
    return configuration_name({along, across, degrees * degree}, ParticleKind::straight,
                              {aspect_ratio, 1, 0.5, 0, 1}, 0);
  };
  EXPECT_EQ(name(0.1, 1, 4, 5), "side by side");
  EXPECT_EQ(name(0.5, 0.87, 0, 5), "side by side shifted by half a sphere");
  EXPECT_EQ(name(1.5, 0.87, 0, 5), "side by side shifted by one and a half spheres");
  EXPECT_EQ(name(0.52, 1, 0, 5), "side by side shifted by 0.5 d_p");  // not in the hollows
  EXPECT_EQ(name(1.23, 1, 0, 5), "side by side shifted by 1.2 d_p");
  EXPECT_EQ(name(5, 0.1, 0, 5), "end to end");
  EXPECT_EQ(name(4.9, 0.8, 0, 5), "end to end with a step");
  EXPECT_EQ(name(6, 0, 0, 5), "in line and apart");
  EXPECT_EQ(name(0, 2, 0, 5), "parallel with one between");
  EXPECT_EQ(name(0, 3, 0, 5), "parallel and apart");
  EXPECT_EQ(name(1, 3, 90, 5), "T off the middle");
  EXPECT_EQ(name(2, 3, 90, 5), "L");
  EXPECT_EQ(name(0, 4, 90, 5), "at right angles");
  EXPECT_EQ(name(1, 1.7, 60, 3), "oblique at 60° end on");     // along the line of centres
  EXPECT_EQ(name(1, 1.7, -60, 3), "oblique at 60° flank on");  // 120 degrees from it
}

// Points on a line, neighbours one apart. Densities 20 50 30 10 40 20: the summits 50 and 40 with
// the pass 10 between them, 30 = 4.7 standard errors of 40 lower: two clusters at a depth of 0.5
// (10 < 20), one at 0.25 (10 >= 10). The point of the pass belongs to the denser neighbour.
TEST(DensityClusters, APassPartsSummitsWhenItIsDeepEnough) {
  std::vector<double> density{20, 50, 30, 10, 40, 20};
  const auto beside = [&](std::size_t i, const Visit& visit) {
    if (i > 0) visit(i - 1);
    if (i + 1 < density.size()) visit(i + 1);
  };
  EXPECT_THAT(density_clusters(density, beside, 0.5), ElementsAre(1, 1, 1, 4, 4, 4));
  EXPECT_THAT(density_clusters(density, beside, 0.25), ElementsAre(1, 1, 1, 1, 1, 1));
  // A tenth of the counts: 3 lower, below three standard errors of 4, which are 6.
  for (double& each : density) each /= 10;
  EXPECT_THAT(density_clusters(density, beside, 0.5), ElementsAre(1, 1, 1, 1, 1, 1));
  // Of equal densities the first counts as the denser.
  density.assign(6, 1.0);
  EXPECT_THAT(density_clusters(density, beside, 0.5), ElementsAre(0, 0, 0, 0, 0, 0));
}

// Peak of 4 in bin 3: lowest to the left 0, to the right 1 (before the end): base 1, half at 2.5,
// which bins 3 and 4 exceed. Peak of 2 in bin 7: base max(1, 1.5) = 1.5, half at 1.75: bin 7 alone.
TEST(RdfPeak, BinsAboveHalfTheProminence) {
  const auto rdf = table_of({0, 0, 2, 4, 3, 1, 1.2, 2, 1.5, 1.6, 1.5}, 0.1);
  const auto peaks = rdf_peaks(rdf);
  ASSERT_EQ(peaks.size(), 2U);  // that of 1.6 rises by one standard error
  EXPECT_EQ(peaks[0].first, 3U);
  EXPECT_EQ(peaks[0].last, 4U);
  EXPECT_NEAR(peaks[0].from, 0.3, 1e-12);
  EXPECT_NEAR(peaks[0].to, 0.5, 1e-12);
  EXPECT_NEAR(peaks[0].summit, 0.35, 1e-12);
  EXPECT_EQ(peaks[1].first, 7U);
  EXPECT_EQ(peaks[1].last, 7U);
  EXPECT_EQ(find_rdf_peak(rdf, 0.5).first, 3U);
  EXPECT_EQ(find_rdf_peak(rdf, 0.6).first, 7U);
  const auto given = find_rdf_peak(rdf, 0.75, 0.1);
  EXPECT_EQ(given.first, 6U);
  EXPECT_EQ(given.last, 8U);
}

TEST(RdfPeak, WrongDistancesAreNamed) {
  std::vector<double> g(40, 1.0);
  g[10] = 3;
  g[0] = g[1] = g[2] = 0;
  const auto rdf = table_of(g, 0.1);
  EXPECT_THAT([&] { find_rdf_peak(rdf, 4); },
              ThrowsMessage<DataError>("the distance to explain, 4 d_p, is not within the range of "
                                       "G(r), 0 to 4 d_p"));
  EXPECT_THAT([&] { find_rdf_peak(rdf, 2.5); },
              ThrowsMessage<DataError>(
                  "G(r) has no peak within 0.2 d_p of 2.5 d_p; its peaks are at 1.05 d_p"));
  EXPECT_THAT([&] { find_rdf_peak(rdf, 0.15, 0.1); },
              ThrowsMessage<DataError>(
                  "no pair of particles is 0 to 0.3 d_p apart: there is nothing to explain"));
}

// 36 Ts and 24 pairs side by side, shifted by sqrt(3), of smooth rods of AR 3: all centres are 2
// apart. Each pair is turned, mirrored and seen from either end at random.
TEST(PeakConfigurations, TwoKnownOnesInKnownShares) {
  Placed placed;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(0, 2 * pi);
  for (int k = 0; k < 60; ++k) {
    const bool is_t = k % 5 < 3;
    const auto pair =
        is_t ? PairConfiguration{0, 2, pi / 2} : PairConfiguration{std::sqrt(3), 1, 0};
    const auto all = equal_configurations(pair, ParticleKind::straight);
    placed.add_pair(all[random() % all.size()], angle(random));
  }
  const auto found = explain(placed, 1.9, 2.1);
  ASSERT_EQ(found.configurations.size(), 2U);
  EXPECT_DOUBLE_EQ(found.pairs, 120);  // from both ends
  const auto& t = found.configurations[0];
  EXPECT_EQ(t.name, "T");
  EXPECT_DOUBLE_EQ(t.share, 0.6);
  EXPECT_DOUBLE_EQ(t.share_error, std::sqrt(0.6 * 0.4 / 60));
  EXPECT_NEAR(t.pair.along, 0, 1e-9);
  EXPECT_NEAR(t.pair.across, 2, 1e-9);
  EXPECT_NEAR(t.pair.angle, pi / 2, 1e-9);
  EXPECT_DOUBLE_EQ(t.touching_share, 1);
  const auto& shifted = found.configurations[1];
  EXPECT_EQ(shifted.name, "side by side shifted by 1.7 d_p");
  EXPECT_DOUBLE_EQ(shifted.share, 0.4);
  EXPECT_NEAR(shifted.pair.along, std::sqrt(3), 1e-9);
  EXPECT_NEAR(shifted.pair.across, 1, 1e-9);
  EXPECT_NEAR(shifted.pair.angle, 0, 1e-9);
  EXPECT_LT(shifted.spread, 1e-7);
  EXPECT_DOUBLE_EQ(found.other_share, 0);
}

// Pairs side by side that are shifted by 0.06, forwards or backwards: what is its own mirror image
// on the whole is reported as exactly that, and 0.06 is its spread. 0.2 to either side are two
// mirror images of one thing that is shifted by 0.2.
TEST(PeakConfigurations, NearlySymmetricOnesAreReportedAsSymmetric) {
  for (const double shift : {0.06, 0.2}) {
    Placed placed;
    for (int k = 0; k < 40; ++k) placed.add_pair({k % 2 ? shift : -shift, 1, 0}, 0.1 * k);
    const auto found = explain(placed, 0.9, 1.1);
    ASSERT_EQ(found.configurations.size(), 1U);
    const auto& only = found.configurations[0];
    EXPECT_EQ(only.name, "side by side");
    EXPECT_NEAR(only.pair.along, shift < 0.1 ? 0 : shift, 1e-12);
    EXPECT_NEAR(only.pair.across, 1, 1e-12);
    EXPECT_NEAR(only.pair.angle, 0, 1e-12);
    EXPECT_DOUBLE_EQ(only.share, 1);
    EXPECT_NEAR(only.spread, shift < 0.1 ? shift : 0, 1e-12);
  }
}

// Layers of rods side by side, far apart along their axes.
TEST(PeakConfigurations, ACrystalOfRodsSideBySide) {
  Placed placed;
  for (int i = 0; i < 30; ++i)
    for (int j = 0; j < 30; ++j) placed.particles.push_back({{15.0 + 13 * i, 15.0 + j, pi * j}});
  const auto beside = explain(placed, 0.9, 1.1);
  ASSERT_EQ(beside.configurations.size(), 1U);
  EXPECT_EQ(beside.configurations[0].name, "side by side");
  EXPECT_DOUBLE_EQ(beside.configurations[0].share, 1);
  EXPECT_NEAR(beside.configurations[0].pair.across, 1, 1e-9);
  EXPECT_DOUBLE_EQ(beside.configurations[0].touching_share, 1);
  const auto next = explain(placed, 1.9, 2.1);
  ASSERT_EQ(next.configurations.size(), 1U);
  EXPECT_EQ(next.configurations[0].name, "parallel with one between");
  EXPECT_DOUBLE_EQ(next.configurations[0].touching_share, 0);
  EXPECT_DOUBLE_EQ(next.configurations[0].common_neighbours, 1);
}

// Arcs of AR 5, 60 degrees: half of the pairs nested, half with their open sides facing; the mirror
// image of either is the same configuration.
TEST(PeakConfigurations, CurvedParticles) {
  Placed placed;
  placed.spheres = 9;
  placed.aspect_ratio = 5;
  placed.curvature = pi / 3;
  for (int k = 0; k < 40; ++k)
    placed.add_pair(k % 2 ? PairConfiguration{0.3, 1.4, 0.2} : PairConfiguration{0, -1.43, pi},
                    0.3 * k);
  for (int k = 0; k < 20; ++k) placed.add_pair({-0.3, 1.4, -0.2}, 0.2 * k);  // mirrored
  const auto found = explain(placed, 1.4, 1.5);
  ASSERT_EQ(found.configurations.size(), 2U);
  EXPECT_DOUBLE_EQ(found.configurations[0].share, 2.0 / 3);
  EXPECT_EQ(found.configurations[0].name, "nested arcs shifted by 0.3 d_p turned by 11°");
  EXPECT_DOUBLE_EQ(found.configurations[1].share, 1.0 / 3);
  EXPECT_EQ(found.configurations[1].name, "open sides facing");
  EXPECT_NEAR(found.configurations[1].pair.across, -1.43, 1e-9);
}

// Triangular lattice: neighbours at 1; at sqrt 3 across two triangles, with both spheres between
// them in common; at 2 in a row, with one.
TEST(PeakConfigurations, SpheresOfATriangularLattice) {
  Placed placed;
  placed.spheres = 1;
  placed.aspect_ratio = 1;
  placed.width = placed.height = 40;
  for (int j = 0; j < 40; ++j)
    for (int i = 0; i < 38; ++i)
      placed.particles.push_back({{1 + i + 0.5 * (j % 2), 1 + j * std::sqrt(0.75), 0.1 * i}});
  const struct {
    double from, to;
    const char* name;
  } shells[] = {
      {0.9, 1.1, "touching"}, {1.7, 1.8, "across two triangles"}, {1.9, 2.1, "in a row of three"}};
  for (const auto& [from, to, name] : shells) {
    const auto found = explain(placed, from, to);
    // At the edges of the lattice one of the two spheres between is missing.
    ASSERT_GE(found.configurations.size(), 1U);
    EXPECT_EQ(found.configurations[0].name, name);
    EXPECT_GT(found.configurations[0].share, 0.9);
  }
}

// Beyond 5000 pairs only a part is sorted by density, and the others go with their nearest: shares
// stay exact.
TEST(PeakConfigurations, ManyPairsKeepExactShares) {
  Placed placed;
  placed.width = 800;
  placed.height = 6000;
  for (int k = 0; k < 5600; ++k)
    placed.add_pair(
        k % 7 < 5 ? PairConfiguration{0, 2, pi / 2} : PairConfiguration{std::sqrt(3), 1, 0},
        0.1 * k);
  const auto found = explain(placed, 1.9, 2.1);
  ASSERT_EQ(found.configurations.size(), 2U);
  EXPECT_DOUBLE_EQ(found.configurations[0].share, 5.0 / 7);
  EXPECT_DOUBLE_EQ(found.configurations[1].share, 2.0 / 7);
}

TEST(PeakConfigurations, FramesPoolAndOtherShapesAreRefused) {
  Placed ts, sides;
  for (int k = 0; k < 30; ++k) ts.add_pair({0, 2, pi / 2}, 0.2 * k);
  for (int k = 0; k < 10; ++k) sides.add_pair({std::sqrt(3), 1, 0}, 0.2 * k);
  RdfOptions options;
  options.margin = 0;
  RdfPeak peak;
  peak.first = 19;
  peak.last = 20;
  PeakSample sample(options, peak);
  for (const auto* each : {&ts, &sides}) {
    const auto frame = each->frame();
    sample.add(frame, each->packing(frame));
  }
  EXPECT_DOUBLE_EQ(sample.result().configurations.at(0).share, 0.75);

  Placed longer = ts;
  longer.aspect_ratio = 4;
  longer.spheres = 7;
  const auto frame = longer.frame();
  EXPECT_THAT([&] { sample.add(frame, longer.packing(frame)); },
              ThrowsMessage<DataError>(HasSubstr(
                  "bodies.dump: particles of 7 spheres, AR = 4, arc angle 0 degrees; expected "
                  "those of the first one, 5 spheres, AR = 3")));
}

TEST(RdfCommand, ExplainsAPeak) {
  const auto folder = fresh_folder();
  Placed placed;
  placed.height = 120;
  for (int k = 0; k < 95; ++k)
    placed.add_pair(k % 5 ? PairConfiguration{0, 2, pi / 2} : PairConfiguration{std::sqrt(3), 1, 0},
                    0.2 * k);
  put(folder / "bodies.1.dump", placed.text());
  put(folder / "bodies.2.dump", placed.text(2));
  const auto run = [&](const std::string& arguments) {
    return rodpack::test::run_rodpack("rdf 'bodies.*.dump' --dp 0.003 --margin 0 " + arguments,
                                      folder);
  };
  const auto done = run("--explain 2 --all-frames -o g");
  ASSERT_EQ(done.exit_code, 0) << done.output;
  EXPECT_THAT(done.output, HasSubstr("  80 %  T, spread"));
  const auto table = read_table((folder / "g_explained.csv").string());
  EXPECT_THAT(table.words("configuration"),
              ElementsAre("T", "side by side shifted by 1.7 d_p", "other"));
  EXPECT_DOUBLE_EQ(table.column("share")[0], 0.8);
  EXPECT_DOUBLE_EQ(table.column("pairs")[0], 2 * 2 * 76);  // two frames, from both ends
  for (const std::string name : {"g_explained.png", "g_explained.svg", "g.csv"})
    EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;

  const auto nothing = run("--explain 5 -o none");
  EXPECT_EQ(nothing.exit_code, 1);
  EXPECT_THAT(nothing.output, HasSubstr("rodpack: G(r) has no peak within 0.2 d_p of 5 d_p"));
  EXPECT_FALSE(std::filesystem::exists(folder / "none.csv"));
  EXPECT_EQ(run("--explain 12").exit_code, 1);
  EXPECT_EQ(run("--explain -1").exit_code, 2);
  EXPECT_EQ(run("--explain-width 1").exit_code, 2);
}

}  // namespace
