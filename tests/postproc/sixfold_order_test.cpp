// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/order/bond_order.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <sstream>

#include "analysis/orientation.h"
#include "liggghts_run.h"
#include "synthetic_packing.h"

namespace {
using namespace rodpack;
using rodpack::test::frame_head;
using rodpack::test::fresh_folder;
using rodpack::test::put;
using testing::HasSubstr;
using testing::ThrowsMessage;

const double pi = std::acos(-1.0);

TEST(SixfoldOrder, OfDirectionsSixtyDegreesApartIsOneAndItsSignSaysWhich) {
  const auto flat = sixfold_order({0, 60, 120, 120});
  EXPECT_NEAR(flat.order, 1, 1e-12);
  EXPECT_NEAR(flat.mean_cosine, 1, 1e-12);
  EXPECT_NEAR(flat.standard_error, 0, 1e-7);
  const auto upright = sixfold_order({30, 90, 150, 270});
  EXPECT_NEAR(upright.order, 1, 1e-12);
  EXPECT_NEAR(upright.mean_cosine, -1, 1e-12);
  EXPECT_NEAR(nematic_order({0, 60, 120}).order, 0, 1e-12);  // which S2 does not see
}

TEST(SixfoldOrder, OfASquareIsNone) {
  EXPECT_NEAR(sixfold_order({0, 90}).order, 0, 1e-12);
  EXPECT_NEAR(sixfold_order({20, 110}).order, 0, 1e-12);
}

// < S6^2 > = 1/n for n random directions. S6^2 is then distributed exponentially, to 1/n, so that
// its mean over 4000 draws is off by 1/n / sqrt(4000) = 1.6 %, one standard deviation. The mean
// cosine scatters by 1 / sqrt(2n), which its own error has to say.
TEST(SixfoldOrder, OfRandomDirectionsIsOneOverRootN) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> gamma(0, 180);
  const int draws = 4000, n = 50;
  double square = 0, error = 0;
  for (int draw = 0; draw < draws; ++draw) {
    std::vector<double> sample;
    for (int k = 0; k < n; ++k) sample.push_back(gamma(random));
    const auto result = sixfold_order(sample);
    square += result.order * result.order / draws;
    error += result.standard_error / draws;
  }
  EXPECT_NEAR(square, 1.0 / n, 0.06 / n);
  EXPECT_NEAR(error, std::sqrt(0.5 / n), 0.02 * std::sqrt(0.5 / n));
}

TEST(SixfoldOrder, OfNoParticleIsAnError) { EXPECT_THROW(sixfold_order({}), TooFewParticles); }

// A lattice of rows (a apart along x, shifted by `shift` from row to row, b between them), turned.
struct Lattice {
  std::vector<double> x, y;
  std::vector<bool> inside;
  Lattice(double a, double b, double shift, double turn) {
    const int n = 15;
    for (int row = 0; row < n; ++row)
      for (int column = 0; column < n; ++column) {
        const double u = a * column + shift * (row % 2), v = b * row;
        x.push_back(u * std::cos(turn) - v * std::sin(turn));
        y.push_back(u * std::sin(turn) + v * std::cos(turn));
        inside.push_back(row > 1 && row < n - 2 && column > 1 && column < n - 2);
      }
  }
  void expect(std::complex<double> value) const {
    const auto orders = sixfold_bond_orders(x, y);
    for (std::size_t i = 0; i < x.size(); ++i)
      if (inside[i]) {
        EXPECT_NEAR(std::abs(orders[i] - value), 0, 1e-9) << x[i] << ' ' << y[i];
      }
    EXPECT_TRUE(std::isnan(orders.front().real()));  // a corner's cell is open
  }
};

TEST(BondOrder, OfATriangularLatticeIsOneAndTurnsSixTimesAsFast) {
  Lattice(1, std::sqrt(0.75), 0.5, 0).expect(1);
  Lattice(3e-3, 3e-3 * std::sqrt(0.75), 1.5e-3, 0.1).expect(std::polar(1.0, 0.6));
  Lattice(1, std::sqrt(0.75), 0.5, pi / 6).expect(-1);
}

