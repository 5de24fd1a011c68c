// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "deck.h"
#include "liggghts_run.h"

using namespace rodpack::test;
using testing::HasSubstr;

namespace {

const char* const deck = "verification/stress/in.stress";
constexpr double gravity = 9.81;

/// Fields of one step on the deck's grid, x fastest.
struct GridFields {
  Table table;
  std::size_t nx, ny;
  double h;  // spacing, m

  explicit GridFields(const std::filesystem::path& csv) : table(read_table(csv)) {
    const auto& x = table.column("x_m");
    nx = 1;
    while (nx < x.size() && x[nx] > x[nx - 1]) ++nx;
    ny = x.size() / nx;
    h = x[1] - x[0];
  }
  const std::vector<double>& operator[](const std::string& name) const {
    return table.column(name);
  }
  /// Over the grid, whose edges the kernels do not reach: the trapezoidal rule converges faster
  /// than any power of h there.
  double integral(const std::string& name) const {
    double sum = 0;
    for (const double value : (*this)[name]) sum += value * h * h;
    return sum;
  }
  /// Derivative along x (0) or y (1), eighth order.
  double derivative(const std::string& name, std::size_t axis, std::size_t at) const {
    constexpr double weight[] = {4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280};
    const std::size_t step = axis == 0 ? 1 : nx;
    const auto& values = (*this)[name];
    double sum = 0;
    for (std::size_t k = 1; k <= 4; ++k)
      sum += weight[k - 1] * (values[at + k * step] - values[at - k * step]);
    return sum / h;
  }
  template <class Residual>
  double largest(Residual residual) const {
    double worst = 0;
    for (std::size_t j = 4; j + 4 < ny; ++j)
      for (std::size_t i = 4; i + 4 < nx; ++i)
        worst = std::max(worst, std::fabs(residual(j * nx + i)));
    return worst;
  }
  /// Largest |div sigma - rho g - t|, walls and all, over the largest rho g.
  double momentum_residual() const {
    const double scale =
        largest([&](std::size_t k) { return gravity * (*this)["mass_density_kg_m2"][k]; });
    double worst = 0;
    for (const std::string a : {"x", "y"}) {
      const double weight = a == "y" ? -gravity : 0;
      worst = std::max(worst, largest([&](std::size_t k) {
                         return derivative("contact_stress_" + a + "x_N_m", 0, k) +
                                derivative("contact_stress_" + a + "y_N_m", 1, k) -
                                weight * (*this)["mass_density_kg_m2"][k] -
                                (*this)["boundary_force_density_" + a + "_N_m2"][k];
                       }));
    }
    return worst / scale;
  }
  /// Largest |d mu_zb / d r_b - (sigma_xy - sigma_yx)| over the largest stress.
  double spin_residual() const {
    const double worst = largest([&](std::size_t k) {
      return derivative("couple_stress_zx_N", 0, k) + derivative("couple_stress_zy_N", 1, k) -
             ((*this)["contact_stress_xy_N_m"][k] - (*this)["contact_stress_yx_N_m"][k]);
    });
    return worst / largest([&](std::size_t k) { return (*this)["contact_stress_yy_N_m"][k]; });
  }
};

double sum(const std::vector<double>& values) {
  double total = 0;
  for (const double value : values) total += value;
  return total;
}

void expect_same(const Table& a, const Table& b, double tolerance) {
  ASSERT_EQ(a.rows(), b.rows());
  ASSERT_EQ(a.names(), b.names());
  for (const auto& name : a.names()) {
    const auto& x = a.column(name);
    const auto& y = b.column(name);
    double scale = 0, worst = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      scale = std::max(scale, std::fabs(x[i]));
      worst = std::max(worst, std::fabs(x[i] - y[i]));
    }
    EXPECT_LE(worst, tolerance * scale) << name;
  }
}

