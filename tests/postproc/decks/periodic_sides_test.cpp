// SPDX-License-Identifier: GPL-2.0-or-later
// A bed that is moved along a periodic direction, with what crosses the border back in on the other
// side, is the same bed: every measure has to give the same numbers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "../space/spatial_scene.h"
#include "analysis/contact_forces.h"
#include "analysis/fields.h"
#include "analysis/force_chains.h"
#include "analysis/mixture/partial_rdf.h"
#include "analysis/order/bond_order.h"
#include "analysis/orientation.h"
#include "analysis/pressure_profile.h"
#include "analysis/rdf.h"
#include "analysis/solid_fraction.h"
#include "analysis/space/axial_rdf.h"
#include "analysis/space/spatial_orientation.h"
#include "analysis/space/spatial_rdf.h"
#include "analysis/space/vertical_profile.h"
#include "liggghts_run.h"
#include "periodic_bed.h"
#include "rodpack/averaging/averaging_kernel.h"

namespace {
using namespace rodpack;
using rodpack::test::fresh_folder;
using rodpack::test::PeriodicBed;
using rodpack::test::put;
using testing::HasSubstr;

void expect_equal(const std::vector<double>& a, const std::vector<double>& b,
                  const std::string& what) {
  ASSERT_EQ(a.size(), b.size()) << what;
  double largest = 0;
  for (const double each : a) largest = std::max(largest, std::abs(each));
  ASSERT_GT(largest, 0) << what;
  for (std::size_t k = 0; k < a.size(); ++k) ASSERT_NEAR(a[k], b[k], 1e-10 * largest) << what << k;
}

// The bed as it stands, and moved: more than half of it stays inside, the rest crosses.
class PeriodicSides : public testing::Test {
 protected:
  static constexpr double shift = 0.37 * 0.3;
  const PeriodicBed bed_;
  const Frame bodies_ = bed_.bodies(0, fresh_folder()),
              moved_bodies_ = bed_.bodies(shift, fresh_folder()),
              contacts_ = bed_.contacts(0, fresh_folder()),
              moved_contacts_ = bed_.contacts(shift, fresh_folder());
  const Packing packing_ = read_packing(bodies_), moved_ = read_packing(moved_bodies_);
};

TEST_F(PeriodicSides, TheOrientationIsThatOfAllButTheFloor) {
  OrientationSample here, there;
  here.add(packing_);
  there.add(moved_);
  const auto a = here.distribution(), b = there.distribution();
  expect_equal(a.count, b.count, "count");
  EXPECT_EQ(a.nematic.order, b.nematic.order);
  // AR d_p above the floor are left out, and nobody beside the sides.
  const auto low = std::count_if(bed_.y.begin(), bed_.y.end(), [](double y) { return y < 0.015; });
  EXPECT_EQ(a.near_walls, static_cast<std::size_t>(low));
}

TEST_F(PeriodicSides, TheRdfLeavesOutNoMargin) {
  RdfSample here({}), there({});
  here.add(packing_);
  there.add(moved_);
  const auto a = here.result(), b = there.result();
  expect_equal(a.pairs, b.pairs, "pairs");
  expect_equal(a.g, b.g, "g");
  expect_equal(a.standard_error, b.standard_error, "standard error");
  // Centres over the whole width: a third of the height, off the floor and the surface each.
  const double margin = a.margin * packing_.particle_diameter;
  const auto inside = std::count_if(bed_.y.begin(), bed_.y.end(), [&](double y) {
    return y >= margin && y <= packing_.surface - margin;
  });
  EXPECT_EQ(a.centres, static_cast<std::size_t>(inside));
}

TEST_F(PeriodicSides, ThePartialRdfToo) {
  const auto a = partial_rdf(packing_, find_mixture(bodies_), {}),
             b = partial_rdf(moved_, find_mixture(moved_bodies_), {});
  ASSERT_EQ(a.pairs.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) expect_equal(a.pairs[k].g, b.pairs[k].g, "g");
}

TEST_F(PeriodicSides, TheSolidFractionIsThatOfTheWholePeriod) {
  const auto a = solid_fraction(packing_), b = solid_fraction(moved_);
  expect_equal(a.phi, b.phi, "phi");
  EXPECT_NEAR(*a.up_to_surface, *b.up_to_surface, 1e-12);
  EXPECT_NEAR(*a.normalised_from_floor_to_surface, *b.normalised_from_floor_to_surface, 1e-12);
  EXPECT_NEAR(a.covered_below_surface, b.covered_below_surface, 1e-12);
  EXPECT_TRUE(a.side_distance_kept);
  // By the definition: the kernel in the plane, with images, averaged over columns of the period.
  const double width = packing_.walls.width();
  constexpr int columns = 64, images = 4;
  for (const std::size_t k : {30U, 150U, 270U}) {
    double sum = 0;
    for (int c = 0; c < columns; ++c)
      for (std::size_t i = 0; i < packing_.size(); ++i)
        for (int image = -images; image <= images; ++image)
          sum += packing_.area[i] *
                 gaussian((c + 0.5) * width / columns - packing_.x[i] - image * width, a.scale) *
                 gaussian(a.height[k] - packing_.y[i], a.scale);
    EXPECT_NEAR(a.phi[k], sum / columns, 1e-9 * a.phi[k]) << k;
  }
}

TEST_F(PeriodicSides, TheProfileIsThatOfTheWholePeriod) {
  FieldOptions options;
  options.tolerance = 1e-12;  // where the kernel ends leaves a step of this size
  ProfileSample here(options), there(options);
  here.add(packing_, bodies_, contacts_);
  there.add(moved_, moved_bodies_, moved_contacts_);
  const auto a = here.result(), b = there.result();
  expect_equal(a.pressure, b.pressure, "pressure");
  expect_equal(a.xy, b.xy, "shear stress");
  expect_equal(a.solid_fraction, b.solid_fraction, "solid fraction");
}

// The grid does not move with the bed: moved by five places, the field at a place is that of the
// place five before it.
TEST_F(PeriodicSides, TheFieldsCountEveryImage) {
  FieldOptions options;
  options.spacing = 0.01;
  const double by = 0.05;
  const auto moved_bodies = bed_.bodies(by, fresh_folder());
  const auto moved_contacts = bed_.contacts(by, fresh_folder());
  FieldSample here(options), there(options);
  here.add(packing_, bodies_, &contacts_);
  there.add(read_packing(moved_bodies), moved_bodies, &moved_contacts);
  const auto a = here.fields(), b = there.fields();
  const auto columns = static_cast<std::size_t>(here.averages().grid()->count[0]);
  ASSERT_EQ(columns, 31U);  // both ends of the period
  for (std::size_t f = 0; f < a.size(); ++f)
    for (std::size_t c = 0; c < a[f].values.size(); ++c) {
      double largest = 0;
      for (const double each : a[f].values[c]) largest = std::max(largest, std::abs(each));
      for (std::size_t k = 0; k < a[f].values[c].size(); ++k) {
        const auto row = k / columns, column = k % columns;
        const auto before = row * columns + (column + 25) % 30;
        ASSERT_NEAR(b[f].values[c][k], a[f].values[c][before], 1e-9 * largest + 1e-300)
            << a[f].name << ' ' << c << ' ' << k;
      }
    }
}

TEST_F(PeriodicSides, SixfoldOrderForcesAndCoordination) {
  BondOrderSample here, there;
  here.add(bodies_, packing_);
  there.add(moved_bodies_, moved_);
  EXPECT_EQ(here.result().points, there.result().points);
  EXPECT_NEAR(here.result().local, there.result().local, 1e-9);
  EXPECT_NEAR(here.result().global, there.result().global, 1e-9);

  const auto a = measure_contact_forces(contacts_, &bodies_, {}),
             b = measure_contact_forces(moved_contacts_, &moved_bodies_, {});
  EXPECT_NEAR(a.normal.mean, b.normal.mean, 1e-15);
  expect_equal(a.coordination.with_contacts, b.coordination.with_contacts, "contacts");
  EXPECT_EQ(a.coordination.touching_particles, b.coordination.touching_particles);

  const auto lines = force_lines(contacts_), moved = force_lines(moved_contacts_);
  ASSERT_EQ(lines.size(), moved.size());
  for (std::size_t k = 0; k < lines.size(); ++k) {
    ASSERT_NEAR(lines[k].x2 - lines[k].x1, moved[k].x2 - moved[k].x1, 1e-14);
    ASSERT_NEAR(lines[k].force, moved[k].force, 1e-14);
  }
}

// Of 20 d_p in d_p of rounded numbers, 10 d_p are half a period and no more.
TEST(PeriodicWidth, OfTwentyDiametersHasRoomForTenAndOneOfLessHasNot) {
  for (const double diameter : {3e-3, 1.1e-3, 7e-4 / 3}) {
    Packing packing;
    packing.walls.sides = false;
    packing.walls.right = 20 * diameter;
    packing.particle_diameter = diameter;
    packing.surface = 60 * diameter;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int i = 0; i < 300; ++i) {
      packing.x.push_back(packing.walls.right * uniform(random));
      packing.y.push_back(packing.surface * uniform(random));
    }
    // A rounding below it, as a dump's digits may say it.
    packing.walls.right *= 1 - 1e-12;
    EXPECT_NO_THROW(RdfSample({}).add(packing)) << diameter;
    packing.walls.right *= 1 - 1e-6;
    EXPECT_THROW(RdfSample({}).add(packing), DataError) << diameter;
  }
}

