// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/averaging/coarse_graining.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

using namespace rodpack;
using testing::HasSubstr;
using testing::ThrowsMessage;

namespace {

const std::vector<std::vector<double>>& values(const std::vector<Field>& fields,
                                               const std::string& name) {
  for (const auto& field : fields)
    if (field.name == name) return field.values;
  throw std::out_of_range(name);
}

CoarseGrainingOptions exactly(bool couple = true) {
  CoarseGrainingOptions options;
  options.line.points = LineRule::exact;
  options.couple_stress = couple;
  return options;
}

/// A few particles with made-up contacts and walls; no balance of any kind.
struct Scene {
  std::vector<Particle> particles;
  std::vector<SphereContact> contacts;

  explicit Scene(int dimension, unsigned seed = 3) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto vector = [&] {
      Vector v{{uniform(random), uniform(random), uniform(random)}};
      if (dimension == 2) v[2] = 0;
      return v;
    };
    for (int k = 0; k < 5; ++k)
      particles.push_back({vector(), vector(), 1.5 + uniform(random), 0.3, {}});
    for (long i = 0; i < 5; ++i)
      for (long j = 0; j < i; ++j) contacts.push_back(between(i, j, vector(), vector()));
    contacts.push_back(between(1, 0, vector(), vector()));  // a second one of that pair
    for (long i = 0; i < 3; ++i) {
      SphereContact contact = between(i, i, vector(), vector());
      contact.wall = true;
      contact.centre_j = contact.point;
      contacts.push_back(contact);
    }
  }
  SphereContact between(long i, long j, const Vector& point, const Vector& force) const {
    return {i, j, false, point, force, particles[i].centre, particles[j].centre};
  }
  void add_to(CoarseGraining& averages) const {
    for (const auto& interaction : sum_pairs(contacts).interactions) averages.add(interaction);
    for (const auto& particle : particles) averages.add(particle);
  }
};

Vector cross(const Vector& a, const Vector& b) {
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}
Vector minus(const Vector& a, const Vector& b) { return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}}; }

}  // namespace

// Goldhirsch (2010): int sigma dA = -f (x) r exactly, whatever the kernel; f = (-2, 1),
// r = (0.3, 0.1). The wall's force is that on the particle.
TEST(CoarseGraining, OneInteractionIntegratesToItsMoment) {
  const Grid grid = filling_grid(2, {{-2.2, -2.2, 0}}, {{2.6, 2.4, 0}}, 0.05);
  const double cell = grid.spacing[0] * grid.spacing[1];
  for (const std::string line : {"exact", "auto", "1", "4"}) {
    CoarseGrainingOptions options;
    options.line = LineRule::named(line, 1e-12);
    CoarseGraining averages(AveragingKernel(KernelShape::gaussian, 2, 0.25, 7), grid, options);
    averages.add(Interaction{{{0, 0, 0}}, {{0.3, 0.1, 0}}, {{-2, 1, 0}}, {{0, 0, 0}}, true});
    const auto fields = averages.fields();
    const auto integral = [&](const std::string& name, std::size_t component) {
      double sum = 0;
      for (const double value : values(fields, name)[component]) sum += value * cell;
      return sum;
    };
    const double expected[] = {0.6, 0.2, -0.3, -0.1};
    for (std::size_t c = 0; c < 4; ++c)
      EXPECT_NEAR(integral("contact_stress", c), expected[c], 1e-9) << line;
    EXPECT_NEAR(integral("boundary_force_density", 0), -2, 1e-8);
    EXPECT_NEAR(integral("boundary_force_density", 1), 1, 1e-8);
  }
}

