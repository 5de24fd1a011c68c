// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/long_axis.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "reading/angles.h"
#include "reading/checks/body_axes.h"

namespace rodpack {

std::vector<double> long_axis_degrees(const std::vector<double>& body, const std::vector<double>& x,
                                      const std::vector<double>& y, double period) {
  struct Moments {
    double x0, y0;  // the first sphere of the body, to unwrap the others
    double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  };
  std::map<double, Moments> bodies;
  for (std::size_t i = 0; i < body.size(); ++i) {
    auto& m = bodies.try_emplace(body[i], Moments{x[i], y[i]}).first->second;
    double dx = x[i] - m.x0;
    if (period > 0) dx -= period * std::round(dx / period);
    const double dy = y[i] - m.y0;
    m.n += 1;
    m.x += dx;
    m.y += dy;
    m.xx += dx * dx;
    m.xy += dx * dy;
    m.yy += dy * dy;
  }
  std::vector<double> result;
  for (const double id : body) {
    const auto& m = bodies.at(id);
    if (m.n < 2) {
      result.push_back(std::numeric_limits<double>::quiet_NaN());
      continue;
    }
    const double xx = m.xx - m.x * m.x / m.n;
    const double xy = m.xy - m.x * m.y / m.n;
    const double yy = m.yy - m.y * m.y / m.n;
    const double angle = 0.5 * std::atan2(2 * xy, xx - yy) / degree;
    result.push_back(angle < 0 ? angle + 180 : angle);
  }
  return result;
}

namespace {

// From one sphere to another of the same body, which a periodic side may part.
Vector3 between(const Frame& spheres, const VectorColumns& place, std::size_t from,
                std::size_t to) {
  Vector3 way{};
  for (std::size_t c = 0; c < 3; ++c) {
    way[c] = (*place[c])[to] - (*place[c])[from];
    const double period = spheres.bounds[c][1] - spheres.bounds[c][0];
    if (spheres.periodic[c]) way[c] -= period * std::round(way[c] / period);
  }
  return way;
}

}  // namespace

std::vector<double> degrees_to_axis(const Frame& spheres, std::size_t axis) {
  const auto place = vector_columns(spheres, {"x", "y", "z"});
  std::map<double, std::vector<std::size_t>> bodies;
  for (std::size_t i = 0; i < spheres.rows; ++i) bodies[spheres.column("body")[i]].push_back(i);
  std::vector<double> result(spheres.rows, std::numeric_limits<double>::quiet_NaN());
  for (const auto& [body, rows] : bodies) {
    double longest = 0, angle = 0;
    for (const auto a : rows)
      for (const auto b : rows) {
        const auto way = between(spheres, place, a, b);
        const double length = std::hypot(way[0], way[1], way[2]);
        if (length <= longest) continue;
        longest = length;
        angle = std::acos(std::min(1.0, std::abs(way[axis]) / length)) / degree;
      }
    if (longest > 0)
      for (const auto row : rows) result[row] = angle;
  }
  return result;
}

}  // namespace rodpack
