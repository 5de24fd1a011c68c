// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/fields.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "liggghts_run.h"
#include "analysis/pressure_profile.h"
#include "synthetic_packing.h"
#include "analysis/janssen_fit.h"

using namespace rodpack;
using rodpack::test::frame_head;
using rodpack::test::fresh_folder;
using rodpack::test::put;
using testing::HasSubstr;
using testing::ThrowsMessage;

namespace {

const char* const body_columns =
    "id type nspheres x y z angle vx vy vz half_length radius curvature area mass";
const char* const contact_columns =
    "body_i body_j sphere_i sphere_j wall x y z fx fy fz bix biy biz bjx bjy bjz";

/// Square lattice of n x n spheres, spacing a, on a floor and between walls; each layer carries the
/// weight of those above it, F = (layers above) m g, and presses sideways with `ratio` of it.
struct Lattice {
  int n = 20;
  double a = 3e-3, mass = 1e-3, ratio = 0.5;
  std::string bodies, contacts;
  std::size_t contact_rows = 0;

  double weight_above(int row) const { return (n - row) * mass * 9.81; }
  void fill() {
    std::ostringstream b, c;
    b.precision(16);
    c.precision(16);
    const auto contact = [&](int i, int j, double x, double y, double fx, double fy, double bx,
                             double by, double jx, double jy) {
      c << i << ' ' << j << ' ' << i << ' ' << j << ' ' << (j == 0) << ' ' << x << ' ' << y << " 0 "
        << fx << ' ' << fy << " 0 " << bx << ' ' << by << " 0 " << jx << ' ' << jy << " 0\n";
      ++contact_rows;
    };
    for (int row = 0; row < n; ++row)
      for (int column = 0; column < n; ++column) {
        const int id = row * n + column + 1;
        const double x = (column + 0.5) * a, y = (row + 0.5) * a;
        b << id << " 1 1 " << x << ' ' << y << " 0 0 0 0 0 " << a / 2 << ' ' << a / 2 << " 0 "
          << M_PI * a * a / 4 << ' ' << mass << '\n';
        const double down = weight_above(row), side = ratio * down;
        if (row == 0)
          contact(id, 0, x, 0, 0, down, x, y, x, 0);
        else
          contact(id, id - n, x, y - a / 2, 0, down, x, y, x, y - a);
        if (column == 0)
          contact(id, 0, 0, y, side, 0, x, y, 0, y);
        else
          contact(id, id - 1, x - a / 2, y, side, 0, x, y, x - a, y);
        if (column == n - 1) contact(id, 0, n * a, y, -side, 0, x, y, n * a, y);
      }
    bodies = b.str();
    contacts = c.str();
  }
  std::string bodies_frame(long step) const {
    return frame_head(step, n * n, n * a, 2 * n * a, body_columns) + bodies;
  }
  std::string contacts_frame(long step) const {
    return frame_head(step, contact_rows, n * a, 2 * n * a, contact_columns) + contacts;
  }
};

Lattice lattice() {
  Lattice made;
  made.fill();
  return made;
}

Frame frame_of(const std::string& text) {
  return last_frame({put(fresh_folder() / "a.dump", text)});
}

PressureProfile profile_of(double (*pressure)(double)) {
  PressureProfile profile;
  profile.particle_diameter = 1;
  profile.scale = 1;
  profile.depth_of_floor = 60;
  for (double h = 0; h <= 60; h += 0.5) {
    profile.depth.push_back(h);
    profile.pressure.push_back(pressure(h));
  }
  return profile;
}

}  // namespace

