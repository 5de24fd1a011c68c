// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/discharge/beverloo_fit.h"

#include <cmath>
#include <set>
#include <string>

#include "analysis/line_fit.h"
#include "reading/dump.h"

namespace rodpack {
namespace {

std::vector<double> logarithms(const std::vector<double>& values, double less) {
  std::vector<double> result;
  for (const double each : values) result.push_back(std::log(each - less));
  return result;
}

// The exponent and its standard error with k free. By Frisch and Waugh the variance of one
// parameter of a linear model is that of the residuals over the squares of its own column after
// the others, here 1 and the derivative by k, -n / (x - k), have been fitted out of it.
void fit_exponent(const std::vector<double>& width, const std::vector<double>& rate, double top,
                  BeverlooFit& fit) {
  const auto y = logarithms(rate, 0);
  const auto line_at = [&](double k) { return fit_line(logarithms(width, k), y); };
  constexpr int grid = 400;
  double best = 0, step = top / grid;
  for (int i = 1; i < grid; ++i)
    if (line_at(i * step).residual < line_at(best).residual) best = i * step;
  constexpr int halvings = 32;
  for (int i = 0; i < halvings; ++i, step /= 2)
    for (const double k : {best - step, best + step})
      if (k >= 0 && k < top && line_at(k).residual < line_at(best).residual) best = k;
  const auto column = logarithms(width, best);
  std::vector<double> by_k;
  for (const double x : width) by_k.push_back(1 / (x - best));
  const double own = fit_line(by_k, column).residual;
  const LineFit line = fit_line(column, y);
  fit.exponent = line.b;
  fit.exponent_error = std::sqrt(line.residual / (static_cast<double>(width.size()) - 3) / own);
}

}  // namespace

BeverlooFit fit_beverloo(const std::vector<double>& width, const std::vector<double>& rate,
                         int dimension) {
  const double law = beverloo_exponent(dimension);
  const std::set<double> widths(width.begin(), width.end());
  if (widths.size() < 3)
    throw TooFewParticles("Beverloo's law: " + std::to_string(widths.size()) +
                          " widths with a steady flow, expected at least 3");
  std::vector<double> root;
  for (const double each : rate) root.push_back(std::pow(each, 1 / law));
  const LineFit line = fit_line(width, root);
  if (!(line.b > 0))
    throw TooFewParticles("Beverloo's law: expected rates that rise with the width of the orifice");
  const auto n = static_cast<double>(width.size());
  const double variance = line.residual / (n - 2);
  BeverlooFit fit;
  fit.law = law;
  fit.c = std::pow(line.b, law);
  fit.c_error = law * std::pow(line.b, law - 1) * std::sqrt(variance / line.sxx);
  // The line's zero k = mean x - mean y / b, whose two parts have independent errors.
  fit.k = -line.a / line.b;
  const double arm = line.mean_x - fit.k;
  fit.k_error = std::sqrt(variance * (1 / n + arm * arm / line.sxx)) / line.b;
  if (widths.size() >= 4) fit_exponent(width, rate, *widths.begin(), fit);
  return fit;
}

}  // namespace rodpack