// analyse takes what there is room for, in whole bins.
TEST(PeriodicWidth, OfLessShortensTheUsualRdfToHalfOfIt) {
  EXPECT_EQ(up_to({}, 12).largest_distance, 10);
  EXPECT_EQ(up_to({}, 10 * (1 - 1e-12)).largest_distance, 10);
  EXPECT_NEAR(up_to({}, 9.96).largest_distance, 9.9, 1e-12);
  EXPECT_NEAR(up_to({0.3, 10, -1}, 1).largest_distance, 0.9, 1e-12);
}

// Without walls anywhere all particles are centres and every ring is whole.
TEST(PeriodicPlane, AnIdealGasHasNoMarginAndNoStructure) {
  Packing packing;
  packing.walls.sides = packing.walls.bottom = false;
  packing.walls.right = packing.walls.ceiling = packing.surface = 40;
  packing.particle_diameter = 1;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 40);
  for (int i = 0; i < 4000; ++i) {
    packing.x.push_back(uniform(random));
    packing.y.push_back(uniform(random));
  }
  RdfSample sample({0.5, 10, -1});
  sample.add(packing);
  const auto rdf = sample.result();
  EXPECT_EQ(rdf.centres, 4000U);
  EXPECT_EQ(rdf.margin, 0);
  EXPECT_FALSE(rdf.margin_reduced);
  for (std::size_t k = 0; k < rdf.g.size(); ++k) {
    EXPECT_NEAR(rdf.g[k], 1, 4.5 * rdf.standard_error[k]) << k;
    // Whole rings: rho times their area, pi (2k + 1) / 4, for each of the 4000.
    EXPECT_NEAR(rdf.expected[k], 4000 * 2.5 * std::acos(-1.0) * (2.0 * k + 1) * 0.25,
                1e-9 * rdf.expected[k]);
  }
}