// At the middle of the lattice, w = 2 a: sigma_yy = F / a with F the linear weight, which the
// symmetric kernel averages to its value at the same height: n - y/a layers are above, and between
// the centres of two rows the force is that of the upper one. sigma_xx is `ratio` times the mean
// load of the rows there.
TEST(Fields, LatticeCarriesTheWeightOfItsLayers) {
  const auto made = lattice();
  const auto bodies = frame_of(made.bodies_frame(1)), contacts = frame_of(made.contacts_frame(1));
  const auto packing = read_packing(bodies);
  FieldOptions options;
  options.scale = 2 * made.a;
  options.spacing = made.a;
  options.tolerance = 1e-9;
  FieldSample sample(options);
  sample.add(packing, bodies, &contacts);
  const auto fields = sample.fields();
  const Grid& grid = *sample.averages().grid();
  const double middle = made.n / 2 * made.a;
  bool found = false;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const Vector place = grid.place(i);
    if (std::fabs(place[0] - middle) > 1e-9 || std::fabs(place[1] - middle) > 1e-9) continue;
    found = true;
    const auto& stress = field_named(fields, "contact_stress").values;
    // At y = 10 a the branch from row 9 to row 10 carries 10 layers: rows 10 ... 19.
    const double yy = 10 * made.mass * 9.81 / made.a;
    const double xx = made.ratio * 10.5 * made.mass * 9.81 / made.a;
    EXPECT_NEAR(stress[3][i], yy, 1e-4 * yy);  // 10 a is 5 w from the walls: 2e-6 of the kernel
    EXPECT_NEAR(stress[0][i], xx, 1e-4 * xx);
    EXPECT_NEAR(stress[1][i], 0, 1e-9 * yy);
    EXPECT_NEAR(field_named(fields, "solid_fraction").values[0][i], M_PI / 4, 1e-5);
    EXPECT_NEAR(field_named(fields, "coordination_number").values[0][i], 4, 1e-4);
  }
  EXPECT_TRUE(found);
}

// The lattice up to its surface and walls, w = 2 a: its solid fraction is even, pi/4, to the error
// of the sum over its rows, below (a/w)^2/24 t' / (1/2) < 0.01 of it at an edge. The stress, at the
// walls too, is the plain one over the share, (1 + erf(h / w sqrt 2)) / 2 at the height h.
TEST(Fields, NormalisedByTheKernelsShareDensitiesAreEvenUpToTheEdges) {
  const auto made = lattice();
  const auto bodies = frame_of(made.bodies_frame(1)), contacts = frame_of(made.contacts_frame(1));
  auto packing = read_packing(bodies);
  packing.surface = made.n * made.a;
  FieldOptions options;
  options.scale = 2 * made.a;
  options.spacing = made.a;
  options.tolerance = 1e-9;
  options.window = {{0, made.n * made.a, 0, (made.n + 2) * made.a}};
  const auto fields_with = [&](Normalisation normalisation) {
    options.normalisation = normalisation;
    FieldSample sample(options);
    sample.add(packing, bodies, &contacts);
    return std::pair(sample.fields(), *sample.averages().grid());
  };
  const auto [plain, grid] = fields_with(Normalisation::none);
  const auto walls = fields_with(Normalisation::walls).first;
  const auto both = fields_with(Normalisation::walls_and_surface).first;
  const double w = *options.scale, width = made.n * made.a;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const Vector place = grid.place(i);
    const double share_x = gaussian_integral(-place[0], width - place[0], w);
    const double share_y = 0.5 * (1 + std::erf(place[1] / (w * std::sqrt(2.0))));
    const auto phi = [i](const std::vector<Field>& fields) {
      return field_named(fields, "solid_fraction").values[0][i];
    };
    const auto yy = [i](const std::vector<Field>& fields) {
      return field_named(fields, "contact_stress").values[3][i];
    };
    EXPECT_NEAR(yy(walls), yy(plain) / (share_x * share_y), 1e-12 * std::abs(yy(walls)));
    EXPECT_NEAR(phi(walls), phi(plain) / (share_x * share_y), 1e-12);
    const bool below = place[1] <= packing.surface * (1 + 1e-12);
    EXPECT_NEAR(phi(both), below ? M_PI / 4 : 0, 0.02) << place[0] << ' ' << place[1];
    if (!below) {
      EXPECT_EQ(yy(both), 0);
    }
  }
}

