// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/space/fields/spatial_fields.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/space/vertical_profile.h"
#include "contact_scene.h"
#include "liggghts_run.h"
#include "spatial_scene.h"

namespace {
using namespace rodpack;
using rodpack::test::ContactScene;
using testing::HasSubstr;
const double pi = std::acos(-1.0);

FieldOptions field_options(double scale, double spacing) {
  FieldOptions options;
  options.scale = scale;
  options.spacing = spacing;
  options.tolerance = 1e-13;
  return options;
}

SpatialFieldSample sampled(const ContactScene& scene, const SpatialPacking& packing,
                           const FieldOptions& options, const std::vector<Slice>& slices = {}) {
  SpatialFieldSample sample(options, slices);
  const auto contacts = scene.contact_frame();
  sample.add(packing, scene.body_frame(), &contacts);
  return sample;
}

double gauss(double x, double w) {
  return std::exp(-x * x / (2 * w * w)) / (w * std::sqrt(2 * pi));
}

// Mean of the Gaussian along a branch of length b that lies along the first axis and begins at
// `from`, seen from there: two Gaussians across it, an error function along it.
double along_branch(const Vector3& from, double b, double w) {
  const double root = w * std::sqrt(2.0);
  return gauss(from[1], w) * gauss(from[2], w) *
         (std::erf(from[0] / root) - std::erf((from[0] - b) / root)) / (2 * b);
}

// One pair along x with the force f on the sphere at the lower end, across and along the branch:
// sigma_ax = -f_a b times that integral, all else is 0.
TEST(SpatialFields, TheStressOfAPairIsItsClosedForm) {
  ContactScene scene;
  scene.add_sphere(4, 4, 4, 2, {1, -2, 3});
  scene.add_sphere(5, 4, 4, 2, {1, -2, 3});
  const Vector3 f{-3, 0.5, 0.25};
  scene.add_contact(0, 1, {4, 4, 4}, {5, 4, 4}, f);
  const double w = 0.6;
  const auto sample =
      sampled(scene, scene.packing({8, 9, 10}, 8), field_options(w, 0.5), {{1, 4.3}, {2, 3.6}});
  for (const auto& section : sample.sections()) {
    const auto& stress = field_named(section.fields, "contact_stress").values;
    const auto& density = field_named(section.fields, "mass_density").values[0];
    double largest = 0;
    for (std::size_t i = 0; i < section.place.size(); ++i) {
      const auto& at = section.place[i];
      const Vector3 off{at[0] - 4, at[1] - 4, at[2] - 4};
      const double share = along_branch(off, 1, w);
      for (std::size_t c = 0; c < 9; ++c)
        EXPECT_NEAR(stress[c][i], c % 3 == 0 ? -f[c / 3] * share : 0, 1e-9) << c;
      const double weight = gauss(off[1], w) * gauss(off[2], w);
      EXPECT_NEAR(density[i], 2 * (gauss(off[0], w) + gauss(off[0] - 1, w)) * weight, 1e-9);
      largest = std::max(largest, stress[0][i]);
    }
    EXPECT_GT(largest, 0.1);  // compression is positive
  }
}

// Far from all walls the integrals over the grid, of places that lie w apart twice over, are the
// sums over the particles.
TEST(SpatialFields, IntegrateToVolumeMassAndMomentum) {
  ContactScene scene;
  scene.add_sphere(5, 5, 5, 2, {1, -2, 3});
  scene.add_sphere(5.7, 5.2, 4.4, 3, {0, 1, 0});
  const auto sample = sampled(scene, scene.packing({10, 10, 20}, 10), field_options(0.7, 0.35));
  const auto& grid = *sample.averages().grid();
  const double cell = grid.spacing[0] * grid.spacing[1] * grid.spacing[2];
  const auto integral = [&](const std::string& name, std::size_t component) {
    double sum = 0;
    const auto fields = sample.fields();
    for (const double each : field_named(fields, name).values[component]) sum += each * cell;
    return sum;
  };
  EXPECT_NEAR(integral("number_density", 0), 2, 1e-9);
  EXPECT_NEAR(integral("mass_density", 0), 5, 1e-9);
  EXPECT_NEAR(integral("solid_fraction", 0), 2 * pi / 6, 1e-9);
  for (const auto& [component, momentum] : {std::pair{0U, 2.0}, {1U, -1.0}, {2U, 6.0}})
    EXPECT_NEAR(integral("momentum_density", component), momentum, 1e-9);
}

// What crosses a level is what VerticalProfileSample finds by another way: there the Gaussian is
// integrated over the cross-section beforehand.
TEST(SpatialFields, LevelsIntegrateToTheVerticalProfile) {
  const int n = 12;
  const auto scene = rodpack::test::pile_of_spheres(n, 4, 4);
  const auto packing = scene.packing({8, 8, 20}, n);
  const auto options = field_options(0.5, 0.25);
  const auto sample = sampled(scene, packing, options);
  VerticalProfileSample levels(options);
  const auto contacts = scene.contact_frame();
  levels.add(packing, scene.body_frame(), &contacts);
  const auto profile = levels.result();
  const auto& grid = *sample.averages().grid();
  const auto fields = sample.fields();
  const auto level = [&](const std::string& name, std::size_t component, std::size_t k) {
    const auto& values = field_named(fields, name).values[component];
    const auto places =
        static_cast<std::size_t>(grid.count[0]) * static_cast<std::size_t>(grid.count[1]);
    double sum = 0;
    for (std::size_t i = 0; i < places; ++i) sum += values[k * places + i];
    return sum * grid.spacing[0] * grid.spacing[1] / 64;  // the cross-section
  };
  ASSERT_NEAR(grid.spacing[2], 0.25, 1e-12);
  ASSERT_EQ(profile.depth.size(), 49U);
  for (std::size_t k = 0; k < 49; ++k) {
    const std::size_t depth = 48 - k;
    EXPECT_NEAR(level("contact_stress", 8, k), profile.vertical[depth], 1e-8) << k;
    EXPECT_NEAR(level("contact_stress", 0, k), profile.horizontal[0][depth], 1e-8) << k;
    EXPECT_NEAR(level("solid_fraction", 0, k), profile.solid_fraction[depth], 1e-9) << k;
    EXPECT_NEAR(level("boundary_force_density", 2, k), profile.wall_force[depth], 1e-8) << k;
  }
  EXPECT_GT(profile.vertical[40], 0.1);
}

// d_b sigma_ab = rho g_a + t_a with g_z = -9.81, at every place, up to the walls; derivatives of
// fourth order, which err by h^4 / 30 times the fifth one, some 10 / w^5 of the stress.
TEST(SpatialFields, ForcesBalanceAtEveryPlace) {
  const auto scene = rodpack::test::pile_of_spheres(3, 0.5, 0.5);
  const double h = 0.1;
  const auto sample = sampled(scene, scene.packing({1.6, 1.6, 20}, 3), field_options(0.8, h));
  const auto& grid = *sample.averages().grid();
  const auto fields = sample.fields();
  const auto& stress = field_named(fields, "contact_stress").values;
  const auto& density = field_named(fields, "mass_density").values[0];
  const auto& wall = field_named(fields, "boundary_force_density").values;
  const std::array<long, 3> step{1, grid.count[0],
                                 static_cast<long>(grid.count[0]) * grid.count[1]};
  double largest = 0, worst = 0;
  for (int k = 2; k + 2 < grid.count[2]; ++k)
    for (int j = 2; j + 2 < grid.count[1]; ++j)
      for (int i = 2; i + 2 < grid.count[0]; ++i) {
        const long at = i + step[1] * j + step[2] * k;
        for (std::size_t a = 0; a < 3; ++a) {
          double divergence = 0;
          for (std::size_t b = 0; b < 3; ++b) {
            const auto value = [&](long n) {
              return stress[3 * a + b][static_cast<std::size_t>(at + n * step[b])];
            };
            divergence +=
                (8 * (value(1) - value(-1)) - (value(2) - value(-2))) / (12 * grid.spacing[b]);
          }
          const auto place = static_cast<std::size_t>(at);
          const double weight = a == 2 ? 9.81 * density[place] : 0;
          largest = std::max(largest, weight);
          worst = std::max(worst, std::abs(divergence + weight - wall[a][place]));
        }
      }
  EXPECT_GT(largest, 2);
  EXPECT_LT(worst, 1e-3 * largest);
}

// A scene and what it becomes when its axes are renamed have the same fields on their slices.
TEST(SpatialFields, AnotherVerticalIsTheSameSceneTurned) {
  ContactScene scene, turned;
  const auto places = rodpack::test::random_places({6, 5, 4}, 20, 3);
  const auto around = [](const Vector3& v) { return Vector3{v[1], v[2], v[0]}; };  // z becomes y
  for (const auto& place : places) {
    scene.add_sphere(place[0], place[1], place[2]);
    const auto other = around(place);
    turned.add_sphere(other[0], other[1], other[2]);
  }
  for (int k = 1; k < 20; ++k) {
    const auto& from = places[static_cast<std::size_t>(k)];
    const Vector3 force{0.1 * k, 1, -2};
    // Each pushed by a wall beside it.
    scene.add_contact(k, -1, from, {from[0] - 0.4, from[1], from[2]}, force);
    const auto start = around(from);
    turned.add_contact(k, -1, start, {start[0], start[1], start[2] - 0.4}, around(force));
  }
  auto up_z = scene.packing({6, 5, 8}, 4);
  auto up_y = turned.packing({5, 8, 6}, 4);
  up_y.walls.vertical = 1;
  const auto a = sampled(scene, up_z, field_options(0.7, 0.5)).sections();
  const auto b = sampled(turned, up_y, field_options(0.7, 0.5)).sections();
  ASSERT_EQ(a.size(), 2U);
  const std::array<std::size_t, 3> old{1, 2, 0};  // axis k of the turned scene was axis old[k]
  for (std::size_t s = 0; s < 2; ++s) {
    ASSERT_EQ(a[s].count, b[s].count) << s;
    const auto& first = field_named(a[s].fields, "contact_stress").values;
    const auto& second = field_named(b[s].fields, "contact_stress").values;
    for (std::size_t i = 0; i < a[s].place.size(); ++i) {
      EXPECT_NEAR(a[s].u[i], b[s].u[i], 1e-12);
      EXPECT_NEAR(a[s].v[i], b[s].v[i], 1e-12);
      for (std::size_t c = 0; c < 9; ++c)
        EXPECT_NEAR(second[c][i], first[3 * old[c / 3] + old[c % 3]][i], 1e-9);
    }
  }
  EXPECT_EQ(a[0].name[0], "x");
  EXPECT_EQ(b[0].name[0], "z");
  EXPECT_EQ(b[0].name[1], "y");
}

SpatialPacking in_cylinder(SpatialPacking packing, double radius,
                           const std::array<double, 2>& middle) {
  packing.walls.round = true;
  packing.walls.radius = radius;
  packing.walls.middle = middle;
  return packing;
}

// A pair along x through the axis has sigma_xx alone: on the axis rr = tt = half of it, and on each
// ring rr + tt is the mean of the trace over the azimuth, here by a sum of many places.
TEST(SpatialRings, APairAcrossTheAxisPressesAlikeInAllDirections) {
  ContactScene scene;
  scene.add_sphere(3.5, 4, 2);
  scene.add_sphere(4.5, 4, 2);
  scene.add_contact(0, 1, {3.5, 4, 2}, {4.5, 4, 2}, {-2, 0, 0});
  const double w = 0.6;
  const auto packing = in_cylinder(scene.packing({8, 8, 9}, 4), 3, {4, 4});
  const auto rings = sampled(scene, packing, field_options(w, 0.3)).rings();
  ASSERT_TRUE(rings);
  const auto& stress = field_named(rings->fields, "contact_stress");
  EXPECT_EQ(stress.components[0], "rr");
  for (std::size_t i = 0; i < rings->u.size(); ++i) {
    double mean = 0;
    for (int k = 0; k < 400; ++k) {
      const double azimuth = 2 * pi * k / 400;
      const Vector3 off{rings->u[i] * std::cos(azimuth) + 0.5, rings->u[i] * std::sin(azimuth),
                        rings->v[i] - 2};
      mean += 2 * along_branch(off, 1, w) / 400;
    }
    EXPECT_NEAR(stress.values[0][i] + stress.values[4][i], mean, 1e-7) << rings->u[i];
    if (rings->u[i] == 0) {
      EXPECT_NEAR(stress.values[0][i], mean / 2, 1e-7);
    }
    EXPECT_NEAR(stress.values[8][i], 0, 1e-9);
  }
}

// Turned about the axis of its cylinder, a scene keeps its rings; particles that turn about the
// axis have a velocity around it alone.
TEST(SpatialRings, StayWhenTheSceneIsTurnedAboutTheAxis) {
  const auto places = rodpack::test::random_places({4, 4, 3}, 25, 8);
  const auto at_angle = [&](double angle) {
    ContactScene scene;
    const double c = std::cos(angle), s = std::sin(angle);
    const auto turn = [&](const Vector3& v) {
      return Vector3{c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]};
    };
    for (std::size_t k = 0; k < places.size(); ++k) {
      const auto place = turn({places[k][0] - 2, places[k][1] - 2, places[k][2]});
      scene.add_sphere(place[0], place[1], place[2], 1, {-2 * place[1], 2 * place[0], 0.5});
      const auto branch = turn({0.3, -0.4, 0.1}), force = turn({1, 2, 3.0 * (k % 3)});
      scene.add_contact(static_cast<int>(k), -1, place,
                        {place[0] + branch[0], place[1] + branch[1], place[2] + branch[2]}, force);
    }
    auto packing = in_cylinder(scene.packing({0, 0, 9}, 3), 3, {0, 0});
    packing.walls.low = {-3, -3, 0};
    packing.walls.high = {3, 3, 9};
    return *sampled(scene, packing, field_options(0.8, 0.4)).rings();
  };
  const auto first = at_angle(0), second = at_angle(0.7);
  for (std::size_t f = 0; f < first.fields.size(); ++f)
    for (std::size_t c = 0; c < first.fields[f].values.size(); ++c)
      for (std::size_t i = 0; i < first.u.size(); ++i)
        EXPECT_NEAR(first.fields[f].values[c][i], second.fields[f].values[c][i], 1e-6)
            << first.fields[f].name << ' ' << c;
  const auto& velocity = field_named(first.fields, "velocity").values;
  double fastest = 0;
  for (std::size_t i = 0; i < first.u.size(); ++i) {
    EXPECT_NEAR(velocity[2][i], 0.5, 1e-9);
    fastest = std::max(fastest, velocity[1][i]);
  }
  EXPECT_GT(fastest, 2);
  EXPECT_NEAR(velocity[1][0], 0, 1e-9);  // on the axis
}

