// SPDX-License-Identifier: GPL-2.0-or-later
// Mixtures: who is of which kind, and what is measured by kind.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "../space/spatial_scene.h"
#include "analysis/contact_forces.h"
#include "analysis/mixture/composition.h"
#include "analysis/mixture/partial_rdf.h"
#include "analysis/rdf.h"
#include "analysis/space/spatial_rdf.h"
#include "liggghts_run.h"
#include "periodic_bed.h"
#include "table.h"

namespace {
using namespace rodpack;
using nlohmann::json;
using rodpack::test::frame_head;
using rodpack::test::fresh_folder;
using rodpack::test::put;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

// A body of the dump: what tells its kind, and where it lies.
struct Body {
  int type = 1, spheres = 9;
  double half_length = 7.5e-3, radius = 1.5e-3, curvature = 0;
  double x = 0.1, y = 0.1, angle = 0;
};

std::string bodies_text(const std::vector<Body>& bodies, const std::string& flags = "ff ff pp") {
  std::ostringstream rows;
  rows.precision(17);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const auto& b = bodies[i];
    rows << i + 1 << ' ' << b.type << ' ' << b.spheres << ' ' << b.x << ' ' << b.y << " 0 "
         << b.angle << " 0 0 0 0 0 0 1 0 0 0 " << b.half_length << ' ' << b.radius << ' '
         << b.curvature << " 4e-5 1e-4\n";
  }
  return frame_head(7, bodies.size(), 0.3, 0.3,
                    "id type nspheres x y z angle vx vy vz omegax omegay omegaz qw qx qy qz "
                    "half_length radius curvature area mass",
                    flags) +
         rows.str();
}

Frame bodies_frame(const std::vector<Body>& bodies) {
  return last_frame({put(fresh_folder() / "bodies.7.dump", bodies_text(bodies))});
}

std::vector<std::string> names_of(const std::vector<Body>& bodies) {
  std::vector<std::string> names;
  for (const auto& each : find_mixture(bodies_frame(bodies)).species) names.push_back(each.name);
  return names;
}

TEST(Species, TypesAreKindsAndSoAreSinglesAndChainsOfOneType) {
  Body rod, other, ball;
  other.type = 2;
  ball.spheres = 1;
  ball.half_length = ball.radius;
  EXPECT_THAT(names_of({rod, rod}), ElementsAre("rods-type1"));
  EXPECT_THAT(names_of({rod, other, ball, rod}),
              ElementsAre("rods-type1", "rods-type2", "spheres-type1"));
  const auto mixture = find_mixture(bodies_frame({other, rod, ball, rod}));
  EXPECT_THAT(mixture.of, ElementsAre(1U, 0U, 2U, 0U));
  EXPECT_THAT(mixture.rows_of(0), ElementsAre(1U, 3U));
  EXPECT_EQ(mixture.species[0].number, 2U);
}

TEST(Species, OneTypeIsDividedWhereShapesLeaveAGapAndNotBySpread) {
  std::vector<Body> spread;
  for (int k = -5; k <= 5; ++k) {  // 5 % of size, as a template draws it
    Body each;
    each.radius *= 1 + 0.01 * k;
    each.half_length *= 1 + 0.01 * k;
    spread.push_back(each);
  }
  EXPECT_THAT(names_of(spread), ElementsAre("rods-type1"));
  Body shorter, arc, wide;
  shorter.half_length = 3e-3;
  EXPECT_THAT(names_of({Body(), shorter}), ElementsAre("rods-type1-AR2", "rods-type1-AR5"));
  arc.curvature = 1;
  EXPECT_THAT(names_of({Body(), arc}), ElementsAre("rods-type1", "curved-type1"));
  auto more = arc;
  more.curvature = 1.2;
  EXPECT_THAT(names_of({arc, more}),
              ElementsAre("curved-type1-theta57.3", "curved-type1-theta68.8"));
  wide.radius = 2e-3;
  wide.half_length = 1e-2;
  EXPECT_THAT(names_of({Body(), wide}), ElementsAre("rods-type1-d0.003", "rods-type1-d0.004"));
}

