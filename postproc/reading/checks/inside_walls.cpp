// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/checks/inside_walls.h"

#include <algorithm>

#include "reading/checks/body_axes.h"
#include "reading/number_text.h"

namespace rodpack {

void require_inside_walls(const Frame& bodies, const std::vector<double>& beyond,
                          double particle_diameter, const std::string& source) {
  const auto lost = [&](double each) { return each > particle_diameter; };
  const auto count = std::count_if(beyond.begin(), beyond.end(), lost);
  if (100 * count <= static_cast<std::ptrdiff_t>(beyond.size())) return;
  const auto first = std::find_if(beyond.begin(), beyond.end(), lost);
  throw DataError(at_row(bodies, static_cast<std::size_t>(first - beyond.begin())) +
                  "expected the particles within the walls (" + source + "), found " +
                  std::to_string(count) + " of " + std::to_string(beyond.size()) +
                  " further than d_p beyond them, this one by " +
                  number_text(*first / particle_diameter, 3) + " d_p");
}

}  // namespace rodpack