/// Two spheres of 3 mm whose centres are 2.9 mm apart, at rest, k_n = 1000 N/m: 0.1 N.
std::string two_spheres(const std::string& lines) {
  return Deck()
      .box("0 0.02 0 0.02 -0.01 0.01")
      .with(
          "fix integrate all nve/sphere/ab order 3\n"
          "create_atoms 1 single 0.009 0.01 0 units box\n"
          "create_atoms 1 single 0.0119 0.01 0 units box\n"
          "set group all diameter 0.003 density 2500\n" +
          lines);
}

/// Sums of the forces of walls on bodies, N: along x of those that push to the right and to the
/// left, and along y.
struct WallForces {
  double left = 0, right = 0, floor = 0;

  explicit WallForces(const std::filesystem::path& contact_dump) {
    const Table contacts = read_dump(contact_dump);
    for (std::size_t c = 0; c < contacts.rows(); ++c) {
      if (contacts.column("wall")[c] == 0) continue;
      const double fx = contacts.column("fx")[c];
      (fx > 0 ? left : right) += fx;
      floor += contacts.column("fy")[c];
    }
  }
};

}  // namespace

// One bed of 40 rods that comes to rest between walls; E_k falls by orders of magnitude from frame
// to frame. What is left of the balances is -sum m a phi, as small as the accelerations are, and in
// the end the error of the eighth-order differences, about 105 (h/w)^8 / 630 = 3e-6 for one kernel.
TEST(StressGoldhirsch, BalancesHoldUpToTheWallsTheBetterTheMoreTheBedIsAtRest) {
  const auto run = run_liggghts(deck);
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto at = [&](const std::string& step) {
    return GridFields(run.folder / ("fields." + step + ".csv"));
  };
  const GridFields falling = at("30000"), landed = at("50000"), rest = at("80000");
  EXPECT_GT(falling.momentum_residual(), 0.1);  // they fall: rho g is not balanced
  EXPECT_LT(landed.momentum_residual(), falling.momentum_residual());  // some may still roll
  EXPECT_LT(rest.momentum_residual(), 0.01 * landed.momentum_residual());
  EXPECT_LT(rest.momentum_residual(), 1e-4);
  EXPECT_LT(rest.spin_residual(), 1e-4);

  // Over all space: the masses and areas of the particles, and the walls' forces, which carry the
  // weight. What beyond the edge of the grid is left out is below 1e-8.
  const Table bodies = read_dump(run.folder / "bodies.80000.dump");
  const double mass = sum(bodies.column("mass"));
  EXPECT_NEAR(rest.integral("number_density_1_m2"), 40, 40e-8);
  EXPECT_NEAR(rest.integral("mass_density_kg_m2"), mass, 1e-8 * mass);
  EXPECT_NEAR(rest.integral("solid_fraction"), sum(bodies.column("area")),
              1e-8 * sum(bodies.column("area")));
  EXPECT_NEAR(rest.integral("boundary_force_density_y_N_m2"), mass * gravity,
              1e-6 * mass * gravity);
  EXPECT_NEAR(rest.integral("boundary_force_density_x_N_m2"), 0, 1e-6 * mass * gravity);

  // The integral of the stress is -sum f (x) r over the contacts of the dump.
  const Table contacts = read_dump(run.folder / "contacts.80000.dump");
  for (const std::string a : {"x", "y"})
    for (const std::string b : {"x", "y"}) {
      double moment = 0;
      for (std::size_t c = 0; c < contacts.rows(); ++c)
        moment -= contacts.column("f" + a)[c] *
                  (contacts.column("bj" + b)[c] - contacts.column("bi" + b)[c]);
      EXPECT_NEAR(rest.integral("contact_stress_" + a + b + "_N_m"), moment, 1e-9);
    }

  // thermo, variables and fix ave/time read the same numbers as the dump.
  const Table points = read_table(run.folder / "points.80000.csv");
  char pressure[32];
  std::snprintf(pressure, sizeof pressure, "%.8g",
                0.5 * (points.column("contact_stress_xx_N_m")[0] +
                       points.column("contact_stress_yy_N_m")[0]));
  EXPECT_THAT(run.output, HasSubstr(pressure));
  EXPECT_GT(points.column("contact_stress_yy_N_m")[0], 0.1);
  std::snprintf(pressure, sizeof pressure, "\n1 %.6g", points.column("contact_stress_xx_N_m")[0]);
  EXPECT_THAT(text_of(run.folder / "average.txt"), HasSubstr(pressure));
  EXPECT_THAT(text_of(run.folder / "fields.80000.vti"), HasSubstr("contact_stress_N_m"));
}

