// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_SPACE_ORDER_TENSOR_H
#define RODPACK_ANALYSIS_SPACE_ORDER_TENSOR_H

#include <array>
#include <cstddef>
#include <vector>

#include "reading/checks/body_axes.h"

namespace rodpack {

/// Principal values and directions of the order tensor S = 3/2 (<u u> - 1/3) of axes u without head
/// or tail: rods, or normals of contacts. Largest value first; they add up to 0. Isotropic: all 0;
/// all parallel: 1, -1/2, -1/2; all in one plane and even there: 1/4, 1/4, -1/2.
struct OrderTensor {
  std::size_t number = 0;                  // of axes
  std::array<double, 3> value{};           // the first one is S2
  std::array<double, 3> standard_error{};  // of the values, by the jackknife over the axes
  std::array<Vector3, 3> direction{};      // unit vectors; the first one is the director
  double order_without_bias = 0;           // S2 less its bias of order 1 / number, by the jackknife
  double director_standard_error = 0;      // root mean square angle, degrees, by the jackknife
};

/// Takes the mean over unit vectors, which the jackknife takes as independent.
/// @throws TooFewParticles when there are fewer than 2.
OrderTensor order_tensor(const std::vector<Vector3>& axes);

/// Order about a coordinate axis, 0 to 2: <3 cos^2 - 1> / 2 of the angle to it. 1: all along it, 0:
/// isotropic, -1/2: all across it.
struct OrderAbout {
  double value;
  double standard_error;  // of the mean, directions taken as independent
};
/// @throws TooFewParticles when there are fewer than 2 axes.
OrderAbout order_about(const std::vector<Vector3>& axes, std::size_t axis);

/// S2 of a number of axes is never 0, even if their directions are chosen at random: its mean and
/// its standard deviation then, for many axes. The five components of S in an orthonormal basis of
/// traceless tensors are then independent and Gaussian, each of variance 3 / (10 number), which
/// gives the mean 9/4 sqrt(2 / (5 pi number)) and, for that of S2^2, 29 / (40 number).
struct IsotropicOrder {
  double mean, deviation;
};
IsotropicOrder isotropic_order(std::size_t number);

}  // namespace rodpack

#endif
