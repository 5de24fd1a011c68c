// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/discharge/hopper_factor.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "reading/angles.h"

namespace rodpack {
namespace {

struct MeanRate {
  double mean = 0, error = 0;
};

MeanRate mean_rate(const std::vector<HopperRate>& runs) {
  const auto n = static_cast<double>(runs.size());
  double sum = 0, own = 0, scatter = 0;
  for (const auto& run : runs) {
    sum += run.rate;
    own += run.rate_error * run.rate_error;
  }
  for (const auto& run : runs) scatter += (run.rate - sum / n) * (run.rate - sum / n);
  const double between = runs.size() > 1 ? scatter / (n - 1) / n : 0;
  return {sum / n, std::sqrt(std::max(own / (n * n), between))};
}

}  // namespace

double rose_tanaka_factor(double half_angle, double flow_angle) {
  if (half_angle + flow_angle >= 90) return 1;
  return std::pow(std::tan(half_angle * degree) * std::tan(flow_angle * degree), -0.35);
}

std::vector<HopperFactor> hopper_factors(const std::vector<HopperRate>& runs) {
  std::map<double, std::map<double, std::vector<HopperRate>>> by_width;
  for (const auto& run : runs) by_width[run.width][run.half_angle].push_back(run);
  std::vector<HopperFactor> factors;
  for (const auto& [width, by_angle] : by_width) {
    const auto flat = by_angle.find(flat_bottom);
    if (flat == by_angle.end()) continue;
    const auto reference = mean_rate(flat->second);
    for (const auto& [half_angle, its_runs] : by_angle) {
      if (half_angle == flat_bottom) continue;
      const auto rate = mean_rate(its_runs);
      const double factor = rate.mean / reference.mean;
      factors.push_back(
          {width, half_angle, its_runs.size(), factor,
           factor * std::hypot(rate.error / rate.mean, reference.error / reference.mean)});
    }
  }
  return factors;
}

}  // namespace rodpack