// Simple cubic spheres of diameter 1 fill pi / 6; w = 1 sees next to nothing of the layers.
TEST(SpatialFields, TheInteriorOfALatticeHasItsSolidFraction) {
  ContactScene scene;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j)
      for (int k = 0; k < 8; ++k) scene.add_sphere(i + 0.5, j + 0.5, k + 0.5);
  const auto packing = scene.packing({8, 8, 30}, 8);
  auto options = field_options(1, 0.5);
  options.tolerance = 1e-9;
  const auto plain = sampled(scene, packing, options);
  const auto interior = interior_solid_fraction(plain);
  ASSERT_TRUE(interior);
  // Beyond 3 w lie 0.13 % of the kernel for each of six sides, less at most places.
  EXPECT_NEAR(interior->mean, pi / 6, 0.008 * pi / 6);
  EXPECT_EQ(interior->places, 125U);  // 3 to 5 in steps of 1/2
  EXPECT_LT(interior->deviation, 0.01);
  options.normalisation = Normalisation::walls_and_surface;
  const auto divided = sampled(scene, packing, options);
  const auto fields = divided.fields();
  // Up to the corners, to the midpoint rule's share of a layer at three walls.
  for (const double each : field_named(fields, "solid_fraction").values[0])
    EXPECT_NEAR(each / (pi / 6), 1, 0.07);
  EXPECT_FALSE(interior_solid_fraction(sampled(scene, packing, field_options(2, 1))));
}

