// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/voids.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace rodpack {
namespace {

// Points (i + 1/2, j + 1/2) step from the lower left corner of the container.
struct Raster {
  double left, floor, step;
  long columns, rows;

  Raster(const Walls& walls, const VoidSearch& search)
      : left(walls.left),
        floor(walls.floor),
        step(search.step),
        columns(std::lround(walls.width() / search.step)),
        rows(std::lround((search.surface - walls.floor) / search.step)) {}

  double x(long i) const { return left + (static_cast<double>(i) + 0.5) * step; }
  double y(long j) const { return floor + (static_cast<double>(j) + 0.5) * step; }
  std::size_t at(long i, long j) const { return static_cast<std::size_t>(j * columns + i); }
  bool holds(long i, long j) const { return i >= 0 && i < columns && j >= 0 && j < rows; }

  // Sets the points closer than `radius` to (px, py).
  void paint(std::vector<char>& points, double px, double py, double radius, char value) const {
    const auto first = [this](double low, double origin) {
      return static_cast<long>(std::ceil((low - origin) / step - 0.5));
    };
    const long low = std::max(0L, first(py - radius, floor));
    for (long j = low; j < rows && y(j) < py + radius; ++j) {
      const double dy = y(j) - py;
      const double half = std::sqrt(std::max(0.0, radius * radius - dy * dy));
      for (long i = std::max(0L, first(px - half, left)); i < columns && x(i) < px + half; ++i)
        points[at(i, j)] = value;
    }
  }
};

// Half a step less than the probe's: its centre stands on the raster, which costs as much on
// average.
double probe_radius(const VoidSearch& search) {
  return 0.5 * search.probe - (0.5 + 1e-9) * search.step;
}

// Where the centre of the probe may be.
std::vector<char> room_for_probe(const Raster& raster, const Frame& spheres, const Walls& walls,
                                 const VoidSearch& search) {
  const double half = probe_radius(search);
  std::vector<char> room(static_cast<std::size_t>(raster.columns * raster.rows), 0);
  for (long j = 0; j < raster.rows; ++j)
    for (long i = 0; i < raster.columns; ++i)
      room[raster.at(i, j)] =
          raster.x(i) >= walls.left + half && raster.x(i) <= walls.right - half &&
          raster.y(j) >= walls.floor + half && raster.y(j) <= search.surface - half;
  const auto &x = spheres.column("x"), &y = spheres.column("y"), &radius = spheres.column("radius");
  for (std::size_t k = 0; k < spheres.rows; ++k)
    raster.paint(room, x[k], y[k], radius[k] + half, 0);
  return room;
}

// What the probe covers. Only from the edge of its room does it reach beyond that room.
std::vector<char> covered_by_probe(const Raster& raster, const std::vector<char>& room,
                                   const VoidSearch& search) {
  std::vector<char> covered = room;
  for (long j = 0; j < raster.rows; ++j)
    for (long i = 0; i < raster.columns; ++i) {
      if (!room[raster.at(i, j)]) continue;
      bool edge = false;
      for (const auto& [a, b] : {std::pair{i - 1, j}, {i + 1, j}, {i, j - 1}, {i, j + 1}})
        edge = edge || !raster.holds(a, b) || !room[raster.at(a, b)];
      if (edge) raster.paint(covered, raster.x(i), raster.y(j), probe_radius(search), 1);
    }
  return covered;
}

// Takes the region connected to a point out of `covered`.
Void take_region(const Raster& raster, std::vector<char>& covered, long i, long j) {
  Void region;
  std::map<long, std::vector<long>> columns_of_row;
  std::vector<std::pair<long, long>> open{{i, j}};
  covered[raster.at(i, j)] = 0;
  double points = 0;
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    columns_of_row[b].push_back(a);
    region.x += raster.x(a);
    region.y += raster.y(b);
    ++points;
    for (const auto& [c, d] : {std::pair{a - 1, b}, {a + 1, b}, {a, b - 1}, {a, b + 1}})
      if (raster.holds(c, d) && covered[raster.at(c, d)]) {
        covered[raster.at(c, d)] = 0;
        open.emplace_back(c, d);
      }
  }
  region.x /= points;
  region.y /= points;
  region.area = points * raster.step * raster.step;
  for (auto& [row, columns] : columns_of_row) {
    std::sort(columns.begin(), columns.end());
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const bool begins = k == 0 || columns[k] != columns[k - 1] + 1;
      if (begins) region.rows.push_back({raster.y(row), raster.x(columns[k]) - raster.step / 2, 0});
      region.rows.back().x_high = raster.x(columns[k]) + raster.step / 2;
    }
  }
  return region;
}

// Distance from its centre beyond which a void has no part.
double reach_of(const Void& region) {
  double reach = 0;
  for (const auto& row : region.rows)
    for (const double x : {row.x_low, row.x_high})
      reach = std::max(reach, std::hypot(x - region.x, row.y - region.y));
  return reach;
}

