// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_STUDY_CLAIMS_SIGNIFICANCE_H
#define RODPACK_STUDY_CLAIMS_SIGNIFICANCE_H

#include <optional>
#include <vector>

#include "ensemble/ensemble.h"

namespace rodpack {

/// Probability that Student's t with `dof` degrees of freedom is larger than `t`.
double student_tail(double t, double dof);

/// Probability that F, a ratio of two mean squares of `above` and `below` degrees of freedom, is
/// larger than `f`.
double f_tail(double f, double above, double below);

/// The number of standard deviations that a normal variable exceeds with `probability`: 0.5 -> 0,
/// 0.0228 -> 2, 0.977 -> -2. Within -37 to 37.
double sigmas_of(double probability);

/// A weighted sum of means, such as a difference or a slope.
struct Contrast {
  double value = 0;
  double error = 0;  // standard error
  double dof = 1;    // degrees of freedom of the error

  /// Significance of the value being above `level`, as the number of standard deviations of a
  /// normal variable that is as unlikely as Student's t; negative below it.
  double sigmas_above(double level = 0) const;
};

struct ContrastTerm {
  double weight;
  EnsembleMean mean;
};

/// Sums means of independent cases. Error: those of the terms, added in squares; degrees of freedom
/// by Welch and Satterthwaite, (sum a)^2 / sum(a^2 / (n - 1)) with a = (weight sem)^2.
/// @return none when a term has no standard error.
std::optional<Contrast> contrast_of(const std::vector<ContrastTerm>& terms);

/// The least-squares slope of the means over `x`, a contrast of weights (x - <x>) / sum (x -
/// <x>)^2.
/// @return none when a mean has no standard error or all x are the same.
std::optional<Contrast> slope_of(const std::vector<double>& x,
                                 const std::vector<EnsembleMean>& means);

}  // namespace rodpack

#endif