// Places at random, each third particle of kind 1: all partial G are 1, and weighted they add up to
// the total, which is that of the RDF itself.
template <class AnyPacking, class Sample>
void expect_partials(const AnyPacking& packing, Sample sample, std::size_t number,
                     const RdfOptions& options) {
  Mixture mixture;
  mixture.species.resize(2);
  for (std::size_t i = 0; i < number; ++i) mixture.of.push_back(i % 3 == 0 ? 1 : 0);
  const auto partial = partial_rdf(packing, mixture, options);
  sample.add(packing);
  const auto all = sample.result();
  ASSERT_EQ(partial.pairs.size(), 3U);
  for (std::size_t k = 0; k < all.g.size(); ++k) {
    double sum = 0, expected = 0;
    for (const auto& pair : partial.pairs) {
      sum += pair.g[k] * pair.expected[k] / partial.expected[k];
      expected += pair.expected[k];
      // rho_a scatters too, by some 1/sqrt(N_a).
      EXPECT_NEAR(pair.g[k], 1, 4.5 * pair.standard_error[k] + 0.06) << k;
    }
    EXPECT_NEAR(sum, all.g[k], 1e-12) << k;
    EXPECT_NEAR(partial.total[k], all.g[k], 1e-12) << k;
    EXPECT_NEAR(partial.expected[k], all.expected[k], 1e-9 * all.expected[k]) << k;
    EXPECT_NEAR(expected, all.expected[k], 1e-9 * all.expected[k]) << k;
  }
  // Shares 2/3 and 1/3: 4/9, 4/9 and 1/9 of the pairs, but for the draw of those that are centres.
  const double slack = 8 * std::sqrt(2.0 / 9 / static_cast<double>(all.centres));
  EXPECT_NEAR(partial.pairs[0].expected[5] / partial.expected[5], 4.0 / 9, slack);
  EXPECT_NEAR(partial.pairs[1].expected[5] / partial.expected[5], 4.0 / 9, slack);
  EXPECT_NEAR(partial.pairs[2].expected[5] / partial.expected[5], 1.0 / 9, slack);
}

Packing random_packing(int number, bool sides) {
  Packing packing;
  packing.walls.right = packing.surface = 60;
  packing.walls.sides = sides;
  packing.particle_diameter = 1;
  std::mt19937 random(8);
  std::uniform_real_distribution<double> uniform(0, 60);
  for (int i = 0; i < number; ++i) {
    packing.x.push_back(uniform(random));
    packing.y.push_back(uniform(random));
  }
  return packing;
}

TEST(PartialRdf, OfAnIdealGasAreOneAndAddUpToTheTotal) {
  for (const bool sides : {true, false})
    expect_partials(random_packing(6000, sides), RdfSample({0.5, 10, -1}), 6000, {0.5, 10, -1});
}

TEST(PartialRdf, OfAnIdealGasInSpaceToo) {
  const Vector3 size{0.05, 0.05, 0.05};
  for (const std::string flags : {"pp pp pp", "ff ff ff"}) {
    const auto frame = last_frame(
        {put(fresh_folder() / "b.7.dump",
             rodpack::test::spatial_bodies(rodpack::test::random_places(size, 4000, 3),
                                           rodpack::test::watson_axes(0, 4000, 4), size, flags))});
    expect_partials(read_spatial_packing(frame, {}, {"z", {}, {}}), SpatialRdfSample({1, 10, -1}),
                    4000, {1, 10, -1});
  }
}