// The circular arc of a curved particle's sphere centres.
struct Arc {
  double x, y;        // centre of curvature, m
  double radius;      // m
  double ux, uy;      // unit vector from there to the middle of the arc
  double chord;       // distance of the chord from the centre of curvature, m
  double half_width;  // of a sphere, m

  bool hollow_holds(double px, double py) const {
    const double dx = px - x, dy = py - y;
    const double distance = std::hypot(dx, dy), along = dx * ux + dy * uy;
    return distance < radius - half_width && along >= chord - half_width &&
           along >= distance * chord / radius;
  }

  // Whether more than half of a void's area lies there.
  bool hollow_holds_most_of(const Void& region, double step) const {
    long inside = 0, all = 0;
    for (const auto& row : region.rows)
      for (long k = 0; k < std::lround((row.x_high - row.x_low) / step); ++k, ++all)
        inside += hollow_holds(row.x_low + (static_cast<double>(k) + 0.5) * step, row.y) ? 1 : 0;
    return 2 * inside > all;
  }
};

// Circle through three sphere centres: both ends and the one furthest from their chord.
bool arc_of(const std::vector<std::array<double, 3>>& spheres, Arc& arc) {
  std::size_t a = 0, b = 0, c = 0;
  double longest = 0, furthest = 0;
  for (std::size_t i = 0; i < spheres.size(); ++i)
    for (std::size_t j = i + 1; j < spheres.size(); ++j) {
      const double length =
          std::hypot(spheres[j][0] - spheres[i][0], spheres[j][1] - spheres[i][1]);
      if (length > longest) longest = length, a = i, b = j;
    }
  if (!(longest > 0)) return false;
  const auto side = [&](std::size_t k) {
    return ((spheres[b][0] - spheres[a][0]) * (spheres[k][1] - spheres[a][1]) -
            (spheres[b][1] - spheres[a][1]) * (spheres[k][0] - spheres[a][0])) /
           longest;
  };
  for (std::size_t k = 0; k < spheres.size(); ++k)
    if (std::fabs(side(k)) > std::fabs(furthest)) furthest = side(c = k);
  const double sagitta = std::fabs(furthest);
  if (sagitta < 1e-3 * longest) return false;  // straight
  // The sphere furthest from the chord need not be the middle of the arc: a circle through all
  // three.
  const double bx = spheres[b][0] - spheres[a][0], by = spheres[b][1] - spheres[a][1];
  const double cx = spheres[c][0] - spheres[a][0], cy = spheres[c][1] - spheres[a][1];
  const double d = 2 * (bx * cy - by * cx), b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
  const double px = (cy * b2 - by * c2) / d, py = (bx * c2 - cx * b2) / d;
  arc.x = spheres[a][0] + px;
  arc.y = spheres[a][1] + py;
  arc.radius = std::hypot(px, py);
  const double mx = spheres[a][0] + bx / 2 - arc.x, my = spheres[a][1] + by / 2 - arc.y;
  arc.chord = std::hypot(mx, my);
  if (!(arc.chord > 1e-9 * arc.radius)) return false;  // a half circle has no such direction
  arc.ux = mx / arc.chord;
  arc.uy = my / arc.chord;
  arc.half_width = spheres[a][2];
  return true;
}

std::vector<Arc> arcs_of(const Frame& spheres) {
  const auto &body = spheres.column("body"), &x = spheres.column("x"), &y = spheres.column("y"),
             &radius = spheres.column("radius");
  std::map<double, std::vector<std::array<double, 3>>> bodies;
  for (std::size_t k = 0; k < spheres.rows; ++k) bodies[body[k]].push_back({x[k], y[k], radius[k]});
  std::vector<Arc> arcs;
  for (const auto& [id, chain] : bodies) {
    Arc arc{};
    if (chain.size() >= 3 && arc_of(chain, arc)) arcs.push_back(arc);
  }
  return arcs;
}

}  // namespace

std::vector<Void> find_voids(const Frame& spheres, const Walls& walls, const VoidSearch& search) {
  if (!(search.probe > 0) || !(search.step > 0) || !(search.surface > walls.floor))
    throw DataError("voids: probe, step and height of the bed have to be positive");
  const Raster raster(walls, search);
  auto covered = covered_by_probe(raster, room_for_probe(raster, spheres, walls, search), search);
  const auto arcs = arcs_of(spheres);
  std::vector<Void> voids;
  for (long j = 0; j < raster.rows; ++j)
    for (long i = 0; i < raster.columns; ++i) {
      if (!covered[raster.at(i, j)]) continue;
      Void region = take_region(raster, covered, i, j);
      const double reach = reach_of(region);
      region.in_hollow = std::any_of(arcs.begin(), arcs.end(), [&](const Arc& arc) {
        return std::hypot(region.x - arc.x, region.y - arc.y) < arc.radius + reach &&
               arc.hollow_holds_most_of(region, search.step);
      });
      voids.push_back(std::move(region));
    }
  return voids;
}

}  // namespace rodpack