// d sigma_ab / d r_b - t_a = -sum over particles of the net force by all contacts, times phi: by
// central differences whose step's error is h^2/6 phi''' / phi ~ 1e-8. It holds for any forces, and
// fails for the wrong sign of the line's parameter. Likewise d mu_ab / d r_b - e_abc sigma_bc =
// -sum of net moments about the centres, times phi.
TEST(CoarseGraining, DivergencesAreTheDensitiesOfForceAndMoment) {
  const double h = 1e-4;
  for (const int dimension : {2, 3})
    for (const auto shape : {KernelShape::gaussian, KernelShape::lucy}) {
      const AveragingKernel kernel(shape, dimension, 0.6, 12);
      const Scene scene(dimension);
      const Vector at{{0.2, -0.1, dimension == 3 ? 0.15 : 0.0}};
      std::vector<Vector> places{at};
      for (int d = 0; d < dimension; ++d)
        for (const double sign : {1.0, -1.0}) {
          places.push_back(at);
          places.back()[d] += sign * h;
        }
      CoarseGraining averages(kernel, places, exactly());
      scene.add_to(averages);
      const auto fields = averages.fields();
      const auto& sigma = values(fields, "contact_stress");
      const auto& mu = values(fields, "couple_stress");
      const auto& wall = values(fields, "boundary_force_density");
      const auto divergence = [&](const std::vector<std::vector<double>>& field, int row) {
        double sum = 0;
        for (int b = 0; b < dimension; ++b)
          sum += (field[row * dimension + b][1 + 2 * b] - field[row * dimension + b][2 + 2 * b]) /
                 (2 * h);
        return sum;
      };

      Vector force{{0, 0, 0}}, moment{{0, 0, 0}};
      for (const auto& contact : scene.contacts) {
        const auto density = [&](long i, double sign) {
          const Vector& centre = scene.particles[i].centre;
          const Vector away = minus(at, centre);
          const double phi =
              kernel(away[0] * away[0] + away[1] * away[1] + away[2] * away[2]) * sign;
          const Vector turn = cross(minus(contact.point, centre), contact.force);
          for (int d = 0; d < 3; ++d) {
            force[d] += phi * contact.force[d];
            moment[d] += phi * turn[d];
          }
        };
        density(contact.i, 1);
        if (!contact.wall) density(contact.j, -1);
      }
      for (int a = 0; a < dimension; ++a)
        EXPECT_NEAR(divergence(sigma, a) - wall[a][0], -force[a], 1e-6);
      const auto stress = [&](int a, int b) { return sigma[a * dimension + b][0]; };
      if (dimension == 2) {
        EXPECT_NEAR(divergence(mu, 0) - (stress(0, 1) - stress(1, 0)), -moment[2], 1e-6);
      } else {
        for (int a = 0; a < 3; ++a) {
          const int b = (a + 1) % 3, c = (a + 2) % 3;
          EXPECT_NEAR(divergence(mu, a) - (stress(b, c) - stress(c, b)), -moment[a], 1e-6);
        }
      }
    }
}

TEST(CoarseGraining, GridAndSinglePlacesAgree) {
  for (const auto shape : {KernelShape::gaussian, KernelShape::lucy, KernelShape::heaviside})
    for (const int dimension : {2, 3})
      for (const std::string line : {"exact", "auto", "2"}) {
        const Grid grid = filling_grid(dimension, {{-1, -1.1, -0.9}}, {{1.2, 1.3, 1.0}}, 0.3);
        std::vector<Vector> places;
        for (std::size_t i = 0; i < grid.size(); ++i) places.push_back(grid.place(i));
        auto options = exactly();
        options.line = LineRule::named(line, 1e-8);
        const AveragingKernel kernel(shape, dimension, 0.3, 4);
        CoarseGraining on_grid(kernel, grid, options), scattered(kernel, places, options);
        const Scene scene(dimension);
        scene.add_to(on_grid);
        scene.add_to(scattered);
        double scale = 0, worst = 0;
        for (std::size_t k = 0; k < on_grid.sums().size(); ++k) {
          scale = std::max(scale, std::fabs(on_grid.sums()[k]));
          worst = std::max(worst, std::fabs(on_grid.sums()[k] - scattered.sums()[k]));
        }
        EXPECT_LE(worst, 1e-13 * scale);
      }
}

// Points along the branch, where they belong: with a tight tolerance the sums are those of the
// closed form, couple stress included.
TEST(CoarseGraining, PointsAlongTheBranchMatchTheClosedForm) {
  const Grid grid = filling_grid(2, {{-1, -1, 0}}, {{1, 1, 0}}, 0.25);
  const AveragingKernel kernel(KernelShape::gaussian, 2, 0.4, 8);
  auto options = exactly();
  CoarseGraining closed(kernel, grid, options);
  options.line = LineRule::named("auto", 1e-13);
  CoarseGraining points(kernel, grid, options);
  const Scene scene(2);
  scene.add_to(closed);
  scene.add_to(points);
  double scale = 0, worst = 0;
  for (std::size_t k = 0; k < closed.sums().size(); ++k) {
    scale = std::max(scale, std::fabs(closed.sums()[k]));
    worst = std::max(worst, std::fabs(closed.sums()[k] - points.sums()[k]));
  }
  EXPECT_LE(worst, 1e-11 * scale);
}