// Pairs of an a and a b at distance 1.25 d_p, far from each other on a lattice: all of the pairs in
// that bin are of a and b, twice each, and none of a and a.
TEST(PartialRdf, SeesThatNeighboursAreOfTheOtherKind) {
  Packing packing;
  packing.walls.right = packing.walls.ceiling = packing.surface = 40;
  packing.walls.sides = packing.walls.bottom = false;
  packing.particle_diameter = 1;
  Mixture mixture;
  mixture.species.resize(2);
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j)
      for (const std::size_t kind : {0U, 1U}) {
        packing.x.push_back(4 * i + 1 + (kind ? 1.25 : 0));
        packing.y.push_back(4 * j + 2);
        mixture.of.push_back(kind);
      }
  const auto partial = partial_rdf(packing, mixture, {0.5, 3.5, -1});
  EXPECT_EQ(partial.pairs[1].pairs[2], 200);
  // rho_a = rho_b = 100 / 1600, rings of 200 centres between 1 and 1.5.
  const double ring = std::acos(-1.0) * (1.5 * 1.5 - 1);
  EXPECT_NEAR(partial.pairs[1].g[2], 200 / (200 * ring * 100 / 1600), 1e-12);
  for (const std::size_t same : {0U, 2U})
    for (std::size_t k = 0; k < 7; ++k) EXPECT_EQ(partial.pairs[same].pairs[k], 0);
  // One event that counts twice: sqrt(2 x 200) of 200 expected over their ideal number.
  EXPECT_NEAR(partial.pairs[1].standard_error[2] / partial.pairs[1].g[2], std::sqrt(400) / 200,
              1e-12);
}

// 40 flat rods and 20 upright ones of half their area, each upright one touching two flat ones and
// each flat one one upright one, and all flat ones in 20 pairs.
struct TwoKinds {
  std::vector<Body> bodies;
  std::string contacts;
  TwoKinds() {
    std::ostringstream rows;
    std::size_t count = 0;
    const auto touch = [&](int i, int j) {
      ++count;
      rows << i << ' ' << j << ' ' << count << ' ' << count + 1 << " 0 0.1 0.1 0 1e-3 0 0 "
           << bodies[i - 1].x << ' ' << bodies[i - 1].y << " 0 " << bodies[j - 1].x << ' '
           << bodies[j - 1].y << " 0 1e-6 0 1 0 0\n";
    };
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(0.02, 0.28);
    for (int k = 0; k < 60; ++k) {
      Body body;
      body.type = k < 40 ? 1 : 2;
      body.angle = k < 40 ? 0 : std::acos(0.0);
      body.x = uniform(random);
      body.y = uniform(random);
      bodies.push_back(body);
    }
    for (int k = 1; k <= 40; ++k) touch(k, 41 + (k - 1) / 2);
    for (int k = 1; k <= 40; k += 2) {
      touch(k, k + 1);
      touch(k + 1, k);  // the same pair by two more spheres
    }
    contacts = frame_head(7, count, 0.3, 0.3,
                          "body_i body_j sphere_i sphere_j wall x y z fx fy fz bix biy biz bjx bjy "
                          "bjz overlap_n overlap_t nx ny nz") +
               rows.str();
  }
};

TEST(Composition, SharesOrderAndCoordinationByKind) {
  const TwoKinds scene;
  const auto folder = fresh_folder();
  const auto bodies = bodies_frame(scene.bodies);
  const auto contacts = last_frame({put(folder / "contacts.7.dump", scene.contacts)});
  auto packing = read_packing(bodies);
  packing.surface = 0.3;  // all of them are below it
  for (std::size_t i = 0; i < 60; ++i) packing.area[i] = i < 40 ? 4e-5 : 2e-5;
  const auto mixture = find_mixture(bodies);
  const auto measures = measure_species(packing, mixture);
  ASSERT_EQ(measures.size(), 2U);
  EXPECT_NEAR(measures[0].number_share, 2.0 / 3, 1e-12);
  EXPECT_NEAR(measures[0].solid_share, 0.8, 1e-12);  // 40 x 4 of 200
  EXPECT_NEAR(measures[1].solid_share, 0.2, 1e-12);
  for (const auto& each : measures) EXPECT_NEAR(*each.order, 1, 1e-12);
  EXPECT_NEAR(std::remainder(*measures[0].director, 180), 0, 1e-9);
  EXPECT_NEAR(*measures[1].director, 90, 1e-9);

  const auto touching = coordination_by_species(contacts, bodies, mixture);
  EXPECT_THAT(touching[0], ElementsAre(1, 1));
  EXPECT_THAT(touching[1], ElementsAre(2, 0));
  // Together as ContactForceSample has it: (40 x 2 + 20 x 2) / 60.
  EXPECT_NEAR(measure_contact_forces(contacts, &bodies, {}).coordination.touching_particles, 2,
              1e-12);
}

