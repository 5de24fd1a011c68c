// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_LINE_FIT_H
#define RODPACK_ANALYSIS_LINE_FIT_H

#include <numeric>
#include <vector>

namespace rodpack {

/// The straight line y = a + b x of least squares.
struct LineFit {
  double a, b;
  double mean_x, sxx;  // mean of x, sum of squares about it
  double residual;     // sum of squares of y less the line
};

/// Fits points of at least two different x.
inline LineFit fit_line(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<double>(x.size());
  const double mx = std::accumulate(x.begin(), x.end(), 0.0) / n;
  const double my = std::accumulate(y.begin(), y.end(), 0.0) / n;
  double sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sxx += (x[i] - mx) * (x[i] - mx);
    sxy += (x[i] - mx) * (y[i] - my);
  }
  LineFit line{my - sxy / sxx * mx, sxy / sxx, mx, sxx, 0};
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double off = y[i] - line.a - line.b * x[i];
    line.residual += off * off;
  }
  return line;
}

}  // namespace rodpack

#endif
