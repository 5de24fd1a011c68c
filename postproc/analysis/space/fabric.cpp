// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/space/fabric.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rodpack {

Fabric measure_fabric(const std::vector<Vector3>& normals, const std::vector<double>& forces,
                      std::size_t vertical, std::size_t bins) {
  Fabric fabric;
  fabric.vertical = vertical;
  fabric.order = order_tensor(normals);
  fabric.about_vertical = order_about(normals, vertical);
  fabric.polar = polar_histogram(normals, vertical, bins);
  const double mean =
      std::accumulate(forces.begin(), forces.end(), 0.0) / static_cast<double>(forces.size());
  const auto& count = fabric.polar.count;
  fabric.force.assign(bins, 0);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const auto k = polar_bin(normals[i], vertical, bins);
    fabric.force[k] += forces[i] / mean / count[k];
  }
  std::vector<double> square(bins, 0);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const auto k = polar_bin(normals[i], vertical, bins);
    square[k] += std::pow(forces[i] / mean - fabric.force[k], 2);
  }
  for (std::size_t k = 0; k < bins; ++k)
    fabric.force_standard_error.push_back(
        count[k] > 1 ? std::sqrt(square[k] / (count[k] * (count[k] - 1))) : 0);
  return fabric;
}

void write_fabric_table(const Fabric& fabric, const std::string& file) {
  write_direction_table(fabric.polar, "polar", file,
                        {{"normal_force_over_mean", fabric.force},
                         {"its_standard_error", fabric.force_standard_error}});
}

}  // namespace rodpack