class AnalyseMixture : public testing::Test {
 protected:
  json analysed(const std::string& arguments) const {
    const auto result = rodpack::test::run_rodpack("analyse mine " + arguments, folder_);
    EXPECT_EQ(result.exit_code, 0) << result.output;
    return json::parse(rodpack::test::text_of(folder_ / "mine/analysis/summary.json"));
  }
  fs::path folder_ = fresh_folder();
};

TEST_F(AnalyseMixture, IsAnalysedByKindAsWellAsTogether) {
  const TwoKinds scene;
  put(folder_ / "mine/bodies.7.dump", bodies_text(scene.bodies));
  auto found = analysed("");
  ASSERT_EQ(found["mixture"].size(), 2U);
  EXPECT_EQ(found["mixture"][0]["species"], "rods-type1");
  EXPECT_EQ(found["mixture"][1]["particles"], 20);
  EXPECT_NEAR(found["mixture"][1]["nematic_order_S2"].get<double>(), 1, 1e-12);
  EXPECT_FALSE(found["mixture"][0].contains("touching"));
  EXPECT_TRUE(found.contains("nematic_order_S2"));  // together
  const auto partial = rodpack::test::read_table(folder_ / "mine/analysis/rdf_partial.csv");
  EXPECT_GT(partial.rows(), 10U);
  partial.column("g_rods-type1_rods-type2");
  EXPECT_TRUE(fs::exists(folder_ / "mine/analysis/rdf_partial.png"));
  const auto page = rodpack::test::text_of(folder_ / "mine/analysis/report.html");
  EXPECT_THAT(page, HasSubstr("By kind of particles"));
  EXPECT_THAT(page, HasSubstr("figure-rdf_partial"));
  EXPECT_THAT(rodpack::test::text_of(folder_ / "mine/analysis/mixture.csv"),
              HasSubstr("rods-type2,2,20,0.003,5,0,"));

  // Nothing of it stays when the next bed is of one kind.
  for (auto body : {"mine/analysis"}) ASSERT_TRUE(fs::exists(folder_ / body / "mixture.csv"));
  auto alike = scene.bodies;
  for (auto& body : alike) body.type = 1;
  put(folder_ / "mine/bodies.7.dump", bodies_text(alike));
  found = analysed("");
  EXPECT_FALSE(found.contains("mixture"));
  EXPECT_FALSE(fs::exists(folder_ / "mine/analysis/mixture.csv"));
  EXPECT_FALSE(fs::exists(folder_ / "mine/analysis/rdf_partial.png"));
}