// diag(3, 1) turned by 30 degrees.
TEST(Fields, PrincipalStressOfATurnedTensor) {
  const double c = std::cos(M_PI / 6), s = std::sin(M_PI / 6);
  const auto principal =
      principal_stress(3 * c * c + s * s, 2 * c * s + 0.1, 2 * c * s - 0.1, 3 * s * s + c * c);
  EXPECT_NEAR(principal.larger, 3, 1e-14);
  EXPECT_NEAR(principal.smaller, 1, 1e-14);
  EXPECT_NEAR(principal.direction, 30, 1e-12);
}

TEST(Fields, WrongFramesAreNamed) {
  const auto made = lattice();
  const auto bodies = frame_of(made.bodies_frame(1));
  const auto packing = read_packing(bodies);
  const auto other = frame_of(made.contacts_frame(2));
  EXPECT_THAT([&] { FieldSample({}).add(packing, bodies, &other); },
              ThrowsMessage<DataError>(HasSubstr("contacts of timestep 2, expected 1 as in")));
  Lattice larger;
  larger.n = 21;
  larger.fill();
  const auto strange = frame_of(larger.contacts_frame(1));
  EXPECT_THAT([&] { FieldSample({}).add(packing, bodies, &strange); },
              ThrowsMessage<DataError>(HasSubstr("particle 401 of a contact is not in")));
  EXPECT_THAT([&] { FieldSample({}).add(packing, bodies, &bodies); },
              ThrowsMessage<DataError>(HasSubstr("no column 'body_i'")));
  FieldOptions options;
  options.scale = -1;
  EXPECT_THAT([&] { FieldSample(options).add(packing, bodies, nullptr); },
              ThrowsMessage<DataError>(HasSubstr("scale: expected a length > 0, found -1")));
  options = {};
  options.window = {{1, 2, 0, 1}};
  EXPECT_THAT([&] { FieldSample(options).add(packing, bodies, nullptr); },
              ThrowsMessage<DataError>(HasSubstr("is outside the container")));
  EXPECT_THAT([] { FieldSample({}).fields(); }, ThrowsMessage<TooFewParticles>(HasSubstr("frame")));
}

TEST(Janssen, ExactProfileIsRecovered) {
  const auto fit = fit_janssen(profile_of([](double h) { return 2 * (1 - std::exp(-h / 15)); }));
  EXPECT_NEAR(fit.pressure, 2, 2e-8);
  EXPECT_NEAR(fit.depth, 15, 15e-8);
  EXPECT_LT(fit.rms_residual, 1e-7);
  EXPECT_TRUE(fit.saturates);
  EXPECT_NEAR(fit.to, 57, 1e-12);  // 3 w above the floor
}

// Noise that is correlated as the kernel's: white noise averaged by the Gaussian has the
// correlation exp(-x^2 / 4 w^2). Over many draws the deviations of P_j in units of its standard
// error have the variance 1; with 400 draws it is known to 7 %, and the error formula, which takes
// derivatives at the fit, to about as much. Without the factor for the correlation it would be 7.
TEST(Janssen, StandardErrorIsThatOfCorrelatedNoise) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  double squares = 0;
  const int draws = 400;
  for (int draw = 0; draw < draws; ++draw) {
    auto profile = profile_of([](double h) { return 2 * (1 - std::exp(-h / 10)); });
    std::vector<double> white(profile.depth.size() + 40);
    for (double& value : white) value = normal(random);
    for (std::size_t k = 0; k < profile.depth.size(); ++k)
      for (int j = -20; j <= 20; ++j)
        profile.pressure[k] += 0.02 * white[k + 20 + j] * std::exp(-0.5 * 0.25 * j * j);
    const auto fit = fit_janssen(profile);
    squares += std::pow((fit.pressure - 2) / fit.pressure_error, 2);
  }
  EXPECT_NEAR(squares / draws, 1, 0.35);
}

TEST(Janssen, ALinearProfileDoesNotSaturate) {
  const auto linear = profile_of([](double h) { return 0.1 * h; });
  bool saturates = false;
  try {
    const auto fit = fit_janssen(linear);
    saturates = fit.saturates;
    EXPECT_THAT(describe(fit, 1), HasSubstr("does not saturate within the bed"));
  } catch (const TooFewParticles& reason) {
    EXPECT_THAT(reason.what(), HasSubstr("like a straight line or faster"));
  }
  EXPECT_FALSE(saturates);
  auto low = linear;
  low.depth_of_floor = 5.9;
  EXPECT_THAT([&] { fit_janssen(low); },
              ThrowsMessage<TooFewParticles>(HasSubstr("the bed is too low")));
}

