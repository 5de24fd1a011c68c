// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/force_chains.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "reading/checks/contacts_of_bodies.h"

namespace rodpack {
namespace {

// The smaller id first (a wall has 0), then the wall's normal in hundredths, 0 between particles.
using Pair = std::tuple<double, double, std::array<long, 3>>;

struct PairSum {
  std::array<double, 4> ends{};   // x1 y1 x2 y2 of the first contact, m
  std::array<double, 3> force{};  // on the body of the smaller id, or on the one at the wall, N
  // Sums over the branches from i to j, weighted by the magnitude of the force: at a wall they end
  // in several points, and a rod across a periodic border may appear in two images.
  double weight = 0, x = 0, y = 0;
};

ForceLine line_of(const Pair& key, const PairSum& pair) {
  const auto& e = pair.ends;
  const auto& force = pair.force;
  const auto& [smaller, larger, normal] = key;
  const bool at_wall = smaller == 0;
  ForceLine line{e[0],
                 e[1],
                 e[2],
                 e[3],
                 std::hypot(force[0], force[1], force[2]),
                 std::lround(at_wall ? larger : smaller),
                 std::lround(at_wall ? 0 : larger),
                 {static_cast<double>(normal[0]) / 100, static_cast<double>(normal[1]) / 100}};
  if (at_wall && pair.weight > 0) {
    line.x2 = line.x1 + pair.x / pair.weight;
    line.y2 = line.y1 + pair.y / pair.weight;
  }
  return line;
}

}  // namespace

std::vector<ForceLine> force_lines(const Frame& contacts) {
  require_any_contact(contacts);
  const auto& body_i = contacts.column("body_i");
  const auto& body_j = contacts.column("body_j");
  const auto& wall = contacts.column("wall");
  const auto f = vector_columns(contacts, {"fx", "fy", "fz"});
  const auto n = vector_columns(contacts, {"nx", "ny", "nz"});
  const std::array<const std::vector<double>*, 4> ends{
      &contacts.column("bix"), &contacts.column("biy"), &contacts.column("bjx"),
      &contacts.column("bjy")};

  std::map<Pair, PairSum> pairs;
  for (std::size_t i = 0; i < contacts.rows; ++i) {
    const bool at_wall = wall[i] != 0;
    std::array<long, 3> normal{};
    if (at_wall)
      for (std::size_t c = 0; c < 3; ++c) normal[c] = std::lround(100 * (*n[c])[i]);
    const double other = at_wall ? 0 : body_j[i];
    const double smaller = std::min(body_i[i], other);
    const double larger = std::max(body_i[i], other);
    auto& pair = pairs[{smaller, larger, normal}];
    const double sign = at_wall || body_i[i] == smaller ? 1 : -1;
    double squared = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double force = (*f[c])[i];
      pair.force[c] += sign * force;
      squared += force * force;
    }
    if (pair.weight == 0)
      for (std::size_t e = 0; e < 4; ++e) pair.ends[e] = (*ends[e])[i];
    const double weight = std::sqrt(squared);
    pair.weight += weight;
    pair.x += weight * ((*ends[2])[i] - (*ends[0])[i]);
    pair.y += weight * ((*ends[3])[i] - (*ends[1])[i]);
  }

  std::vector<ForceLine> lines;
  for (const auto& [key, pair] : pairs) lines.push_back(line_of(key, pair));
  return lines;
}

}  // namespace rodpack