TEST(SpatialFields, DistancesToEdgesAreThoseOfWallsThatCount) {
  ContactScene scene;
  scene.add_sphere(1, 1, 1);
  auto packing = scene.packing({10, 8, 30}, 9);
  const Vector3 place{2, 5, 7};
  EXPECT_DOUBLE_EQ(distance_to_edges(packing, place, Normalisation::none), 2);
  EXPECT_DOUBLE_EQ(distance_to_edges(packing, place, Normalisation::walls), 2);  // the surface
  EXPECT_EQ(distance_to_edges(packing, place, Normalisation::walls_and_surface), INFINITY);
  packing = in_cylinder(packing, 4, {5, 4});
  EXPECT_DOUBLE_EQ(distance_to_edges(packing, {5, 7, 2.5}, Normalisation::none), 1);
  packing.walls.round = false;
  packing.walls.periodic = {true, true, true};
  EXPECT_EQ(distance_to_edges(packing, place, Normalisation::none), INFINITY);
}

TEST(SpatialFields, WhatCannotBeIsRefused) {
  ContactScene scene;
  scene.add_sphere(1, 1, 1);
  auto packing = scene.packing({2, 2, 5}, 2);
  const auto message = [&](const FieldOptions& options, const std::vector<Slice>& slices) {
    try {
      sampled(scene, packing, options, slices);
    } catch (const DataError& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  EXPECT_THAT(message(field_options(0.5, 5e-3), {}), HasSubstr("grid: expected at most 1000000"));
  EXPECT_THAT(message(field_options(0.5, 0.5), {{0, 2.5}}),
              HasSubstr("slice: expected x of 0 to 2 m, found 2.5"));
  auto lucy = field_options(0.5, 0.5);
  lucy.kernel = "lucy";
  EXPECT_EQ(message(lucy, {}), "none");
  lucy.normalisation = Normalisation::walls;
  EXPECT_THAT(message(lucy, {}), HasSubstr("expected the kernel gaussian in space, found lucy"));
  packing.surface = 0;
  EXPECT_THAT(message(field_options(0.5, 0.5), {}), HasSubstr("no bed above the floor"));
  EXPECT_THROW(SpatialFieldSample({}).averages(), TooFewParticles);
}

}  // namespace