TEST(StressGoldhirsch, RodsThatFallHaveTheKineticStressOfTheirDeviations) {
  const auto run = run_liggghts(deck, {{"steps", "20000"}, {"every", "20000"}});
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const Table bodies = read_dump(run.folder / "bodies.20000.dump");
  const Table points = read_table(run.folder / "points.20000.csv");
  const double w = 0.006;
  for (std::size_t p = 0; p < points.rows(); ++p) {
    const auto mean = [&](auto value) {
      double total = 0;
      for (std::size_t i = 0; i < bodies.rows(); ++i) {
        const double dx = bodies.column("x")[i] - points.column("x_m")[p];
        const double dy = bodies.column("y")[i] - points.column("y_m")[p];
        total += bodies.column("mass")[i] * value(i) *
                 std::exp(-(dx * dx + dy * dy) / (2 * w * w)) / (2 * M_PI * w * w);
      }
      return total;
    };
    const auto& vx = bodies.column("vx");
    const auto& vy = bodies.column("vy");
    const double density = mean([](std::size_t) { return 1.0; });
    const double ux = mean([&](std::size_t i) { return vx[i]; }) / density;
    const double uy = mean([&](std::size_t i) { return vy[i]; }) / density;
    EXPECT_NEAR(points.column("velocity_y_m_s")[p], uy, 1e-9 * std::fabs(uy));
    const double xy = mean([&](std::size_t i) { return (vx[i] - ux) * (vy[i] - uy); });
    const double yy = mean([&](std::size_t i) { return (vy[i] - uy) * (vy[i] - uy); });
    EXPECT_NEAR(points.column("kinetic_stress_xy_N_m")[p], xy, 1e-9 * yy);
    EXPECT_NEAR(points.column("kinetic_stress_yy_N_m")[p], yy, 1e-9 * yy);
    EXPECT_GT(yy, 0);
  }
}

// Without friction the floor pushes up and the side walls push sideways, so that each wall's force
// is the integral of one component over its half of the space; the middle is 5 w from either side
// wall. Rods bounce: of some moments one is taken in which both side walls push.
TEST(StressGoldhirsch, EachWallsForceIsTheIntegralOfTheBoundaryDensity) {
  const auto run = run_liggghts(deck, {{"friction", "0"}, {"steps", "50000"}, {"every", "5000"}});
  ASSERT_EQ(run.exit_code, 0) << run.output;
  int step = 50000;
  const auto forces_at = [&](int of_step) {
    return WallForces(run.folder / ("contacts." + std::to_string(of_step) + ".dump"));
  };
  const auto pushes = [](const WallForces& forces) {
    return std::min(forces.left, -forces.right) > 1e-3;
  };
  while (step > 20000 && !pushes(forces_at(step))) step -= 5000;
  const WallForces forces = forces_at(step);
  ASSERT_TRUE(pushes(forces)) << forces.left << ' ' << forces.right;
  const GridFields fields(run.folder / ("fields." + std::to_string(step) + ".csv"));
  const auto& density = fields["boundary_force_density_x_N_m2"];
  const auto half = [&](double sign) {
    double sum = 0;
    for (std::size_t i = 0; i < density.size(); ++i)
      if (sign * (fields["x_m"][i] - 0.03) > 1e-9) sum += density[i] * fields.h * fields.h;
    return sum;
  };
  EXPECT_NEAR(half(-1), forces.left, 1e-5 * forces.left);
  EXPECT_NEAR(half(1), forces.right, -1e-5 * forces.right);
  EXPECT_NEAR(fields.integral("boundary_force_density_y_N_m2"), forces.floor, 1e-7 * forces.floor);
}

