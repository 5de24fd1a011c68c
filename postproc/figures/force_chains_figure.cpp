// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/force_chains_figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <vector>

#include "analysis/force_chains.h"
#include "figures/drawing.h"
#include "figures/palette.h"
#include "reading/number_text.h"
#include "reading/parameters.h"

namespace rodpack {
namespace {

// Returns d_p, m; 0 if nothing says it, since contacts know no radius.
double particle_diameter(const PackingOptions& options,
                         const std::optional<RunParameters>& parameters) {
  if (options.particle_diameter) return *options.particle_diameter;
  if (parameters && parameters->values.contains("particle_diameter_m"))
    return parameters->number("particle_diameter_m");
  return 0;
}

// By how much a line is seen again along a direction: nowhere between walls, else a period away.
std::vector<double> shifts_along(bool walls, double period) {
  if (walls) return {0};
  return {-period, 0, period};
}

}  // namespace

void draw_force_chains(const Frame& contacts, const PackingOptions& options,
                       const std::string& stem) {
  auto lines = force_lines(contacts);
  std::sort(lines.begin(), lines.end(),
            [](const ForceLine& a, const ForceLine& b) { return a.force < b.force; });
  const auto parameters = find_parameters(contacts.file, options.parameters);
  const Walls walls = find_walls(contacts, options, parameters);
  const double diameter = particle_diameter(options, parameters);

  double top = walls.bottom ? walls.floor : walls.ceiling;
  if (walls.bottom)
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
  const std::array<double, 4> window{walls.left, walls.right, walls.floor,
                                     walls.bottom ? top + spacing / 2 : top};
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
    for (const double dx : shifts_along(walls.sides, walls.width()))
      for (const double dy : shifts_along(walls.bottom, walls.ceiling - walls.floor)) {
        const bool outside = std::max(line.x1, line.x2) + dx < window[0] ||
                             std::min(line.x1, line.x2) + dx > window[1] ||
                             std::max(line.y1, line.y2) + dy < window[2] ||
                             std::min(line.y1, line.y2) + dy > window[3];
        if (outside && (dx != 0 || dy != 0)) continue;
        drawing.line(picture.x(line.x1 + dx), picture.y(line.y1 + dy), picture.x(line.x2 + dx),
                     picture.y(line.y2 + dy), std::max(thin, part * full), scale.shade(k), "round");
      }
  }
  picture.finish(walls, diameter, scale, stem);
}

}  // namespace rodpack