TEST(FieldCommands, WriteTablesImagesAndFigures) {
  const auto folder = fresh_folder();
  const auto made = lattice();
  put(folder / "bodies.7.dump", made.bodies_frame(7));
  put(folder / "contacts.7.dump", made.contacts_frame(7));
  const auto run = [&](const std::string& arguments) {
    return rodpack::test::run_rodpack(arguments, folder);
  };
  const auto written = [&](const std::string& name) {
    return std::filesystem::exists(folder / name) && std::filesystem::file_size(folder / name) > 0;
  };
  auto done = run("stress bodies.7.dump --couple --scale-in-dp 2");
  ASSERT_EQ(done.exit_code, 0) << done.output;
  for (const std::string name :
       {"stress.vti", "stress.csv", "stress_pressure.png", "stress_pressure.svg"})
    EXPECT_TRUE(written(name)) << name;
  done = run("solid-fraction bodies.7.dump --scale 0.006 -o phi");
  ASSERT_EQ(done.exit_code, 0) << done.output;
  for (const std::string name : {"phi.vti", "phi.csv", "phi.png", "phi.svg"})
    EXPECT_TRUE(written(name)) << name;
  done = run("profile bodies.7.dump --contacts 'contacts.*.dump' --scale-in-dp 2");
  ASSERT_EQ(done.exit_code, 0) << done.output;
  for (const std::string name : {"profile.csv", "profile.png", "profile.svg"})
    EXPECT_TRUE(written(name)) << name;
  // No friction at the walls: the pressure grows linearly with depth.
  EXPECT_THAT(done.output, testing::AnyOf(HasSubstr("does not saturate"), HasSubstr("straight")));

  // Half of the kernel is inside at the floor, where the pressure is twice as high for it.
  const auto last_pressure = [&](const std::string& options) {
    done = run("profile bodies.7.dump --scale-in-dp 2 -o p " + options);
    EXPECT_EQ(done.exit_code, 0) << done.output;
    return rodpack::test::read_table(folder / "p.csv").column("pressure_N_m").back();
  };
  EXPECT_NEAR(last_pressure("--normalise walls") / last_pressure(""), 2, 1e-3);
  done = run("solid-fraction bodies.7.dump --scale 0.006 -o phi --normalise walls-and-surface");
  EXPECT_THAT(done.output, HasSubstr("divided by the kernel's share"));
  EXPECT_EQ(run("stress bodies.7.dump --normalise floor").exit_code, 2);

  put(folder / "bodies.8.dump", made.bodies_frame(8));
  put(folder / "contacts.8.dump", frame_head(8, 0, made.n * made.a, 1, contact_columns));
  EXPECT_THAT(run("stress bodies.8.dump").output,
              HasSubstr("rodpack: contacts.8.dump: no contacts in the frame of timestep 8"));
  EXPECT_THAT(run("stress bodies.8.dump --contacts contacts.7.dump").output, HasSubstr("timestep"));
  EXPECT_EQ(run("stress bodies.8.dump").exit_code, 1);
  put(folder / "x.dump", made.bodies_frame(8));
  EXPECT_THAT(run("profile x.dump").output, HasSubstr("give the contacts with --contacts"));
  EXPECT_EQ(run("stress bodies.7.dump --scale 0").exit_code, 2);
  EXPECT_EQ(run("stress bodies.7.dump --kernel box").exit_code, 2);
  EXPECT_EQ(run("stress bodies.7.dump --window 1 0 0 1").exit_code, 2);
  EXPECT_THAT(run("stress bodies.7.dump --window 5 6 0 1").output, HasSubstr("outside"));
  put(folder / "bodies.9.dump", frame_head(9, 0, 1, 1, body_columns));
  EXPECT_THAT(run("solid-fraction bodies.9.dump").output, HasSubstr("holds no particles"));
}
