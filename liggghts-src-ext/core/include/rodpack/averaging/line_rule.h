// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_AVERAGING_LINE_RULE_H
#define RODPACK_AVERAGING_LINE_RULE_H

#include <string>
#include <vector>

#include "averaging_kernel.h"

namespace rodpack {

/// How the integral of the kernel along a branch vector is taken.
///  - exact: closed form at every place, an error function or two each;
///  - 1 to 4: so many Gauss-Legendre points, each a source of its own, for which products of
///    one-dimensional tables do;
///  - automatic: for the Gaussian the fewest points, and pieces of the branch, whose error is below
///    `tolerance` of the kernel's maximum for every position; exact for the other kernels, which
///    are not smooth.
struct LineRule {
  static constexpr int exact = 0;
  static constexpr int automatic = -1;

  int points = automatic;
  double tolerance = 1e-5;

  /// "auto", "exact", "1" ... "4"; `tolerance` is that of the fields. One branch may err ten times
  /// as much: its error is a derivative of the kernel, and those of many branches cancel (measured
  /// in doc/background/coarse_graining_accuracy.md). @throws std::invalid_argument for another
  /// name.
  static LineRule named(const std::string& name, double tolerance);
};

struct LineNode {
  double s;       // position along the branch, 0 to 1
  double weight;  // adds up to 1
};

/// Bound of the error of n = 1 ... 4 Gauss-Legendre points for a Gaussian and a branch of `length`
/// scales w, in units of the kernel's maximum:
/// length^2n (n!)^4 (2n - 1)!! / ((2n + 1) ((2n)!)^3).
double gauss_legendre_error(int points, double length);

/// Nodes for a branch of `length` in units of the kernel's scale; empty: use the closed form.
/// `degree` of the polynomial in s that stands beside the kernel, 0 or 1: an automatic rule takes
/// so many points more.
std::vector<LineNode> line_nodes(const LineRule& rule, KernelShape shape, double length,
                                 int degree = 0);

}  // namespace rodpack

#endif