// Without side walls the bed repeats itself, and the balance holds across the border.
TEST(StressGoldhirsch, PeriodicBordersAreNone) {
  const auto run =
      run_liggghts(deck, {{"periodic", "1"}, {"steps", "120000"}, {"every", "120000"}});
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const GridFields rest(run.folder / "fields.120000.csv");
  EXPECT_LT(rest.momentum_residual(), 1e-4);
  const auto column_at = [&](double x, double y) {
    const auto i = static_cast<std::size_t>(std::lround((x + 0.045) / rest.h));
    const auto j = static_cast<std::size_t>(std::lround((y + 0.045) / rest.h));
    return j * rest.nx + i;
  };
  for (const std::string name :
       {"solid_fraction", "contact_stress_xx_N_m", "contact_stress_xy_N_m"})
    for (const double x : {-0.006, 0.0, 0.015})
      EXPECT_NEAR(rest[name][column_at(x, 0.009)], rest[name][column_at(x + 0.06, 0.009)],
                  1e-9 * std::fabs(rest[name][column_at(x, 0.009)]))
          << name << x;
}

// The same state, read from one restart file: sums in another order.
TEST(StressGoldhirsch, OneTwoAndFourRanksAgree) {
  const auto whole = run_liggghts(deck, {{"steps", "40000"}, {"every", "40000"}});
  ASSERT_EQ(whole.exit_code, 0) << whole.output;
  const Table expected = read_table(whole.folder / "fields.40000.csv");
  for (const int ranks : {1, 2, 4}) {
    const auto resumed = run_liggghts(
        deck,
        {{"from", "40000"}, {"steps", "0"}, {"every", "40000"}, {"folder", whole.folder.string()}},
        ranks);
    ASSERT_EQ(resumed.exit_code, 0) << resumed.output;
    expect_same(expected, read_table(resumed.folder / "fields.40000.csv"), 1e-12);
  }
}

// Three dimensions: integrated along z they are two-dimensional fields of the same scale, since the
// Gaussian is a product. Volumes are of order area times diameter.
TEST(StressGoldhirsch, ThreeDimensionsIntegrateToTwo) {
  const auto whole = run_liggghts(deck, {{"steps", "50000"}, {"every", "50000"}});
  ASSERT_EQ(whole.exit_code, 0) << whole.output;
  const auto solid = run_liggghts(deck, {{"from", "50000"},
                                         {"steps", "0"},
                                         {"every", "50000"},
                                         {"dimension", "3"},
                                         {"spacing", "0.003"},
                                         {"folder", whole.folder.string()}});
  ASSERT_EQ(solid.exit_code, 0) << solid.output;
  const Table fields = read_table(solid.folder / "fields.50000.csv");
  const GridFields flat(whole.folder / "fields.50000.csv");
  for (const std::string name :
       {"number_density_1_m", "contact_stress_xy_N_m", "boundary_force_density_y_N_m"}) {
    // unit by unit: N_m2 integrates to N_m, 1_m3 to 1_m2, N_m3 to N_m2
    const bool stress = name.find("stress") != std::string::npos;
    const auto& solid_values = fields.column(name + (stress ? "2" : "3"));
    const auto& flat_values = flat[stress ? name : name + "2"];
    double along_z = 0, scale = 0;
    for (std::size_t k = 0; k < solid_values.size(); ++k)
      if (std::fabs(fields.column("x_m")[k] - 0.03) < 1e-9 &&
          std::fabs(fields.column("y_m")[k] - 0.009) < 1e-9)
        along_z += 0.003 * solid_values[k];
    double planar = NAN;
    for (std::size_t k = 0; k < flat_values.size(); ++k) {
      scale = std::max(scale, std::fabs(flat_values[k]));
      if (std::fabs(flat["x_m"][k] - 0.03) < 1e-9 && std::fabs(flat["y_m"][k] - 0.009) < 1e-9)
        planar = flat_values[k];
    }
    EXPECT_NEAR(along_z, planar, 1e-7 * scale) << name;
  }
}