TEST(PeriodicPlane, PeriodicHeightHasNeitherFloorNorSurface) {
  const auto folder = fresh_folder();
  const PeriodicBed bed(300, 2);
  auto frame = bed.bodies(0, folder);
  frame.periodic[1] = true;
  frame.bounds[1] = {0, bed.height};
  auto packing = read_packing(frame);
  EXPECT_FALSE(packing.walls.bottom);
  EXPECT_EQ(packing.surface, bed.height);
  OrientationSample sample;
  sample.add(packing);
  EXPECT_EQ(sample.distribution().particles, 300U);
  // The same all over: the mean is the covered area over that of the box.
  double covered = 0;
  for (const double each : packing.area) covered += each;
  const auto phi = solid_fraction(packing);
  EXPECT_NEAR(*phi.up_to_surface, covered / (bed.width * bed.height), 1e-12);
  EXPECT_NEAR(*phi.up_to_3_scales_below, covered / (bed.width * bed.height), 1e-12);
  EXPECT_FALSE(phi.normalised_up_to_surface);

  // Moved along y as well.
  auto moved = packing;
  for (auto& y : moved.y) y = std::fmod(y + 0.1, bed.height);
  RdfSample here({}), there({});
  here.add(packing);
  there.add(moved);
  expect_equal(here.result().g, there.result().g, "g");
  BondOrderSample bonds, moved_bonds;
  bonds.add(frame, packing);
  moved_bonds.add(frame, moved);
  EXPECT_NEAR(bonds.result().local, moved_bonds.result().local, 1e-9);
  EXPECT_EQ(bonds.result().near_edges, 0U);
}

