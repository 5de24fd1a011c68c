// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "rodpack/averaging/coarse_graining.h"

using namespace rodpack;

namespace {

const std::vector<std::vector<double>>& values(const std::vector<Field>& fields,
                                               const std::string& name) {
  for (const auto& field : fields)
    if (field.name == name) return field.values;
  throw std::out_of_range(name);
}

}  // namespace

// With u = sum m v phi / sum m phi: sum m (v - u)_a (v - u)_b phi, summed directly; its diagonal is
// positive, as compression is.
TEST(CoarseGraining, KineticStressIsThatOfTheDeviationsFromTheMeanVelocity) {
  for (const int dimension : {2, 3}) {
    const AveragingKernel kernel(KernelShape::gaussian, dimension, 0.6, 8);
    const Vector at{{0.1, 0.2, 0}};
    const Particle particles[] = {{{{0, 0, 0}}, {{1, -2, 0.5}}, 1.5, 0.1, {}},
                                  {{{0.7, -0.2, 0}}, {{-0.5, 3, 1}}, 0.8, 0.1, {}},
                                  {{{-0.4, 0.9, 0}}, {{2, 0.25, -1.5}}, 2.1, 0.1, {}}};
    CoarseGraining averages(kernel, std::vector<Vector>{at});
    double mass = 0, u[3] = {0, 0, 0}, phi[3];
    for (int k = 0; k < 3; ++k) {
      const Particle& particle = particles[k];
      averages.add(particle);
      phi[k] =
          kernel(std::pow(particle.centre[0] - at[0], 2) + std::pow(particle.centre[1] - at[1], 2));
      mass += particle.mass * phi[k];
      for (int d = 0; d < 3; ++d) u[d] += particle.mass * phi[k] * particle.velocity[d];
    }
    for (double& component : u) component /= mass;
    const auto stress = values(averages.fields(), "kinetic_stress");
    for (int a = 0; a < dimension; ++a)
      for (int b = 0; b < dimension; ++b) {
        double expected = 0;
        for (int k = 0; k < 3; ++k)
          expected += particles[k].mass * phi[k] * (particles[k].velocity[a] - u[a]) *
                      (particles[k].velocity[b] - u[b]);
        EXPECT_NEAR(stress[a * dimension + b][0], expected, 1e-12 * mass * 9) << a << b;
        if (a == b) {
          EXPECT_GT(stress[a * dimension + b][0], 0);
        }
      }
  }
}

// Means over the particles by phi: at the middle of two of them, plain means, (2 + 5) / 2 and
// (3 + 8) / 2.
TEST(CoarseGraining, ContactsAndPartnersOfAParticleAreTwoFields) {
  CoarseGraining averages(AveragingKernel(KernelShape::gaussian, 2, 1),
                          std::vector<Vector>{{{0, 0, 0}}});
  averages.add(Particle{{{-1, 0, 0}}, {{0, 0, 0}}, 1, 0.1, {2, 3}});
  averages.add(Particle{{{1, 0, 0}}, {{0, 0, 0}}, 1, 0.1, {5, 8}});
  const auto fields = averages.fields();
  EXPECT_NEAR(values(fields, "coordination_number")[0][0], 3.5, 1e-14);
  EXPECT_NEAR(values(fields, "contacts_per_particle")[0][0], 5.5, 1e-14);
}

// A scene that repeats: all sums are those of the same scene with its images listed. Kernel of
// reach 1.2 (w = 0.3, 4 w), period 2: images -1, 0, 1 reach the places; a wall and a pair across
// the border, along each axis.
TEST(CoarseGraining, PeriodicImagesOfParticlesPairsAndWallsCount) {
  for (const int dimension : {2, 3})
    for (int axis = 0; axis < dimension; ++axis)
      for (const char* line : {"exact", "auto"}) {
        const AveragingKernel kernel(KernelShape::gaussian, dimension, 0.3, 4);
        CoarseGrainingOptions options;
        options.couple_stress = true;
        options.line = LineRule::named(line, 1e-6);
        std::vector<Vector> places(3, Vector{{0.1, 0.05, -0.1}});
        places[1][static_cast<std::size_t>(axis)] = 1;
        places[2][static_cast<std::size_t>(axis)] = 1.93;
        CoarseGraining listed(kernel, places, options);
        options.period[static_cast<std::size_t>(axis)] = 2;
        CoarseGraining periodic(kernel, places, options);
        Vector start{{0.2, -0.1, 0.05}}, branch{{0.15, 0.2, -0.1}};
        start[static_cast<std::size_t>(axis)] = 1.85;  // the branch crosses the border at 2
        branch[static_cast<std::size_t>(axis)] = 0.3;
        for (const bool wall : {false, true})
          for (int image = -2; image <= 2; ++image) {
            Vector from = start;
            from[static_cast<std::size_t>(axis)] += 2 * image;
            const Interaction interaction{from, branch, {{-2, 1, 0.5}}, {{0.1, -0.2, 0.3}}, wall};
            const Particle particle{from, {{1, 2, 3}}, 0.7, 0.1, {1, 2}};
            listed.add(interaction);
            listed.add(particle);
            if (image != 0) continue;
            periodic.add(interaction);
            periodic.add(particle);
          }
        for (std::size_t k = 0; k < listed.sums().size(); ++k)
          EXPECT_NEAR(periodic.sums()[k], listed.sums()[k], 1e-12 * kernel.norm() * 6.3) << k;
      }
}

// The name sets ten times the fields' tolerance for one branch, as line_rule.h says.
TEST(LineRule, OneBranchMayErrTenTimesTheTolerance) {
  EXPECT_NEAR(LineRule::named("auto", 1e-6).tolerance, 1e-5, 1e-17);
}

// 1/3 has no short decimal: 15 digits bring it back to 1e-15.
TEST(CoarseGraining, TableKeepsFifteenDigits) {
  CoarseGraining averages(AveragingKernel(KernelShape::gaussian, 2, 1),
                          std::vector<Vector>{{{1.0 / 3, 0, 0}}});
  averages.add(Particle{{{1.0 / 3, 0, 0}}, {{0, 0, 0}}, 1, 0.1, {}});
  std::istringstream text(csv_text(averages, averages.fields()));
  std::string header, x, y, number;
  std::getline(text, header);
  std::getline(text, x, ',');
  std::getline(text, y, ',');
  std::getline(text, number, ',');
  EXPECT_NEAR(std::stod(x), 1.0 / 3, 1e-15);
  EXPECT_NEAR(std::stod(number), averages.kernel().norm(), 1e-15);
}
