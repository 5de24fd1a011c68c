// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/orientation.h"

#include <cmath>
#include <complex>

#include "reading/angles.h"
#include "reading/csv_file.h"

namespace rodpack {
namespace {

// Folds a value into [0, period); a value a rounding error below 0 becomes 0, not the period.
double folded(double value, double period) {
  const double rest = value - period * std::floor(value / period);
  return rest < period ? rest : 0;
}

// The mean of exp(i fold gamma).
std::complex<double> mean_power(const std::vector<double>& gamma, int fold) {
  if (gamma.empty()) throw TooFewParticles("no particle to take the order of directions of");
  std::complex<double> sum = 0;
  for (const double each : gamma) sum += std::polar(1.0, fold * each * degree);
  return sum / static_cast<double>(gamma.size());
}

// Standard error of the mean of cos fold (gamma - director), directors in degrees.
double cosine_error(const std::vector<double>& gamma, int fold, double director, double mean) {
  const double n = static_cast<double>(gamma.size());
  double variance = 0;
  for (const double each : gamma) {
    const double deviation = std::cos(fold * (each - director) * degree) - mean;
    variance += deviation * deviation / n;
  }
  return std::sqrt(variance / n);
}
}  // namespace

double gamma_degrees(double angle, bool curved) {
  return folded(angle / degree, curved ? 360 : 180);
}

NematicOrder nematic_order(const std::vector<double>& gamma) {
  const auto mean = mean_power(gamma, 2);
  const double director = std::arg(mean) / 2 / degree;
  return {std::abs(mean), cosine_error(gamma, 2, director, std::abs(mean)), folded(director, 180)};
}

SixfoldOrder sixfold_order(const std::vector<double>& gamma) {
  const auto mean = mean_power(gamma, 6);
  return {std::abs(mean), mean.real(), cosine_error(gamma, 6, 0, mean.real())};
}

void OrientationSample::add(const Packing& packing) {
  const auto& walls = packing.walls;
  const double margin = packing.axial_length();
  for (std::size_t i = 0; i < packing.size(); ++i) {
    if (!packing.elongated[i]) {
      ++spheres_;
      continue;
    }
    const bool near_side =
        walls.sides && (packing.x[i] - walls.left < margin || walls.right - packing.x[i] < margin);
    const bool near_floor = walls.bottom && packing.y[i] - walls.floor < margin;
    if (near_side || near_floor) {
      ++near_walls_;
      continue;
    }
    const bool curved = packing.curvature[i] > 0;
    if (curved_.value_or(curved) != curved)
      throw MixedParticles(
          "straight and curved particles are mixed: their gamma have different ranges (180 and 360 "
          "degrees); dump them into files of their own");
    curved_ = curved;
    gamma_.push_back(gamma_degrees(packing.angle[i], curved));
  }
}

OrientationDistribution OrientationSample::distribution(std::optional<int> bins) const {
  if (gamma_.empty())
    throw TooFewParticles("no particle to take the orientation of: " + std::to_string(spheres_) +
                          " spheres have no axis, " + std::to_string(near_walls_) +
                          " particles are closer than AR d_p to a wall");
  OrientationDistribution result;
  result.curved = *curved_;
  result.range = result.curved ? 360 : 180;
  result.particles = gamma_.size();
  result.near_walls = near_walls_;
  result.spheres = spheres_;
  result.nematic = nematic_order(gamma_);
  result.sixfold = sixfold_order(gamma_);

  const auto number = static_cast<std::size_t>(bins.value_or(result.curved ? 72 : 36));
  const double width = result.range / static_cast<double>(number);
  const double n = static_cast<double>(gamma_.size());
  result.count.assign(number, 0);
  for (const double gamma : gamma_)
    result.count[static_cast<std::size_t>(gamma / width + 0.5) % number] += 1;
  for (std::size_t k = 0; k < result.count.size(); ++k) {
    const double p = result.count[k] / n;
    result.centre.push_back(static_cast<double>(k) * width);
    result.density.push_back(p / width);
    result.standard_error.push_back(std::sqrt(p * (1 - p) / n) / width);
  }
  return result;
}

void write_orientation_table(const OrientationDistribution& distribution, const std::string& file) {
  write_csv(file, {{"gamma_deg", distribution.centre},
                   {"count", distribution.count},
                   {"probability_density_per_deg", distribution.density},
                   {"standard_error_per_deg", distribution.standard_error}});
}

}  // namespace rodpack
