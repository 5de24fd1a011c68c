// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/averaging/kernel_share.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "rodpack/geometry/pi.h"

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

// Share in a disc of a Gaussian of two dimensions about a place `off` its middle: with x = R sin t
// the sum over the disc's strips, each an error function long.
double share_in_disc(double radius, double off, double scale) {
  const int steps = std::max(64, static_cast<int>(std::ceil(16 * radius / scale)));
  double sum = 0;
  for (int k = 0; k < steps; ++k) {
    const double t = 2 * pi * (k + 0.5) / steps;
    const double half = radius * std::cos(t);
    sum += gaussian(radius * std::sin(t) - off, scale) * half *
           std::erf(half / (scale * std::sqrt(2.0)));
  }
  return sum * pi / steps;  // half of the circle
}

// Divides by `share_at` of each place; all is 0 where it is negative.
template <class Share>
void divide_by(const CoarseGraining& averages, const Share& share_at, std::vector<Field>& fields) {
  const auto is_ratio = [](const std::string& name) {
    return name == "velocity" || name == "coordination_number" || name == "contacts_per_particle";
  };
  for (std::size_t i = 0; i < averages.places(); ++i) {
    const double share = share_at(averages.place(i));
    for (Field& field : fields)
      for (auto& values : field.values)
        if (share < 0)
          values[i] = 0;
        else if (!is_ratio(field.name))
          values[i] /= share;
  }
}

constexpr double outside = -1;

// How far a place on a wall may lie beyond it by rounding, m.
double rounding_of(const CoarseGraining& averages) { return 1e-9 * averages.kernel().scale(); }

}  // namespace

double kernel_share(const AveragingKernel& kernel, const Vector& place,
                    const UprightContainer& container) {
  if (kernel.dimension() != 3 || kernel.shape() != KernelShape::gaussian)
    throw std::invalid_argument(
        "share of a kernel inside a container in space: expected a gaussian of 3 dimensions");
  const double w = kernel.scale();
  const auto along = [&](std::size_t axis) {
    return gaussian_integral(container.low[axis] - place[axis], container.high[axis] - place[axis],
                             w);
  };
  const auto up = container.vertical, first = container.horizontal(0),
             second = container.horizontal(1);
  if (!container.round) return along(up) * along(first) * along(second);
  const double off =
      std::hypot(place[first] - container.middle[0], place[second] - container.middle[1]);
  return along(up) * share_in_disc(container.radius, off, w);
}

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
  const double rounding = rounding_of(averages);
  const Rectangle inside{container.left - rounding, container.right + rounding,
                         container.bottom - rounding, container.top + rounding};
  divide_by(
      averages,
      [&](const Vector& place) {
        return inside.contains(place[0], place[1])
                   ? kernel_share(averages.kernel(), place[0], place[1], container)
                   : outside;
      },
      fields);
}

void normalise_by_share(const CoarseGraining& averages, const UprightContainer& container,
                        std::vector<Field>& fields) {
  divide_by(
      averages,
      [&](const Vector& place) {
        return container.contains(place, rounding_of(averages))
                   ? kernel_share(averages.kernel(), place, container)
                   : outside;
      },
      fields);
}

}  // namespace rodpack