// All places, centres and forces turned by 37 degrees: sigma becomes R sigma R^T.
TEST(CoarseGraining, TurnsWithTheScene) {
  const double c = std::cos(37 * M_PI / 180), s = std::sin(37 * M_PI / 180);
  const auto turned = [&](const Vector& v) {
    return Vector{{c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]}};
  };
  const Scene scene(2);
  Scene other = scene;
  for (auto& particle : other.particles) {
    particle.centre = turned(particle.centre);
    particle.velocity = turned(particle.velocity);
  }
  for (auto& contact : other.contacts)
    for (Vector* v : {&contact.point, &contact.force, &contact.centre_i, &contact.centre_j})
      *v = turned(*v);
  const Vector at{{0.3, 0.2, 0}};
  for (const std::string line : {"exact", "auto"}) {
    auto options = exactly();
    options.line = LineRule::named(line, 1e-6);
    const AveragingKernel kernel(KernelShape::gaussian, 2, 0.5, 5);
    CoarseGraining a(kernel, std::vector<Vector>{at}, options);
    CoarseGraining b(kernel, std::vector<Vector>{turned(at)}, options);
    scene.add_to(a);
    other.add_to(b);
    for (const std::string name : {"contact_stress", "kinetic_stress"}) {
      const auto x = values(a.fields(), name), y = values(b.fields(), name);
      const double R[2][2] = {{c, -s}, {s, c}};
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) {
          double expected = 0;
          for (int k = 0; k < 2; ++k)
            for (int l = 0; l < 2; ++l) expected += R[i][k] * x[2 * k + l][0] * R[j][l];
          EXPECT_NEAR(y[2 * i + j][0], expected, 1e-12) << name;
        }
    }
  }
}

// A square lattice of spacing a whose neighbours press with F: F / a in both directions, no shear;
// solid fraction A / a^2, four neighbours each. The ripple of the Gaussian over a lattice is
// 2 exp(-2 pi^2 w^2 / a^2) = 5e-9 at w = a; periodic in x and y.
TEST(CoarseGraining, LatticeUnderLoadHasUniformStress) {
  const double a = 0.5, F = 3;
  const int n = 6;
  CoarseGrainingOptions options;
  options.period = {{n * a, n * a, 0}};
  options.line = LineRule::named("auto", 1e-12);
  CoarseGraining averages(AveragingKernel(KernelShape::gaussian, 2, a, 8),
                          filling_grid(2, {{0, 0, 0}}, {{n * a, n * a, 0}}, 0.2), options);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Vector centre{{(i + 0.25) * a, (j + 0.5) * a, 0}};
      averages.add(Particle{centre, {{2, -1, 0}}, 0.7, 0.1, {4, 4}});
      averages.add(Interaction{centre, {{a, 0, 0}}, {{-F, 0, 0}}, {{0, 0, 0}}, false});
      averages.add(Interaction{centre, {{0, a, 0}}, {{0, -F, 0}}, {{0, 0, 0}}, false});
    }
  const auto fields = averages.fields();
  const auto uniform = [&](const std::string& name, std::size_t component, double expected) {
    for (const double value : values(fields, name)[component])
      EXPECT_NEAR(value, expected, 3e-8 * std::max(1.0, std::fabs(expected))) << name;
  };
  uniform("contact_stress", 0, F / a);
  uniform("contact_stress", 1, 0);
  uniform("contact_stress", 3, F / a);
  uniform("solid_fraction", 0, 0.1 / (a * a));
  uniform("mass_density", 0, 0.7 / (a * a));
  uniform("velocity", 1, -1);
  uniform("kinetic_stress", 0, 0);  // all move alike
  uniform("coordination_number", 0, 4);
}

TEST(CoarseGraining, PartsAddUpAndFramesAverage) {
  const AveragingKernel kernel(KernelShape::gaussian, 2, 0.5, 5);
  const Grid grid = filling_grid(2, {{-1, -1, 0}}, {{1, 1, 0}}, 0.5);
  const Scene scene(2);
  CoarseGraining whole(kernel, grid, exactly()), first(kernel, grid, exactly()),
      second(kernel, grid, exactly());
  scene.add_to(whole);
  for (const auto& particle : scene.particles) first.add(particle);
  for (const auto& interaction : sum_pairs(scene.contacts).interactions) second.add(interaction);
  for (std::size_t k = 0; k < whole.sums().size(); ++k)
    EXPECT_NEAR(first.sums()[k] + second.sums()[k], whole.sums()[k], 1e-14);
  const auto one = whole.fields();
  scene.add_to(whole);  // the same frame twice
  const auto two = whole.fields(2);
  for (std::size_t f = 0; f < one.size(); ++f)
    for (std::size_t c = 0; c < one[f].values.size(); ++c)
      for (std::size_t i = 0; i < grid.size(); ++i)
        EXPECT_NEAR(two[f].values[c][i], one[f].values[c][i],
                    1e-12 * std::max(1.0, std::fabs(one[f].values[c][i])));
}