// Four equal sides at right angles: 1 - 1 + 1 - 1. The diagonals' sides have no length.
TEST(BondOrder, OfASquareLatticeIsNone) {
  Lattice(1, 1, 0, 0).expect(0);
  Lattice(3e-3, 3e-3, 0, 0.3).expect(0);
}

// The cell of a point is a x b: the neighbours along x share the sides b, those along y, whose
// sixth power is -1, the sides a.
TEST(BondOrder, OfARectangularLatticeGoesWithTheSidesOfItsCells) {
  Lattice(1, 1.5, 0, 0).expect((1.5 - 1) / (1.5 + 1));
}

TEST(BondOrder, FewerThanThreePointsHaveNone) {
  for (const auto& order : sixfold_bond_orders({0, 1}, {0, 0}))
    EXPECT_TRUE(std::isnan(order.real()));
}

// Dimers of unit spheres that fill a triangular lattice between the walls, flat; smooth ones have a
// sphere more between the two.
std::string dimers(int spheres, int columns, int rows, const std::string& sides) {
  std::ostringstream text;
  text.precision(16);
  const double height = std::sqrt(0.75);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      text << spheres << ' ' << 2 * column + 1 + 0.5 * (row % 2) << ' ' << height * row + 0.5
           << " 0 1 0.5 0 1.5\n";
  return frame_head(1, static_cast<std::size_t>(columns * rows), 2 * columns, 2 * rows,
                    "nspheres x y angle half_length radius curvature area", sides) +
         text.str();
}

BondOrder order_of(const std::string& text) {
  const auto frame = last_frame({put(fresh_folder() / "bodies.1.dump", text)});
  BondOrderSample sample;
  PackingOptions options;
  options.particle_diameter = 1;
  options.aspect_ratio = 2;
  sample.add(frame, read_packing(frame, options));
  return sample.result();
}

TEST(BondOrder, DimersInEachOthersGroovesHaveOneCoarseAndSmooth) {
  for (const int spheres : {2, 3}) {
    const auto walls = order_of(dimers(spheres, 8, 12, "ff ff pp"));
    EXPECT_NEAR(walls.local, 1, 1e-9);
    EXPECT_NEAR(walls.local_error, 0, 1e-6);
    EXPECT_NEAR(walls.global, 1, 1e-9);
    EXPECT_EQ(walls.points + walls.near_edges, 2U * 8 * 12);
    // Across a periodic side no column is left out: 2 from either wall, 4 of 16.
    const auto periodic = order_of(dimers(spheres, 8, 12, "pp ff pp"));
    EXPECT_NEAR(periodic.local, 1, 1e-9);
    EXPECT_NEAR(static_cast<double>(periodic.points) / static_cast<double>(walls.points), 16.0 / 12,
                0.06);
  }
}

TEST(BondOrder, WithoutAPointFarFromTheWallsThereIsNone) {
  EXPECT_THAT([] { order_of(dimers(2, 2, 3, "ff ff pp")); },
              ThrowsMessage<TooFewParticles>(HasSubstr("no point further than AR d_p")));
}

TEST(OrientationCommand, TellsSixfoldOrderAndWhyNotThere) {
  const auto folder = fresh_folder();
  put(folder / "bodies.1.dump", dimers(2, 8, 12, "ff ff pp"));
  const auto run = rodpack::test::run_rodpack("orientation bodies.1.dump --ar 2", folder);
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("S6 = 1, <cos 6 gamma> = 1"));
  EXPECT_THAT(run.output, HasSubstr("|psi6| = 1 "));
  put(folder / "bodies.1.dump", dimers(2, 4, 3, "pp ff pp"));
  const auto low = rodpack::test::run_rodpack("orientation bodies.1.dump --ar 1.5", folder);
  EXPECT_THAT(low.output, HasSubstr("no point further than AR d_p from walls and surface"));
}

}  // namespace
