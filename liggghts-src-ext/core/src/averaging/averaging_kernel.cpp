// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/averaging/averaging_kernel.h"

#include <algorithm>
#include <stdexcept>

#include "rodpack/geometry/pi.h"

namespace rodpack {

namespace {

const double root_half_pi = std::sqrt(pi / 2);

// Share of a Gaussian's integral within c standard deviations of its centre.
double share_within(double c, int dimension) {
  if (dimension == 2) return -std::expm1(-0.5 * c * c);
  return std::erf(c / std::sqrt(2.0)) - c / root_half_pi * std::exp(-0.5 * c * c);
}

// Integral of (p^2 + t^2)^(3/2) from 0 to t.
double cubed_distance_integral(double p, double t) {
  const double r = std::sqrt(p * p + t * t);
  const double tail = p > 0 ? 0.375 * p * p * p * p * std::asinh(t / p) : 0;
  return 0.125 * t * (2 * t * t + 5 * p * p) * r + tail;
}

/// Integrals of phi dt and of t phi dt over t from `from` to `to` (m), where t runs along a line
/// from the foot of the perpendicular from the kernel's centre, whose length squared is
/// `p_squared`.
struct AxisIntegrals {
  double zeroth, first;
};
AxisIntegrals along_axis(const AveragingKernel& kernel, double p_squared, double from, double to) {
  AxisIntegrals result = {0, 0};
  const double norm = kernel.norm();
  switch (kernel.shape()) {
    case KernelShape::gaussian: {
      const double w = kernel.scale();
      const double across = norm * std::exp(-0.5 * p_squared / (w * w));
      const auto at = [w](double t) { return std::exp(-0.5 * t * t / (w * w)); };
      result.zeroth = across * w * root_half_pi *
                      (std::erf(to / (w * std::sqrt(2.0))) - std::erf(from / (w * std::sqrt(2.0))));
      result.first = across * w * w * (at(from) - at(to));
      break;
    }
    case KernelShape::heaviside:
      result.zeroth = norm * (to - from);
      result.first = norm * 0.5 * (to * to - from * from);
      break;
    case KernelShape::lucy: {  // phi / norm = 1 - 6 q^2 + 8 q^3 - 3 q^4
      const double R = kernel.cutoff();
      const double p = std::sqrt(p_squared);
      const auto zeroth_to = [&](double t) {
        const double t3 = t * t * t;
        return t - 6 * (p_squared * t + t3 / 3) / (R * R) +
               8 * cubed_distance_integral(p, t) / (R * R * R) -
               3 * (p_squared * p_squared * t + 2 * p_squared * t3 / 3 + t3 * t * t / 5) /
                   (R * R * R * R);
      };
      const auto first_to = [&](double t) {  // t dt = r dr
        const double r = std::sqrt(p_squared + t * t);
        const double q = r / R;
        return r * r * (0.5 - 1.5 * q * q + 1.6 * q * q * q - 0.5 * q * q * q * q);
      };
      result.zeroth = norm * (zeroth_to(to) - zeroth_to(from));
      result.first = norm * (first_to(to) - first_to(from));
      break;
    }
  }
  return result;
}

}  // namespace

KernelShape kernel_shape(const std::string& name) {
  if (name == "gaussian") return KernelShape::gaussian;
  if (name == "lucy") return KernelShape::lucy;
  if (name == "heaviside") return KernelShape::heaviside;
  throw std::invalid_argument("kernel is '" + name + "', expected gaussian, lucy or heaviside");
}

AveragingKernel::AveragingKernel(KernelShape shape, int dimension, double scale, double cutoff)
    : shape_(shape), dimension_(dimension), scale_(scale) {
  if (dimension != 2 && dimension != 3)
    throw std::invalid_argument("dimension is " + std::to_string(dimension) + ", expected 2 or 3");
  if (!(scale > 0) || !std::isfinite(scale))
    throw std::invalid_argument("scale is " + std::to_string(scale) + " m, expected a length > 0");
  if (!(cutoff > 0) || !std::isfinite(cutoff))
    throw std::invalid_argument("cutoff is " + std::to_string(cutoff) + " scales, expected > 0");
  const bool planar = dimension == 2;
  // R from the variance along an axis: disc R^2/4, ball R^2/5; Lucy 5 R^2/56, R^2/12.
  switch (shape) {
    case KernelShape::gaussian:
      cutoff_ = cutoff * scale;
      norm_ =
          1 / (std::pow(2 * pi * scale * scale, 0.5 * dimension) * share_within(cutoff, dimension));
      break;
    case KernelShape::lucy:
      cutoff_ = scale * std::sqrt(planar ? 56.0 / 5 : 12.0);
      norm_ = planar ? 5 / (pi * cutoff_ * cutoff_) : 105 / (16 * pi * std::pow(cutoff_, 3));
      break;
    case KernelShape::heaviside:
      cutoff_ = scale * std::sqrt(planar ? 4.0 : 5.0);
      norm_ = planar ? 1 / (pi * cutoff_ * cutoff_) : 3 / (4 * pi * std::pow(cutoff_, 3));
      break;
  }
}

double AveragingKernel::operator()(double squared_distance) const {
  if (squared_distance > cutoff_ * cutoff_) return 0;
  if (shape_ == KernelShape::gaussian)
    return norm_ * std::exp(-0.5 * squared_distance / (scale_ * scale_));
  if (shape_ == KernelShape::heaviside) return norm_;
  const double q = std::sqrt(squared_distance) / cutoff_;
  return norm_ * (1 + 3 * q) * (1 - q) * (1 - q) * (1 - q);
}

LineIntegral AveragingKernel::along(const double* from_a, const double* branch) const {
  double squared = 0, length_squared = 0, projection = 0;
  for (int d = 0; d < dimension_; ++d) {
    squared += from_a[d] * from_a[d];
    length_squared += branch[d] * branch[d];
    projection += from_a[d] * branch[d];
  }
  const double length = std::sqrt(length_squared);
  if (length < 1e-7 * scale_) {  // shorter than the closed forms can resolve
    const double value = (*this)(squared);
    return {value, 0.5 * value};
  }
  // t: along the line, from the foot of the perpendicular, whose length is p.
  const double foot = projection / length;
  double p_squared = 0;  // by components: squared - foot^2 would cancel far from the start
  for (int d = 0; d < dimension_; ++d) {
    const double across = from_a[d] - projection / length_squared * branch[d];
    p_squared += across * across;
  }
  const double reach_squared = cutoff_ * cutoff_ - p_squared;
  if (reach_squared <= 0) return {0, 0};
  const double reach = std::sqrt(reach_squared);
  const double from = std::max(-foot, -reach);
  const double to = std::min(length - foot, reach);
  if (to <= from) return {0, 0};

  const AxisIntegrals integrals = along_axis(*this, p_squared, from, to);
  return {integrals.zeroth / length, (integrals.first + foot * integrals.zeroth) / length_squared};
}

double gaussian_cutoff(double tolerance, int dimension) {
  if (!(tolerance > 0 && tolerance < 1))
    throw std::invalid_argument("tolerance is " + std::to_string(tolerance) +
                                ", expected a share between 0 and 1");
  if (dimension == 2) return std::sqrt(-2 * std::log(tolerance));
  double low = 0, high = 40;  // bisection: the share beyond falls with the radius
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (low + high);
    // By erfc, not 1 - erf: the share is far below the rounding error of 1.
    const double beyond = std::erfc(middle / std::sqrt(2.0)) +
                          middle / root_half_pi * std::exp(-0.5 * middle * middle);
    (beyond > tolerance ? low : high) = middle;
  }
  return high;
}

}  // namespace rodpack