TEST(CoarseGraining, TableHasAColumnPerComponent) {
  CoarseGraining averages(AveragingKernel(KernelShape::gaussian, 2, 1),
                          std::vector<Vector>{{{0.5, 0.25, 0}}});
  const auto text = csv_text(averages, averages.fields());
  EXPECT_THAT(text, testing::StartsWith("x_m,y_m,number_density_1_m2,mass_density_kg_m2,"
                                        "solid_fraction,momentum_density_x_kg_m_s,"));
  EXPECT_THAT(text, HasSubstr(",contact_stress_xx_N_m,contact_stress_xy_N_m,"));
  EXPECT_THAT(text, HasSubstr("\n0.5,0.25,0,0,"));
}

TEST(CoarseGraining, WrongPlacesAreNamed) {
  const AveragingKernel kernel(KernelShape::gaussian, 2, 1);
  EXPECT_THAT([&] { CoarseGraining(kernel, std::vector<Vector>{}); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("no places")));
  Grid empty;
  empty.count[1] = 0;
  EXPECT_THAT([&] { CoarseGraining(kernel, empty); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("grid along y has no places")));
  Grid solid;
  solid.count[2] = 2;
  EXPECT_THAT([&] { CoarseGraining(kernel, solid); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("three dimensions")));
  EXPECT_THAT(
      [] {
        filling_grid(2, {{1, 0, 0}}, {{1, 1, 0}}, 0.1);
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("grid is empty: x from 1")));
  EXPECT_THAT(
      [] {
        filling_grid(2, {{0, 0, 0}}, {{1, 1, 0}}, 0);
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("grid spacing is 0")));
  const Grid grid = filling_grid(2, {{0, 0, 0}}, {{1, 2, 0}}, 0.26);
  EXPECT_EQ(grid.count[0], 5);
  EXPECT_NEAR(grid.place(grid.size() - 1)[1], 2, 1e-15);
}

// Contacts of a pair listed either way round are one interaction with the sum of their forces and
// moments about the centre of the particle with the lower id.
TEST(ContactPairs, ContactsOfAPairAreSummed) {
  const Vector a{{0, 0, 0}}, b{{1, 0, 0}};
  const auto sum = sum_pairs({{2, 5, false, {{0.5, 0.1, 0}}, {{-1, 0, 0}}, a, b},
                              {5, 2, false, {{0.5, -0.1, 0}}, {{2, 1, 0}}, b, a},
                              {5, 0, true, {{1, -0.2, 0}}, {{0, 3, 0}}, b, {{1, -0.2, 0}}},
                              {5, 0, true, {{1.1, -0.2, 0}}, {{0, 1, 0}}, b, {{1.1, -0.2, 0}}}});
  ASSERT_EQ(sum.interactions.size(), 3u);
  const auto& pair = sum.interactions[0];
  EXPECT_EQ(pair.force, (Vector{{-3, -1, 0}}));
  EXPECT_EQ(pair.branch, (Vector{{1, 0, 0}}));
  // (0.5, 0.1) x (-1, 0) = 0.1; (0.5, -0.1) x (-2, -1) = -0.7
  EXPECT_NEAR(pair.moment[2], -0.6, 1e-15);
  EXPECT_TRUE(sum.interactions[1].wall);
  ASSERT_EQ(sum.pairs.size(), 1u);
  EXPECT_EQ(sum.pairs[0].contacts, 2);
  const auto touching = count_touching(sum.pairs, 6);
  EXPECT_EQ(touching[5].particles, 1);
  EXPECT_EQ(touching[2].contacts, 2);
}

TEST(ContactPairs, PeriodicImagesStayApartButArePartnersOnce) {
  const Vector a{{0.1, 0, 0}}, right{{0.6, 0, 0}}, left{{-0.4, 0, 0}};
  const auto sum = sum_pairs({{1, 2, false, {{0.35, 0, 0}}, {{-1, 0, 0}}, a, right},
                              {1, 2, false, {{-0.15, 0, 0}}, {{1, 0, 0}}, a, left}});
  EXPECT_EQ(sum.interactions.size(), 2u);
  ASSERT_EQ(sum.pairs.size(), 1u);
  EXPECT_EQ(sum.pairs[0].contacts, 2);
  const auto merged = merge_pairs({{3, 4, 1}, {1, 2, 2}, {3, 4, 5}});
  ASSERT_EQ(merged.size(), 2u);
  EXPECT_EQ(merged[1].contacts, 6);
}
