// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/force_chains.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "figures/drawing.h"
#include "reading/text.h"

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

// 0 if nothing says it: contacts know no radius.
double particle_diameter(const PackingOptions& options,
                         const std::optional<RunParameters>& parameters) {
  if (options.particle_diameter) return *options.particle_diameter;
  if (parameters && parameters->values.contains("particle_diameter_m"))
    return parameters->number("particle_diameter_m");
  return 0;
}

}  // namespace

std::vector<ForceLine> force_lines(const Frame& contacts) {
  if (contacts.rows == 0)
    throw TooFewParticles(contacts.file + ":" + std::to_string(contacts.header_line) +
                          ": no contacts in the frame of timestep " +
                          std::to_string(contacts.timestep));
  const auto columns = [&](const std::array<const char*, 3>& names) {
    return std::array<const std::vector<double>*, 3>{
        &contacts.column(names[0]), &contacts.column(names[1]), &contacts.column(names[2])};
  };
  const auto& body_i = contacts.column("body_i");
  const auto& body_j = contacts.column("body_j");
  const auto& wall = contacts.column("wall");
  const auto f = columns({"fx", "fy", "fz"});
  const auto n = columns({"nx", "ny", "nz"});
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
  for (const auto& [key, pair] : pairs) {
    const auto& e = pair.ends;
    const auto& f = pair.force;
    ForceLine line{e[0], e[1], e[2], e[3], std::hypot(f[0], f[1], f[2])};
    if (std::get<0>(key) == 0 && pair.weight > 0) {
      line.x2 = line.x1 + pair.x / pair.weight;
      line.y2 = line.y1 + pair.y / pair.weight;
    }
    lines.push_back(line);
  }
  return lines;
}

void draw_force_chains(const Frame& contacts, const PackingOptions& options,
                       const std::string& stem) {
  auto lines = force_lines(contacts);
  std::sort(lines.begin(), lines.end(),
            [](const ForceLine& a, const ForceLine& b) { return a.force < b.force; });
  const auto parameters = find_parameters(contacts.file, options.parameters);
  const Walls walls = find_walls(contacts, options, parameters);
  const double diameter = particle_diameter(options, parameters);

  double top = walls.floor;
  for (const auto& line : lines) top = std::max({top, line.y1, line.y2});
  if (!(top > walls.floor))
    throw DataError(contacts.file +
                    ": all contacts lie below the floor, y = " + number_text(walls.floor) + " m");
  // Widths go with the mean distance of the particles: the mesh that the lines have to show.
  std::set<double> bodies(contacts.column("body_i").begin(), contacts.column("body_i").end());
  bodies.insert(contacts.column("body_j").begin(), contacts.column("body_j").end());
  bodies.erase(0);
  const double spacing =
      std::sqrt(walls.width() * (top - walls.floor) / static_cast<double>(bodies.size()));
  const std::array<double, 4> window{walls.left, walls.right, walls.floor, top + spacing / 2};
  const double longer = std::max(window[1] - window[0], window[3] - window[2]);
  PackingPicture picture(window, std::clamp(24 * longer / spacing, 1200.0, 4000.0), true);

  std::vector<double> forces;
  for (const auto& line : lines) forces.push_back(line.force);
  auto scale = force_scale(forces, std::nullopt, "force between particles");
  scale.palette = &embers;
  const double full = std::max(3.0, 0.24 * spacing * picture.per_metre());
  const double thin = std::max(1.0, longer * picture.per_metre() / 1500);  // seen on a screen
  const double strongest = quantile_99(forces);
  auto& drawing = picture.begin();
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const auto& line = lines[k];
    const double part = strongest > 0 ? std::min(line.force / strongest, 1.0) : 0;
    // A pair that touches across a periodic border is seen at both.
    for (const double shift : {-walls.width(), 0.0, walls.width()}) {
      const bool outside = std::max(line.x1, line.x2) + shift < walls.left ||
                           std::min(line.x1, line.x2) + shift > walls.right;
      if (shift != 0 && (walls.sides || outside)) continue;
      drawing.line(picture.x(line.x1 + shift), picture.y(line.y1), picture.x(line.x2 + shift),
                   picture.y(line.y2), std::max(thin, part * full), scale.shade(k), "round");
    }
  }
  picture.finish(walls, diameter, scale, stem);
}

}  // namespace rodpack