// What analyse writes of a mixture the subcommands write too: the same tables, through the same
// code.
TEST_F(AnalyseMixture, IsMeasuredByKindByTheSubcommandsToo) {
  const TwoKinds scene;
  put(folder_ / "mine/bodies.7.dump", bodies_text(scene.bodies));
  analysed("");
  const auto run = [&](const std::string& arguments) {
    const auto result = rodpack::test::run_rodpack(arguments, folder_);
    EXPECT_EQ(result.exit_code, 0) << result.output;
    return result.output;
  };
  const auto text = [&](const fs::path& file) { return rodpack::test::text_of(folder_ / file); };
  auto said = run("orientation mine/bodies.7.dump -o gamma");
  EXPECT_THAT(said, HasSubstr("by kind, last frame:\n  rods-type1: 40 particles, "));
  EXPECT_THAT(said, HasSubstr("\n  rods-type2: 20 particles, "));
  EXPECT_THAT(said, HasSubstr(", gamma_mixture.csv\n"));
  EXPECT_EQ(text("gamma_mixture.csv"), text("mine/analysis/mixture.csv"));

  said = run("rdf mine/bodies.7.dump -o g");
  EXPECT_THAT(said, HasSubstr(", g_partial.csv .png .svg\n"));
  EXPECT_EQ(text("g_partial.csv"), text("mine/analysis/rdf_partial.csv"));
  EXPECT_TRUE(fs::exists(folder_ / "g_partial.png"));

  // An upright one of the other type between two flat ones, which it touches.
  std::vector<Body> stack(3);
  stack[1].type = 2;
  stack[1].angle = std::acos(0.0);
  stack[1].y = 0.109;
  stack[2].y = 0.118;
  put(folder_ / "bodies.7.dump", bodies_text(stack));
  put(folder_ / "contacts.7.dump",
      frame_head(7, 2, 0.3, 0.3,
                 "body_i body_j sphere_i sphere_j wall x y z fx fy fz bix biy biz bjx bjy bjz "
                 "overlap_n overlap_t nx ny nz") +
          "1 2 5 10 0 0.1 0.1015 0 0 -1e-3 0 0.1 0.1 0 0.1 0.109 0 1e-6 0 0 -1 0\n"
          "2 3 18 23 0 0.1 0.1165 0 0 -1e-3 0 0.1 0.109 0 0.1 0.118 0 1e-6 0 0 -1 0\n");
  said = run("forces contacts.7.dump --bodies bodies.7.dump -o f");
  EXPECT_THAT(said, HasSubstr("rods-type1: 2 particles, one touches 0 rods-type1, 1 rods-type2\n"));
  EXPECT_THAT(said, HasSubstr("rods-type2: 1 particles, one touches 2 rods-type1, 0 rods-type2\n"));
  EXPECT_THAT(text("f_mixture.csv"), HasSubstr("rods-type2,2,1,0.003,5,0,,,,,,2,0\n"));
  EXPECT_THAT(run("forces contacts.7.dump -o alone"), Not(HasSubstr("by kind")));

  // One kind has no such table.
  auto alike = scene.bodies;
  for (auto& body : alike) body.type = 1;
  put(folder_ / "mine/bodies.7.dump", bodies_text(alike));
  EXPECT_THAT(run("orientation mine/bodies.7.dump -o one"), Not(HasSubstr("by kind")));
  EXPECT_FALSE(fs::exists(folder_ / "one_mixture.csv"));
}

// Their gamma have different ranges, so that only each kind has one.
TEST_F(AnalyseMixture, StraightAndCurvedOnesAreMeasuredByKind) {
  TwoKinds scene;
  for (auto& body : scene.bodies)
    if (body.type == 2) body.curvature = 1;
  put(folder_ / "mine/bodies.7.dump", bodies_text(scene.bodies));
  const auto found = analysed("");
  EXPECT_FALSE(found.contains("nematic_order_S2"));
  EXPECT_THAT(found["notes"].dump(), HasSubstr("orientation: straight and curved particles"));
  EXPECT_EQ(found["mixture"][1]["species"], "curved-type2");
  EXPECT_NEAR(found["mixture"][1]["nematic_order_S2"].get<double>(), 1, 1e-12);
}

TEST_F(AnalyseMixture, InSpaceItHasVolumeSharesAndTheOrderTensorByKind) {
  const Vector3 size{0.05, 0.05, 0.05};
  auto text = rodpack::test::spatial_bodies(rodpack::test::random_places(size, 900, 3),
                                            rodpack::test::watson_axes(4, 900, 4), size);
  // Every second one of another type.
  std::ostringstream rows;
  std::istringstream in(text);
  int row = -9;
  for (std::string line; std::getline(in, line); ++row) {
    const auto blank = line.find(' ');
    if (row >= 0 && row % 2) line.replace(blank, 3, " 2 ");
    rows << line << '\n';
  }
  put(folder_ / "mine/bodies.7.dump", rows.str());
  const auto found = analysed("--vertical z");
  ASSERT_EQ(found["mixture"].size(), 2U);
  const double exact = (3 * rodpack::test::watson_mean_square(4) - 1) / 2;
  for (const auto& kind : found["mixture"]) {
    EXPECT_NEAR(kind["solid_share"].get<double>(), 0.5, 0.06);
    EXPECT_NEAR(kind["nematic_order_S2"].get<double>(), exact,
                4 * kind["nematic_order_S2_standard_error"].get<double>());
  }
}

}  // namespace