TEST(PeriodicPlane, WallsOfAnotherPeriodAreRefused) {
  const auto folder = fresh_folder();
  const auto frame = PeriodicBed().bodies(0, folder);
  PackingOptions options;
  options.walls = {0, 0.29, 0};
  EXPECT_THAT([&] { read_packing(frame, options); },
              testing::ThrowsMessage<DataError>(
                  HasSubstr("--walls: expected the period of the dump in x, 0.3 m, found 0.29 m")));
}

TEST(PeriodicSpace, AMovedBedIsTheSameBed) {
  const Vector3 size{0.05, 0.06, 0.08};
  auto places = rodpack::test::random_places(size, 2000, 5);
  const auto axes = rodpack::test::watson_axes(2, 2000, 6);
  const auto read = [&](const std::vector<Vector3>& at) {
    return last_frame({put(fresh_folder() / "bodies.7.dump",
                           rodpack::test::spatial_bodies(at, axes, size, "pp pp ff"))});
  };
  const auto bodies = read(places);
  for (auto& place : places) {
    place[0] = std::fmod(place[0] + 0.031, size[0]);
    place[1] = std::fmod(place[1] + 0.017, size[1]);
  }
  const auto moved_bodies = read(places);
  const auto packing = read_spatial_packing(bodies, {}, {"z", {}, {}}),
             moved = read_spatial_packing(moved_bodies, {}, {"z", {}, {}});
  const auto both = [&](auto sample, const auto& compare) {
    auto other = sample;
    sample.add(packing);
    other.add(moved);
    compare(sample.result(), other.result());
  };
  both(SpatialRdfSample({}), [](const Rdf& a, const Rdf& b) { expect_equal(a.g, b.g, "g"); });
  both(AxialRdfSample({0.5, 5}),
       [](const AxialRdf& a, const AxialRdf& b) { expect_equal(a.g, b.g, "axial g"); });
  both(SpatialOrientationSample(), [](const SpatialOrientation& a, const SpatialOrientation& b) {
    EXPECT_NEAR(a.order.value[0], b.order.value[0], 1e-12);
    EXPECT_EQ(a.near_walls, b.near_walls);
  });
  VerticalProfileSample here({}), there({});
  here.add(packing, bodies, nullptr);
  there.add(moved, moved_bodies, nullptr);
  expect_equal(here.result().solid_fraction, there.result().solid_fraction, "phi");
}

}  // namespace
