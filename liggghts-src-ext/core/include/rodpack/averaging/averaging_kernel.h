// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_AVERAGING_AVERAGING_KERNEL_H
#define RODPACK_AVERAGING_AVERAGING_KERNEL_H

#include <cmath>
#include <string>

namespace rodpack {

// Kernels of the spatial averaging, "coarse graining" as Goldhirsch (Granular Matter 12, 239, 2010)
// uses the word; not the parcel scaling of LIGGGHTS.

enum class KernelShape { gaussian, lucy, heaviside };

/// "gaussian", "lucy", "heaviside". @throws std::invalid_argument for another name.
KernelShape kernel_shape(const std::string& name);

/// A kernel along the line between two points: integrals over s from 0 to 1.
struct LineIntegral {
  double mean;    // of phi, 1/m^D
  double moment;  // of s phi, 1/m^D
};

/// Radial function phi >= 0 of D = 2 or 3 dimensions with integral 1, zero beyond `cutoff()`.
/// `scale` w is its standard deviation along each axis (before the cut-off), so that the three
/// shapes smooth alike at the same w: a Gaussian, exp(-r^2 / 2 w^2) / (2 pi w^2)^(D/2); Lucy's
/// (1 + 3 q)(1 - q)^3 of q = r / R; a Heaviside step at R (a disc, a ball).
class AveragingKernel {
 public:
  /// `cutoff` in units of w, for the Gaussian only: the two others end at their own R.
  /// @throws std::invalid_argument for another dimension, scale <= 0 or cutoff <= 0.
  AveragingKernel(KernelShape shape, int dimension, double scale, double cutoff = 5.3);

  KernelShape shape() const { return shape_; }
  int dimension() const { return dimension_; }
  double scale() const { return scale_; }    // m
  double cutoff() const { return cutoff_; }  // m

  /// phi at a distance whose square is given, m^2; 1/m^D.
  double operator()(double squared_distance) const;

  /// Integrals over the segment a + s branch, 0 <= s <= 1, seen from a place `from_a` off its
  /// start; D components each, m. Closed form for all shapes, the cut-off included.
  LineIntegral along(const double* from_a, const double* branch) const;

  /// The Gaussian's factor exp(-d^2 / 2 w^2) along one axis; times norm() it makes up phi.
  double axis_factor(double distance) const {
    return std::exp(-0.5 * distance * distance / (scale_ * scale_));
  }
  double norm() const { return norm_; }  // phi at the centre, 1/m^D

 private:
  KernelShape shape_;
  int dimension_;
  double scale_, cutoff_, norm_;
};

/// Cut-off radius of a Gaussian, in units of w, beyond which it holds the share `tolerance`
/// (in (0, 1)) of its integral over D dimensions.
double gaussian_cutoff(double tolerance, int dimension);

/// One-dimensional Gaussian of standard deviation `scale` (m) at `distance` (m); 1/m.
inline double gaussian(double distance, double scale) {
  const double t = distance / scale;
  return std::exp(-0.5 * t * t) / (scale * 2.5066282746310002);
}

/// Integral of gaussian() over distances from `from` to `to`; no unit.
inline double gaussian_integral(double from, double to, double scale) {
  const double root = scale * 1.4142135623730951;
  return 0.5 * (std::erf(to / root) - std::erf(from / root));
}

/// Mean of gaussian() along a branch that begins `from` below the place and rises by `rise`, m;
/// 1/m.
inline double gaussian_along(double from, double rise, double scale) {
  // The midpoint serves a level branch, to 1e-13 of the Gaussian.
  if (std::abs(rise) < 1e-6 * scale) return gaussian(from - rise / 2, scale);
  return gaussian_integral(from - rise, from, scale) / rise;
}

}  // namespace rodpack

#endif
