// SPDX-License-Identifier: GPL-2.0-or-later
// Measures that look at x and y alone refuse what is not in a plane.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "liggghts_run.h"
#include "reading/checks/planar.h"
#include "reading/packing.h"
#include "../synthetic_packing.h"

namespace {
using namespace rodpack;
using rodpack::test::frame_head;
using rodpack::test::fresh_folder;
using rodpack::test::put;
using rodpack::test::SyntheticPacking;
using testing::HasSubstr;

constexpr const char* body_columns =
    "id nspheres x y z angle qw qx qy qz half_length radius curvature area mass";

// Error of taking a rod of AR = 5, d_p = 3 mm with that place z and quaternion, among two others in
// the plane z = 0, for a planar packing.
std::string error_of(double z, const std::string& quaternion, double curvature = 0) {
  const std::string flat = " 5 0.1 0.1 0 0 1 0 0 0 0.0075 0.0015 0 4e-5 2e-4\n";
  std::ostringstream rows;
  rows << "1" << flat << "2" << flat << "3 5 0.1 0.1 " << z << " 0 " << quaternion
       << " 0.0075 0.0015 " << curvature << " 4e-5 2e-4\n";
  const auto file =
      put(fresh_folder() / "b.dump", frame_head(1, 3, 0.3, 2, body_columns) + rows.str());
  try {
    read_packing(last_frame({file}));
  } catch (const DataError& error) {
    return std::string(error.what()).substr(file.size());
  }
  return "no error";
}

// A body that is turned by the angle about an axis: quaternion (cos, sin axis) of half the angle.
std::string turned(double degrees, double x, double y, double z) {
  const double half = degrees * std::acos(-1.0) / 360;
  std::ostringstream text;
  text.precision(17);
  text << std::cos(half) << ' ' << std::sin(half) * x << ' ' << std::sin(half) * y << ' '
       << std::sin(half) * z;
  return text.str();
}

TEST(PlanarOnly, RodsInThePlaneAreTakenHoweverTheyAreTurnedInIt) {
  for (const double angle : {0.0, 30.0, 90.0, 200.0})
    EXPECT_EQ(error_of(0, turned(angle, 0, 0, 1)), "no error") << angle;
  // About its own axis a straight rod may be turned, a bent one leaves the plane.
  EXPECT_EQ(error_of(0, turned(90, 1, 0, 0)), "no error");
  EXPECT_THAT(error_of(0, turned(90, 1, 0, 0), 1.5), HasSubstr("expected a planar packing"));
  EXPECT_EQ(error_of(0, turned(180, 1, 0, 0), 1.5), "no error");
  EXPECT_EQ(error_of(2.9e-4, "1 0 0 0"), "no error");
}

// The end of the axis is 6 mm from the centre: tilted by a it rises by 6 sin(a) mm, d_p/10 = 0.3 mm
// at asin(1/20) = 2.87 degrees.
TEST(PlanarOnly, RodsThatStandInSpaceAreRefused) {
  EXPECT_EQ(error_of(0, turned(2.86, 0, 1, 0)), "no error");
  EXPECT_THAT(error_of(0, turned(2.88, 0, 1, 0)), HasSubstr(":12: expected a planar packing"));
  EXPECT_THAT(error_of(0, turned(90, 0, 1, 0)),
              HasSubstr("found a particle that reaches 2 d_p out of the plane z = 0 m"));
  EXPECT_THAT(error_of(3.1e-4, "1 0 0 0"), HasSubstr("reaches 0.103 d_p out of the plane"));
  EXPECT_THAT(error_of(0, "1 1 0 0"), HasSubstr("expected a unit quaternion"));
}

class InSpace : public testing::Test {
 protected:
  // A whole run, all of whose particles, spheres and contacts lie in two layers.
  void SetUp() override {
    SyntheticPacking packing;
    packing.fill();
    packing.write_run(folder_);
    for (const std::string kind : {"bodies", "spheres"})
      for (const std::string step : {"1000", "2000"}) raise_half(kind, step);
  }
  void raise_half(const std::string& kind, const std::string& step) {
    const auto file = folder_ / "dumps" / (kind + "." + step + ".dump");
    std::ifstream in(file);
    std::ostringstream out;
    long number = 0;
    for (std::string line; std::getline(in, line);) {
      std::istringstream words(line);
      if (++number > 9 && number % 2 == 0) {
        line.clear();
        // z is the sixth column of bodies, the sixth of spheres.
        std::string word;
        for (int column = 1; words >> word; ++column)
          line += (column == 6 ? "0.005" : word) + std::string(" ");
      }
      out << line << '\n';
    }
    put(file, out.str());
  }
  rodpack::test::Run run(const std::string& arguments) const {
    return rodpack::test::run_rodpack(arguments, folder_);
  }
  std::filesystem::path folder_ = fresh_folder();
};

TEST_F(InSpace, EveryPlanarSubcommandRefusesABedInTwoLayersWithOneLine) {
  for (const std::string command :
       {"orientation dumps/bodies.2000.dump", "orientation dumps/bodies.1000.dump --all-frames",
        "rdf dumps/bodies.2000.dump", "rdf dumps/bodies.2000.dump --explain 1",
        "solid-fraction dumps/bodies.2000.dump", "stress dumps/bodies.2000.dump",
        "profile dumps/bodies.2000.dump", "render dumps/spheres.2000.dump", "analyse ."}) {
    const auto result = run(command);
    EXPECT_EQ(result.exit_code, 1) << command << result.output;
    EXPECT_THAT(result.output, HasSubstr("expected a planar packing")) << command;
    EXPECT_EQ(std::count(result.output.begin(), result.output.end(), '\n'), 1) << result.output;
  }
}

// Gravity along z presses a layer of particles onto a floor below it: its contacts stand upright.
TEST(PlanarOnly, ContactsWithAFloorBelowThePlaneAreRefusedAndTheirPictureLeftOut) {
  const auto folder = fresh_folder();
  SyntheticPacking packing;
  packing.fill();
  packing.write_run(folder);
  const auto file = folder / "dumps" / "contacts.2000.dump";
  std::ostringstream text;
  text << frame_head(2000, packing.contact_count + 1, packing.width, 2,
                     "body_i body_j sphere_i sphere_j wall x y z fx fy fz bix biy biz bjx bjy bjz "
                     "overlap_n overlap_t nx ny nz")
       << packing.contacts
       << "1 0 1 0 1 0.0075 0.0015 -0.0015 0 0 1e-3 0.0075 0.0015 0 0.0075 0.0015 -0.0015 0 0 0 0 "
          "1\n";
  put(file, text.str());
  const auto command = [&](const std::string& arguments) {
    return rodpack::test::run_rodpack(arguments, folder);
  };
  for (const std::string name : {"stress", "profile"}) {
    const auto run = command(name + " dumps/bodies.2000.dump");
    EXPECT_EQ(run.exit_code, 1) << run.output;
    EXPECT_THAT(run.output, HasSubstr("expected contacts of a planar packing")) << name;
  }
  const auto forces = command("forces dumps/contacts.2000.dump");
  EXPECT_EQ(forces.exit_code, 0) << forces.output;
  EXPECT_THAT(forces.output, HasSubstr("no picture of the chains: "));
  EXPECT_TRUE(std::filesystem::exists(folder / "forces.csv"));
  EXPECT_FALSE(std::filesystem::exists(folder / "forces_chains.png"));
}

}  // namespace
