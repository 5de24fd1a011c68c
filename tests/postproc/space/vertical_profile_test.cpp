// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/space/vertical_profile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/space/body_volumes.h"
#include "contact_scene.h"
#include "liggghts_run.h"
#include "../synthetic_packing.h"

namespace {
using namespace rodpack;
using rodpack::test::frame_of;
using rodpack::test::fresh_folder;
using rodpack::test::put;
using Scene = rodpack::test::ContactScene;
using testing::HasSubstr;
const double pi = std::acos(-1.0);

VerticalProfile profile_of(const Scene& scene, const SpatialPacking& packing,
                           const FieldOptions& options) {
  VerticalProfileSample sample(options);
  const Frame contacts = scene.contact_frame();
  sample.add(packing, scene.body_frame(), &contacts);
  return sample.result();
}

FieldOptions scaled(double scale, double spacing, Normalisation normalisation) {
  FieldOptions options;
  options.scale = scale;
  options.spacing = spacing;
  options.normalisation = normalisation;
  return options;
}

double gauss(double x, double w) {
  return std::exp(-x * x / (2 * w * w)) / (w * std::sqrt(2 * pi));
}

// A chain of n balls a distance s < 2 r apart is n balls less n - 1 lenses of two of them,
// pi (4 r + s) (2 r - s)^2 / 12.
TEST(BodyVolumes, SpheresAndStraightChainsHaveClosedForms) {
  const double r = 1e-3, ball = 4 * pi / 3 * r * r * r;
  const auto volume = [&](double spheres, double half_length) {
    return body_volumes(frame_of({"nspheres", "half_length", "radius", "curvature"},
                                 {{spheres, half_length, r, 0}}))[0];
  };
  EXPECT_NEAR(volume(1, r) / ball, 1, 1e-12);
  const double s = 1e-3;  // nine spheres, 8 s between the end centres
  EXPECT_NEAR(volume(9, 4 * s + r), 9 * ball - 8 * pi * (4 * r + s) * std::pow(2 * r - s, 2) / 12,
              1e-9 * ball);
  EXPECT_NEAR(volume(5, 5 * r) / ball, 5, 1e-9);    // they just touch
  EXPECT_NEAR(volume(3, 10 * r) / ball, 3, 1e-12);  // apart
  EXPECT_THROW(body_volumes(frame_of({"nspheres", "half_length", "radius", "curvature"},
                                     {{5, 5 * r, r, 6.9}})),
               DataError);
}

// A pile of spheres, each carrying those above; of its weight, half goes into the side wall. At
// rest d sigma_zz / dz = - rho g + wall force, exactly, at every height.
TEST(VerticalProfile, StressOfAPileBalancesItsWeightAndTheWalls) {
  const double g = 9.81;
  const int n = 12;
  const Scene scene = rodpack::test::pile_of_spheres(n, 0.5, 0.5);
  const double spacing = 1e-3;
  const auto profile =
      profile_of(scene, scene.packing({2, 3, 20}, n), scaled(0.7, spacing, Normalisation::none));
  EXPECT_EQ(profile.cross_section, 6);
  ASSERT_EQ(profile.depth.size(), 12001U);
  EXPECT_EQ(profile.depth_of_floor, 12);
  for (std::size_t k = 1; k + 1 < profile.depth.size(); k += 100) {
    // The depth grows downwards.
    const double slope = (profile.vertical[k - 1] - profile.vertical[k + 1]) / (2 * spacing);
    EXPECT_NEAR(slope, -profile.density[k] * g + profile.wall_force[k], 1e-4) << profile.depth[k];
  }
  EXPECT_GT(profile.density[6000] * g, 1);  // the checks above mean something
  // Spheres of unit diameter, one per unit of height.
  EXPECT_NEAR(profile.solid_fraction[6000], pi / 6 / 6, 1e-4);
}

// One level pair: the branch b and the force across it give f b g(z) / A, whichever one is i.
TEST(VerticalProfile, ALevelContactPressesSideways) {
  Scene scene;
  scene.add_sphere(1, 1, 2);
  scene.add_sphere(1.9, 1, 2);
  scene.add_contact(0, 1, {1, 1, 2}, {1.9, 1, 2}, {-3, 0, 0});
  scene.add_contact(1, -1, {1.9, 1, 2}, {1.9, 1.5, 2}, {0, -4, 0});
  const auto profile =
      profile_of(scene, scene.packing({4, 5, 9}, 4), scaled(0.5, 0.25, Normalisation::none));
  for (std::size_t k = 0; k < profile.depth.size(); ++k) {
    const double at = gauss(4 - profile.depth[k] - 2, 0.5) / 20;
    EXPECT_NEAR(profile.horizontal[0][k], 3 * 0.9 * at, 1e-12);
    EXPECT_NEAR(profile.horizontal[1][k], 4 * 0.5 * at, 1e-12);
    EXPECT_EQ(profile.vertical[k], 0);
    EXPECT_NEAR(profile.pressure[k], (2.7 + 2) * at / 3, 1e-12);
    EXPECT_NEAR(profile.solid_fraction[k], 2 * pi / 6 * at, 1e-12);
  }
}

// Cross-sections of a box, a cylinder and another vertical.
TEST(VerticalProfile, CrossSectionIsThatOfTheContainer) {
  Scene scene;
  scene.add_sphere(1, 1, 1);
  auto packing = scene.packing({2, 3, 5}, 2);
  const auto area = [&] {
    return profile_of(scene, packing, scaled(0.5, 0.5, Normalisation::none)).cross_section;
  };
  EXPECT_EQ(area(), 6);
  packing.walls.vertical = 1;
  EXPECT_EQ(area(), 10);
  packing.walls.round = true;
  packing.walls.radius = 2;
  EXPECT_NEAR(area(), 4 * pi, 1e-12);
}

// Simple cubic spheres fill pi / 6, in the middle to exp(-2 pi^2 w^2) = 3e-9 at w = d. Divided by
// the share of the kernel in the bed it is that up to floor and surface, to w's share of a layer:
// the midpoint rule over layers is off by g'/24 < 0.011 of 0.5 at most.
TEST(VerticalProfile, LatticeHasItsSolidFractionUpToFloorAndSurface) {
  Scene scene;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      for (int k = 0; k < 16; ++k) scene.add_sphere(i + 0.5, j + 0.5, k + 0.5);
  const auto packing = scene.packing({4, 4, 30}, 16);
  const auto plain = profile_of(scene, packing, scaled(1, 0.5, Normalisation::none));
  const auto walls = profile_of(scene, packing, scaled(1, 0.5, Normalisation::walls));
  const auto both = profile_of(scene, packing, scaled(1, 0.5, Normalisation::walls_and_surface));
  ASSERT_EQ(plain.depth.size(), 33U);
  for (const auto* each : {&plain, &walls, &both})
    EXPECT_NEAR(each->solid_fraction[16], pi / 6, 1e-8);
  EXPECT_NEAR(mean_solid_fraction(plain).value_or(0), pi / 6, 1e-3);  // beyond 3 w: 0.13 %
  EXPECT_FALSE(mean_solid_fraction(profile_of(scene, packing, scaled(3, 1, Normalisation::none))));
  for (const double each : both.solid_fraction) EXPECT_NEAR(each / (pi / 6), 1, 0.022);
  EXPECT_NEAR(plain.solid_fraction.back() / (pi / 6), 0.5, 0.011);  // half of the kernel
  EXPECT_NEAR(walls.solid_fraction.back() / (pi / 6), 1, 0.022);
  EXPECT_NEAR(walls.solid_fraction.front() / (pi / 6), 0.5, 0.011);
}

// A column whose contacts carry what Janssen's law says at their depth: smoothed by w its
// exponential is exp(w^2 / 2 h_c^2) higher, 2e-3 here, which shifts the law's depth by about as
// much.
TEST(VerticalProfile, JanssensLawComesBack) {
  const double p = 50, h_c = 16, area = 4;
  const int n = 60;
  Scene scene;
  for (int k = 0; k < n; ++k) scene.add_sphere(1, 1, k + 0.5);
  for (int k = 0; k < n; ++k) {
    const double depth = n - k;
    const Vector3 below{1, 1, k > 0 ? k - 0.5 : 0};
    scene.add_contact(k, k > 0 ? k - 1 : -1, {1, 1, k + 0.5}, below,
                      {0, 0, area * p * (1 - std::exp(-depth / h_c))});
  }
  const auto profile = profile_of(scene, scene.packing({2, 2, 80}, n),
                                  scaled(1, 0.25, Normalisation::walls_and_surface));
  const auto fit = fit_janssen(profile);
  EXPECT_TRUE(fit.saturates);
  EXPECT_NEAR(fit.pressure, p, 0.01 * p);
  EXPECT_NEAR(fit.depth, h_c, 0.02 * h_c);
  EXPECT_THAT(describe(fit, 1, "Pa"), HasSubstr(" Pa, h_c = "));
}

TEST(VerticalProfile, FramesAreAveraged) {
  Scene scene, other;
  scene.add_sphere(1, 1, 1);
  other.add_sphere(1, 1, 1);
  other.add_sphere(1, 1, 1);
  const auto options = scaled(0.5, 0.5, Normalisation::none);
  VerticalProfileSample sample(options);
  const auto packing = scene.packing({2, 2, 5}, 2);
  sample.add(packing, scene.body_frame(), nullptr);
  sample.add(other.packing({2, 2, 5}, 2), other.body_frame(), nullptr);
  const auto one = profile_of(scene, packing, options);
  EXPECT_NEAR(sample.result().density[1], 1.5 * one.density[1], 1e-12);
}

TEST(VerticalProfile, WhatCannotBeIsRefused) {
  Scene scene;
  scene.add_sphere(1, 1, 1);
  auto packing = scene.packing({2, 2, 5}, 2);
  EXPECT_THROW(VerticalProfileSample(FieldOptions()).result(), TooFewParticles);
  EXPECT_THROW(profile_of(scene, packing, scaled(0.5, 1e-6, Normalisation::none)), DataError);
  packing.surface = 0;
  EXPECT_THROW(profile_of(scene, packing, scaled(0.5, 0.5, Normalisation::none)), TooFewParticles);
  packing.walls.periodic = {false, false, true};
  EXPECT_THROW(profile_of(scene, packing, scaled(0.5, 0.5, Normalisation::none)), DataError);
}

// The files of the column of Janssen's test, in m, as LIGGGHTS would write them.
class ProfileCommand : public testing::Test {
 protected:
  void SetUp() override {
    const double d = 1e-3;
    std::ostringstream bodies, contacts;
    const std::string head = "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ";
    const std::string box = "ITEM: BOX BOUNDS ff ff ff\n0 0.002\n0 0.002\n0 0.1\nITEM: ";
    bodies << head << "ATOMS\n60\n"
           << box
           << "ATOMS id type nspheres x y z angle qw qx qy qz half_length radius curvature area "
              "mass vx vy vz\n";
    contacts
        << head << "ENTRIES\n60\n"
        << box
        << "ENTRIES body_i body_j sphere_i sphere_j wall x y z fx fy fz bix biy biz bjx bjy bjz "
           "overlap_n overlap_t nx ny nz\n";
    for (int k = 0; k < 60; ++k) {
      const double z = (k + 0.5) * d, below = k > 0 ? z - d : 0;
      bodies << k + 1 << " 1 1 0.001 0.001 " << z << " 0 1 0 0 0 0.0005 0.0005 0 8e-7 1e-6 0 0 0\n";
      contacts << k + 1 << ' ' << k << ' ' << k + 1 << ' ' << k << ' ' << (k == 0)
               << " 0.001 0.001 " << k * d << " 0 0 " << 2e-4 * (1 - std::exp((k - 60) / 16.0))
               << " 0.001 0.001 " << z << " 0.001 0.001 " << below << " 1e-6 0 0 0 1\n";
    }
    put(folder_ / "bodies.dump", bodies.str());
    put(folder_ / "contacts.dump", contacts.str());
  }
  rodpack::test::Run run(const std::string& arguments) const {
    return rodpack::test::run_rodpack("profile bodies.dump " + arguments, folder_);
  }
  std::filesystem::path folder_ = fresh_folder();
};

TEST_F(ProfileCommand, WritesTableAndFiguresInSpace) {
  const auto result = run("--vertical z --scale-in-dp 1 --normalise walls-and-surface -o p");
  ASSERT_EQ(result.exit_code, 0) << result.output;
  EXPECT_THAT(result.output, HasSubstr("cross-section 4e-06 m^2"));
  EXPECT_THAT(result.output, HasSubstr("solid fraction, 3 w from floor and surface: 0.1309\n"));
  EXPECT_THAT(result.output, HasSubstr("vertical stress: Janssen: P_j = "));
  for (const std::string name : {"p.png", "p.svg", "p_solid_fraction.png", "p_solid_fraction.svg"})
    EXPECT_TRUE(std::filesystem::exists(folder_ / name)) << name;
  const auto table = rodpack::test::read_table(folder_ / "p.csv");
  EXPECT_NEAR(table.column("h_over_dp").back(), 60, 1.5);
  // One sphere of 1 mm per 2 mm x 2 mm x 1 mm.
  EXPECT_NEAR(table.column("solid_fraction")[table.rows() / 2], pi / 6 / 4, 1e-6);
  EXPECT_EQ(table.column("wall_force_N_m3").size(), table.rows());
}

TEST_F(ProfileCommand, SolidFractionNeedsNoContacts) {
  std::filesystem::remove(folder_ / "contacts.dump");
  const auto result = rodpack::test::run_rodpack(
      "solid-fraction bodies.dump --vertical z --scale-in-dp 1 -o phi", folder_);
  ASSERT_EQ(result.exit_code, 0) << result.output;
  EXPECT_THAT(result.output, HasSubstr("solid fraction, 3 w from floor and surface: 0.1309\n"));
  // 2 mm wide, no place is 3 mm from the walls.
  EXPECT_THAT(result.output, HasSubstr("disturbs it: none, the bed is too small\n"));
  const auto table = rodpack::test::read_table(folder_ / "phi.csv");
  EXPECT_EQ(table.column("height_over_dp")[0], 0);
  EXPECT_NEAR(table.column("solid_fraction")[0], pi / 6 / 4 / 2, 0.011 * pi / 6 / 4);
  // 1 mg per 4 mm^3.
  EXPECT_NEAR(table.column("density_kg_m3")[table.rows() / 2], 250, 1e-5);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "phi.png"));
  for (const std::string name :
       {"phi_grid.vti", "phi_grid.csv", "phi_map.png", "phi_map_across.png"})
    EXPECT_TRUE(std::filesystem::exists(folder_ / name)) << name;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "phi_grid_rings.csv"));
  const auto refused = rodpack::test::run_rodpack(
      "solid-fraction bodies.dump --vertical z --window 0 1 0 1", folder_);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.output, HasSubstr("--window: expected in a scene in a plane alone"));
}

TEST_F(ProfileCommand, RefusesWhatIsOfAPlaneOrMissing) {
  const auto refuses = [&](const std::string& arguments, int exit_code, const std::string& reason) {
    const auto result = run(arguments);
    EXPECT_EQ(result.exit_code, exit_code) << arguments << result.output;
    EXPECT_THAT(result.output, HasSubstr(reason)) << arguments;
  };
  for (const std::string option : {"--kernel lucy", "--line exact", "--tolerance 1e-3"})
    refuses("--vertical z " + option, 2,
            option.substr(0, option.find(' ')) + ": expected in a scene in a plane alone");
  refuses("--vertical z --spacing 1e-9", 1, "spacing: expected at most 100000 places");
  refuses("", 1, "a scene in space needs --vertical");
  std::filesystem::remove(folder_ / "contacts.dump");
  refuses("--vertical z", 1, "contacts.dump");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "profile.csv"));
}

}  // namespace
