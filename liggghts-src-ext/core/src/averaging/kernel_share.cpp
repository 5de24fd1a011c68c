// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/averaging/kernel_share.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace rodpack {

namespace {

// Lucy's kernel: -d phi / d r = 12 norm q (1 - q)^2 / R with q = r / R, so that the share is, by
// parts, the integral of that times the area of the disc of radius r inside the container.
double lucy_share(const AveragingKernel& kernel, double x, double y, const Rectangle& container) {
  const double R = kernel.cutoff();
  const bool no_wall_in_reach = x - R >= container.left && x + R <= container.right &&
                                y - R >= container.bottom && y + R <= container.top;
  if (no_wall_in_reach) return 1;
  const auto integrand = [&](double r) {
    const double q = r / R;
    return 12 * kernel.norm() * q * (1 - q) * (1 - q) / R * disc_area_inside(container, x, y, r);
  };
  // The area has a kink where the disc meets a side or a corner.
  const std::array<double, 2> across{{container.left - x, container.right - x}};
  const std::array<double, 2> along{{container.bottom - y, container.top - y}};
  std::vector<double> ends{0, R};
  const auto add = [&](double r) {
    if (r > 0 && r < R) ends.push_back(r);
  };
  for (const double a : across) {
    add(std::abs(a));
    for (const double b : along) add(std::hypot(a, b));
  }
  for (const double b : along) add(std::abs(b));
  std::sort(ends.begin(), ends.end());

  // Simpson's rule in t, r = from + (to - from) (3 t^2 - 2 t^3): flat at both ends, which takes the
  // roots at the kinks away.
  constexpr int steps = 256;
  double share = 0;
  for (std::size_t k = 1; k < ends.size(); ++k) {
    const double from = ends[k - 1], length = ends[k] - from;
    double sum = 0;
    for (int i = 1; i < steps; ++i) {  // the weight 6 t (1 - t) vanishes at the ends
      const double t = static_cast<double>(i) / steps;
      sum += (i % 2 ? 4 : 2) * 6 * t * (1 - t) * integrand(from + length * t * t * (3 - 2 * t));
    }
    share += sum * length / (3 * steps);
  }
  return share;
}

}  // namespace

double kernel_share(const AveragingKernel& kernel, double x, double y, const Rectangle& container) {
  if (kernel.dimension() != 2)
    throw std::invalid_argument("kernel of " + std::to_string(kernel.dimension()) +
                                " dimensions: its share inside a container is known for 2");
  switch (kernel.shape()) {
    case KernelShape::heaviside:
      return kernel.norm() * disc_area_inside(container, x, y, kernel.cutoff());
    case KernelShape::lucy:
      return lucy_share(kernel, x, y, container);
    default:
      return gaussian_integral(container.left - x, container.right - x, kernel.scale()) *
             gaussian_integral(container.bottom - y, container.top - y, kernel.scale());
  }
}

void normalise_by_share(const CoarseGraining& averages, const Rectangle& container,
                        std::vector<Field>& fields) {
  const double rounding = 1e-9 * averages.kernel().scale();  // of places on a wall
  const Rectangle inside{container.left - rounding, container.right + rounding,
                         container.bottom - rounding, container.top + rounding};
  const auto is_ratio = [](const std::string& name) {
    return name == "velocity" || name == "coordination_number" || name == "contacts_per_particle";
  };
  for (std::size_t i = 0; i < averages.places(); ++i) {
    const Vector place = averages.place(i);
    const bool within = inside.contains(place[0], place[1]);
    const double share = kernel_share(averages.kernel(), place[0], place[1], container);
    for (Field& field : fields)
      for (auto& values : field.values)
        if (!within)
          values[i] = 0;
        else if (!is_ratio(field.name))
          values[i] /= share;
  }
}

}  // namespace rodpack
