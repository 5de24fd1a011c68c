// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/space/fabric.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "analysis/contact_forces.h"
#include "liggghts_run.h"
#include "../synthetic_packing.h"

namespace {
using namespace rodpack;
using rodpack::test::fresh_folder;
using rodpack::test::put;

double p2(double t) { return (3 * t * t - 1) / 2; }

// Normals whose density over solid angle is 1 + a P_2 of the cosine to z; forces 1 + b P_2.
struct Contacts {
  std::vector<Vector3> normals;
  std::vector<double> forces;
};
Contacts contacts_with(double a, double b, int number, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  Contacts contacts;
  while (static_cast<int>(contacts.normals.size()) < number) {
    const double t = 2 * uniform(random) - 1;
    if (uniform(random) * (1 + a) > 1 + a * p2(t)) continue;
    const double azimuth = 2 * std::acos(-1.0) * uniform(random), s = std::sqrt(1 - t * t);
    contacts.normals.push_back({s * std::cos(azimuth), s * std::sin(azimuth), t});
    contacts.forces.push_back(2e-3 * (1 + b * p2(t)));
  }
  return contacts;
}

// <P_2> = a / 5, since the square of P_2 has the mean 1/5. The order tensor is uniaxial: a / 5 and
// twice -a / 10. Integrals over a bin by the midpoint rule; the force's error leaves out that of
// the common mean, 1 + a b / 5.
TEST(Fabric, DensityAndForceOfSecondOrderComeBack) {
  const double a = 0.6, b = 0.4;
  const auto contacts = contacts_with(a, b, 40000, 21);
  const auto fabric = measure_fabric(contacts.normals, contacts.forces, 2, 9);
  EXPECT_NEAR(fabric.about_vertical.value, a / 5, 4 * fabric.about_vertical.standard_error);
  EXPECT_LT(fabric.about_vertical.standard_error, 0.003);
  EXPECT_NEAR(fabric.order.value[0], a / 5, 4 * fabric.order.standard_error[0]);
  EXPECT_NEAR(fabric.order.value[2], -a / 10, 5 * fabric.order.standard_error[2]);
  for (int k = 0; k < 9; ++k) {
    double density = 0, force = 0;
    for (int m = 0; m < 1000; ++m) {
      const double t = 1 - (k + (m + 0.5) / 1000) / 9;
      density += (1 + a * p2(t)) / 1000;
      force += (1 + a * p2(t)) * (1 + b * p2(t)) / 1000;
    }
    const auto at = static_cast<std::size_t>(k);
    EXPECT_NEAR(fabric.polar.density[at], density, 4.5 * fabric.polar.standard_error[at]);
    const double of_mean = b * std::sqrt(0.2 / 40000);
    EXPECT_NEAR(fabric.force[at], force / density / (1 + a * b / 5),
                4.5 * (fabric.force_standard_error[at] + of_mean));
  }
}

// Two contacts along z with forces 3 and 1, two across with 2 and 2: order 1/4 about z, mean 2.
TEST(Fabric, FewContactsByHand) {
  const auto fabric =
      measure_fabric({{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}}, {3, 1, 2, 2}, 2, 2);
  EXPECT_NEAR(fabric.about_vertical.value, 0.25, 1e-12);
  EXPECT_NEAR(fabric.order.value[0], 0.25, 1e-12);
  EXPECT_NEAR(fabric.order.value[1], -0.125, 1e-12);
  EXPECT_THAT(fabric.polar.count, testing::ElementsAre(2, 2));
  EXPECT_THAT(fabric.force, testing::ElementsAre(1, 1));
  // Half of the difference of 3/2 and 1/2.
  EXPECT_NEAR(fabric.force_standard_error[0], 0.5, 1e-12);
  EXPECT_EQ(fabric.force_standard_error[1], 0);
  const auto empty_bin = measure_fabric({{0, 0, 1}, {0, 0, 1}}, {1, 1}, 2, 2);
  EXPECT_THAT(empty_bin.force, testing::ElementsAre(1, 0));
  EXPECT_THROW(measure_fabric({{0, 0, 1}}, {1}, 2), TooFewParticles);
}

constexpr const char* contact_columns =
    "body_i body_j sphere_i sphere_j wall x y z fx fy fz bix biy biz bjx bjy bjz overlap_n "
    "overlap_t nx ny nz";

// A contact of the bodies i and j whose force is along its normal; j = 0: with a wall.
std::string contact(int i, int j, const Vector3& n, double force) {
  std::ostringstream row;
  row << i << ' ' << j << ' ' << i << ' ' << j << ' ' << (j == 0) << " 0.1 0.1 0";
  for (const double each : n) row << ' ' << force * each;
  row << " 0.1 0.1 0 0.1 0.101 0 1e-6 0";
  for (const double each : n) row << ' ' << each;
  return row.str() + "\n";
}

TEST(Fabric, OfADumpTakesTheContactsThatAreMeasured) {
  const auto folder = fresh_folder();
  const auto text = rodpack::test::frame_head(1, 5, 0.3, 2, contact_columns) +
                    contact(1, 2, {0, 0, 1}, 3) + contact(2, 3, {0, 0.6, 0.8}, 1) +
                    contact(1, 3, {1, 0, 0}, 0) + contact(3, 4, {0, 1, 0}, 2) +
                    contact(1, 0, {0, 0, 1}, 5);
  const auto frame = last_frame({put(folder / "c.dump", text)});
  for (const bool walls_too : {false, true}) {
    ContactForceSample sample({0.25, walls_too, {}});
    sample.add(frame);
    ASSERT_EQ(sample.normals().size(), walls_too ? 4U : 3U);
    EXPECT_EQ(sample.normals()[1], (Vector3{0, 0.6, 0.8}));
    EXPECT_NEAR(sample.normal_forces()[1], 1, 1e-12);
  }

  const auto run = [&](const std::string& more) {
    return rodpack::test::run_rodpack("forces c.dump " + more, folder);
  };
  const auto without = run("");
  EXPECT_EQ(without.exit_code, 0) << without.output;
  EXPECT_THAT(without.output, testing::HasSubstr("the fabric is left out: no --vertical"));
  EXPECT_FALSE(std::filesystem::exists(folder / "forces_fabric.csv"));
  const auto with = run("--vertical z");
  ASSERT_EQ(with.exit_code, 0) << with.output;
  // Cosines 1, 0.8, 0: the mean of P_2 is (1 + 0.46 - 0.5) / 3.
  EXPECT_THAT(with.output, testing::HasSubstr("about the vertical 0.32 +- "));
  EXPECT_THAT(with.output,
              testing::HasSubstr("forces_fabric.csv .png .svg, forces_fabric_order.csv"));
  for (const std::string name : {"forces_fabric.png", "forces_fabric.svg"})
    EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  const auto table = rodpack::test::read_table(folder / "forces_fabric.csv");
  EXPECT_EQ(table.rows(), 18U);
  EXPECT_NEAR(table.column("normal_force_over_mean")[0], 1.5, 1e-9);
  EXPECT_EQ(rodpack::test::read_table(folder / "forces_fabric_order.csv").rows(), 3U);
  put(folder / "parameters.json", "{\"vertical_axis\": \"up\"}\n");
  const auto wrong = run("");
  EXPECT_EQ(wrong.exit_code, 1);
  EXPECT_THAT(wrong.output, testing::HasSubstr("key 'vertical_axis': expected"));
}

// A planar packing with the vertical in its plane has no fabric in space.
TEST(Fabric, PlanarContactsHaveThePictureOfTheChainsAlone) {
  const auto folder = fresh_folder();
  rodpack::test::SyntheticPacking packing;
  packing.fill();
  packing.write_run(folder);
  const auto run =
      rodpack::test::run_rodpack("forces dumps/contacts.2000.dump --vertical y", folder);
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_TRUE(std::filesystem::exists(folder / "forces_chains.png"));
  EXPECT_FALSE(std::filesystem::exists(folder / "forces_fabric.csv"));
  EXPECT_THAT(run.output, testing::Not(testing::HasSubstr("fabric")));
}

}  // namespace