// sigma at the contact point: -f r times the mean of the Gaussian over the branch of length b,
// erf(b / (2 sqrt(2) w)) / b / (sqrt(2 pi) w); the spheres have one contact and one partner each.
TEST(StressGoldhirsch, TwoSpheresMatchTheClosedForm) {
  const double w = 0.002, b = 0.0029, force = 1000 * 0.0001;
  for (const std::string line : {"exact", "auto"}) {
    const auto run = run_liggghts(two_spheres(
        "compute s all stress/goldhirsch scale 2 times 0.001 tolerance 1e-12 line " + line +
        " point 0.01045 0.01\nrun 0\n"
        "write_dump all stress/goldhirsch s.csv s\n"));
    ASSERT_EQ(run.exit_code, 0) << run.output;
    const Table fields = read_table(run.folder / "s.csv");
    const double mean = std::erf(b / (2 * std::sqrt(2.0) * w)) / b / (std::sqrt(2 * M_PI) * w);
    EXPECT_NEAR(fields.column("contact_stress_xx_N_m")[0], force * b * mean,
                1e-9 * force * b * mean);
    EXPECT_NEAR(fields.column("contact_stress_yy_N_m")[0], 0, 1e-12);
    EXPECT_NEAR(fields.column("coordination_number")[0], 1, 1e-12);
    EXPECT_NEAR(fields.column("contacts_per_particle")[0], 1, 1e-12);
    const double phi = std::exp(-b * b / (8 * w * w)) / (2 * M_PI * w * w);
    EXPECT_NEAR(fields.column("solid_fraction")[0], 2 * M_PI * 0.0015 * 0.0015 * phi, 1e-9);
  }
}

TEST(StressGoldhirsch, WrongInputIsOneClearLine) {
  const auto error_of = [](const std::string& lines) {
    const auto run = run_liggghts(two_spheres(lines));
    EXPECT_NE(run.exit_code, 0) << lines;
    return run.output;
  };
  const std::string compute = "compute s all stress/goldhirsch ";
  const struct {
    std::string arguments, message;
  } cases[] = {
      {"scale 1e-3 box 0.01 0.005 0 0.02", "grid is empty: x from 0.01"},
      {"scale 1e-3 box 0.5 0.6 0 0.02", "is outside the simulation box, 0.000000 to 0.020000"},
      {"scale 1e-3 spacing 1e-9", "more than 1e8 places"},
      {"scale 1e-3 point 0.01 0.01 spacing 0.001", "point and points exclude box and spacing"},
  };
  for (const auto& [arguments, message] : cases)
    EXPECT_THAT(error_of(compute + arguments + "\nrun 0\n"), HasSubstr(message)) << arguments;

  const std::string good = compute + "scale 1e-3\n";
  EXPECT_THAT(error_of(good + "write_dump all stress/goldhirsch s.csv s\n"),
              HasSubstr("contacts are not known here, put a 'run 0' before"));
  EXPECT_THAT(error_of(good + "run 0\nwrite_dump all stress/goldhirsch s.png s\n"),
              HasSubstr("file is s.png, expected a name that ends in .vti or .csv"));
  EXPECT_THAT(error_of(good + "run 0\nwrite_dump all stress/goldhirsch s.csv other\n"),
              HasSubstr("there is no compute stress/goldhirsch with the id 'other'"));
  EXPECT_THAT(error_of(compute + "scale 1e-3 point 0.01 0.01\nrun 0\n"
                                 "write_dump all stress/goldhirsch s.vti s\n"),
              HasSubstr("places at single points have no image: write .csv"));
  EXPECT_THAT(error_of("group some id 1\ncompute s some stress/goldhirsch scale 1e-3\nrun 0\n"),
              HasSubstr("the group has to be 'all'"));
}
