// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/averaging/line_rule.h"

#include <cmath>
#include <stdexcept>

namespace rodpack {

namespace {

constexpr int most_points = 4;

// Abramowitz and Stegun, table 25.4, on [0, 1]
std::vector<LineNode> gauss_legendre(int points) {
  switch (points) {
    case 1:
      return {{0.5, 1.0}};
    case 2: {
      const double x = 0.5 * std::sqrt(1.0 / 3);
      return {{0.5 - x, 0.5}, {0.5 + x, 0.5}};
    }
    case 3: {
      const double x = 0.5 * std::sqrt(3.0 / 5);
      return {{0.5 - x, 5.0 / 18}, {0.5, 8.0 / 18}, {0.5 + x, 5.0 / 18}};
    }
    default: {
      const double root = 2 * std::sqrt(6.0 / 5);
      const double inner = 0.5 * std::sqrt((3 - root) / 7), outer = 0.5 * std::sqrt((3 + root) / 7);
      const double heavy = (18 + std::sqrt(30.0)) / 72, light = (18 - std::sqrt(30.0)) / 72;
      return {
          {0.5 - outer, light}, {0.5 - inner, heavy}, {0.5 + inner, heavy}, {0.5 + outer, light}};
    }
  }
}

}  // namespace

LineRule LineRule::named(const std::string& name, double tolerance) {
  if (!(tolerance > 0 && tolerance < 1))
    throw std::invalid_argument("tolerance is " + std::to_string(tolerance) +
                                ", expected a number between 0 and 1");
  LineRule rule;
  rule.tolerance = 10 * tolerance;
  if (name == "auto") return rule;
  if (name == "exact")
    rule.points = exact;
  else if (name.size() == 1 && name[0] >= '1' && name[0] <= '0' + most_points)
    rule.points = name[0] - '0';
  else
    throw std::invalid_argument("line is '" + name + "', expected auto, exact, 1, 2, 3 or 4");
  return rule;
}

double gauss_legendre_error(int points, double length) {
  double factorial_n = 1, factorial_2n = 1, odd_product = 1;
  for (int k = 1; k <= 2 * points; ++k) {
    factorial_2n *= k;
    if (k <= points) factorial_n *= k;
    if (k % 2 == 1) odd_product *= k;
  }
  return std::pow(length, 2 * points) * std::pow(factorial_n, 4) * odd_product /
         ((2 * points + 1) * std::pow(factorial_2n, 3));
}

std::vector<LineNode> line_nodes(const LineRule& rule, KernelShape shape, double length,
                                 int degree) {
  if (rule.points > 0) return gauss_legendre(rule.points);
  if (rule.points == LineRule::exact || shape != KernelShape::gaussian) return {};
  for (int points = 1; points + degree <= most_points; ++points)
    if (gauss_legendre_error(points, length) <= rule.tolerance)
      return gauss_legendre(points + degree);
  // Pieces that are short enough for the most points.
  const int points = most_points - degree;
  const double longest = std::pow(rule.tolerance / gauss_legendre_error(points, 1), 0.5 / points);
  const int pieces = static_cast<int>(std::ceil(length / longest));
  std::vector<LineNode> nodes;
  for (int piece = 0; piece < pieces; ++piece)
    for (const LineNode& node : gauss_legendre(most_points))
      nodes.push_back({(piece + node.s) / pieces, node.weight / pieces});
  return nodes;
}

}  // namespace rodpack
