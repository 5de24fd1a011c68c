// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/edges/undisturbed.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/pressure_profile.h"
#include "analysis/solid_fraction.h"
#include "figures/edges/shading.h"
#include "figures/field_maps.h"
#include "figures/solid_fraction_figure.h"
#include "liggghts_run.h"
#include "reading/text_file.h"
#include "../synthetic_packing.h"

namespace {
using namespace rodpack;
using rodpack::test::fresh_folder;
using rodpack::test::put;
using testing::HasSubstr;
using testing::Not;

// d_p = 1, AR = 2 in a container `width` wide and a bed 50 high, floor at -1: the slice is 4 wide.
Packing bed(double width) {
  Packing packing;
  packing.walls.right = width;
  packing.walls.floor = -1;
  packing.particle_diameter = 1;
  packing.aspect_ratio = 2;
  packing.surface = 49;
  return packing;
}

TEST(Undisturbed, IsFurtherThanTheReachFromEveryWallAndTheSurface) {
  const auto part = undisturbed_part(bed(60), 18);
  const double rounding = 18e-5;
  EXPECT_NEAR(part.left, 18, 1.01 * rounding);
  EXPECT_NEAR(part.right, 42, 1.01 * rounding);
  EXPECT_NEAR(part.bottom, 17, 1.01 * rounding);
  EXPECT_NEAR(part.top, 31, 1.01 * rounding);
}

TEST(Undisturbed, ThereIsNoEdgeWhereThereIsNoWallOrTheShareIsDividedOut) {
  auto periodic = bed(60);
  periodic.walls.sides = false;
  EXPECT_EQ(undisturbed_part(periodic, 18).left, -INFINITY);
  EXPECT_EQ(undisturbed_part(periodic, 18).right, INFINITY);
  const auto walls = undisturbed_part(bed(60), 18, Normalisation::walls);
  EXPECT_EQ(walls.left, -INFINITY);
  EXPECT_EQ(walls.bottom, -INFINITY);
  EXPECT_NEAR(walls.top, 31, 1e-3);
  EXPECT_EQ(undisturbed_part(bed(60), 18, Normalisation::walls_and_surface).top, INFINITY);
}

// The paper's container, 20 l_axial, leaves exactly 3 w = 9 l_axial beside the slice.
TEST(Undisturbed, TheSliceOfThePapersContainerJustIs) {
  EXPECT_TRUE(slice_is_undisturbed(bed(40), 18));
  EXPECT_FALSE(slice_is_undisturbed(bed(39.9), 18));
  const auto heights = undisturbed_heights(bed(40), 18);
  EXPECT_NEAR(heights[0], 17, 1e-3);
  EXPECT_NEAR(heights[1], 31, 1e-3);
  const auto none = undisturbed_heights(bed(39.9), 18);
  EXPECT_LE(none[1], none[0]);
}

TEST(Undisturbed, TheReachIsThreeScalesOrTheKernelsEnd) {
  EXPECT_DOUBLE_EQ(kernel_reach({KernelShape::gaussian, 2, 0.5}), 1.5);
  // A disc of radius R has the standard deviation R / 2 along each axis.
  EXPECT_NEAR(kernel_reach({KernelShape::heaviside, 2, 0.5}), 1.0, 1e-12);
}

TEST(PartsOutside, CoverTheRestOnce) {
  const Rectangle whole{0, 10, 0, 8}, inner{2, 7, 3, 6};
  const auto parts = parts_outside(inner, whole);
  ASSERT_EQ(parts.size(), 4U);
  double area = inner.area();
  for (const auto& part : parts) {
    area += part.area();
    const bool apart = part.right <= inner.left || part.left >= inner.right ||
                       part.top <= inner.bottom || part.bottom >= inner.top;
    EXPECT_TRUE(apart);
  }
  EXPECT_DOUBLE_EQ(area, whole.area());
  EXPECT_TRUE(parts_outside({-INFINITY, INFINITY, -1, 9}, whole).empty());
  const auto all =
      parts_outside({7, 2, 3, 6}, whole);  // walls closer together than twice the reach
  ASSERT_EQ(all.size(), 1U);
  EXPECT_DOUBLE_EQ(all[0].area(), whole.area());
  EXPECT_EQ(parts_outside({2, INFINITY, -INFINITY, INFINITY}, whole).size(), 1U);
}

TEST(Shading, GnuplotGetsTheLimits) {
  EXPECT_THAT(hatch_block("edge", {{0, 10, 0, 3}}), HasSubstr("0 0 0 10 0 3\n"));
  EXPECT_THAT(grey_strip('x', 0, 4.5), HasSubstr("from first 0, graph 0 to first 4.5, graph 1"));
  EXPECT_THAT(grey_strip('y', 7, 9), HasSubstr("from graph 0, first 7 to graph 1, first 9"));
  EXPECT_EQ(grey_strip('x', 5, 5), "");
}

// AR = 2, w = 18 mm, in 0.6 x 0.3 m; the files' lengths have six digits.
TEST(Undisturbed, AProfileKnowsItsDepths) {
  rodpack::test::SyntheticPacking made;
  made.shape.aspect_ratio = 2;
  made.width = 0.6;
  made.fill();
  const auto run = fresh_folder();
  made.write_run(run);
  const auto dump = [&](const std::string& kind) {
    return last_frame({(run / "dumps" / (kind + ".2000.dump")).string()});
  };
  const auto bodies = dump("bodies"), contacts = dump("contacts");
  const auto packing = read_packing(bodies);
  for (const bool normalised : {false, true}) {
    FieldOptions options;
    if (normalised) options.normalisation = Normalisation::walls_and_surface;
    ProfileSample sample(options);
    sample.add(packing, bodies, contacts);
    const auto profile = sample.result();
    EXPECT_NEAR(profile.undisturbed[0], normalised ? 0 : 0.054, 1e-6);
    EXPECT_NEAR(profile.undisturbed[1], profile.depth_of_floor - (normalised ? 0 : 0.054), 1e-6);
  }
}

SolidFraction slice(double height, bool in_a_wide_container) {
  SolidFraction field;
  field.scale = 6;
  field.lowest = 18;
  field.surface = height;
  field.covered_below_surface = 0.8312;
  field.side_distance_kept = in_a_wide_container;
  if (height > 18) field.up_to_surface = 0.6904;
  if (height > 36) field.up_to_3_scales_below = 0.8251;
  for (int k = 0; k <= 30; ++k) {
    field.height.push_back(height * k / 30);
    field.phi.push_back(0.8);
  }
  return field;
}

std::string picture_of(const SolidFraction& field) {
  const auto stem = (fresh_folder() / "phi").string();
  plot_solid_fraction(field, 1, 0, stem);
  return read_text(stem + ".svg");
}

TEST(SolidFractionFigure, AMeanThatTheKernelSpoilsIsNoNumberOfIt) {
  for (const auto& svg : {picture_of(slice(30, true)), picture_of(slice(80, false))}) {
    EXPECT_THAT(svg, HasSubstr("0.831"));
    for (const auto* spoilt : {"0.69", "0.825", "mean"}) EXPECT_THAT(svg, Not(HasSubstr(spoilt)));
  }
  const auto high = picture_of(slice(80, true));
  EXPECT_THAT(high, HasSubstr("0.825"));
  EXPECT_THAT(high, Not(HasSubstr("0.69")));
  EXPECT_THAT(high, HasSubstr("surface"));
}

TEST(FieldMap, NamesSurfaceAndWhatIsDisturbedUnlessTheShareIsDividedOut) {
  rodpack::test::SyntheticPacking made;
  made.fill();
  const auto file = put(fresh_folder() / "bodies.1.dump", made.bodies_frame(1));
  const auto bodies = last_frame({file});
  const auto packing = read_packing(bodies);
  const auto svg_of = [&](FieldOptions options) {
    FieldSample sample(options);
    sample.add(packing, bodies, nullptr);
    const auto stem = (fresh_folder() / "map").string();
    plot_solid_fraction_map(sample.averages(), sample.fields(), mapped_bed(sample, packing), stem);
    return read_text(stem + ".svg");
  };
  const auto plain = svg_of({});
  EXPECT_THAT(plain, HasSubstr("of wall or surface"));
  EXPECT_THAT(plain, HasSubstr(">surface<"));
  FieldOptions shares;
  shares.normalisation = Normalisation::walls;
  EXPECT_THAT(svg_of(shares), HasSubstr("of the surface"));
  shares.normalisation = Normalisation::walls_and_surface;
  EXPECT_THAT(svg_of(shares), Not(HasSubstr("of wall or surface")));
}

}  // namespace
