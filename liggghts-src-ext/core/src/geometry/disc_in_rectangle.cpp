// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/geometry/disc_in_rectangle.h"

#include <algorithm>
#include <cmath>

namespace rodpack {

double quarter_disc_area(double r, double a, double b) {
  if (a <= 0 || b <= 0) return 0;
  if (a * a + b * b <= r * r) return a * b;
  a = std::min(a, r);
  b = std::min(b, r);
  // Flat part b up to where the circle comes below it, then the integral of sqrt(r^2 - x^2).
  const double start = std::sqrt((r - b) * (r + b));
  const auto primitive = [r](double x) {
    return 0.5 * (x * std::sqrt((r - x) * (r + x)) + r * r * std::asin(x / r));
  };
  return b * start + primitive(a) - primitive(start);
}

double disc_area_inside(const Rectangle& box, double x, double y, double r) {
  const auto signed_quarter = [r](double a, double b) {
    return std::copysign(1.0, a) * std::copysign(1.0, b) *
           quarter_disc_area(r, std::abs(a), std::abs(b));
  };
  const double left = box.left - x, right = box.right - x;
  const double bottom = box.bottom - y, top = box.top - y;
  return signed_quarter(right, top) - signed_quarter(left, top) - signed_quarter(right, bottom) +
         signed_quarter(left, bottom);
}

}  // namespace rodpack
