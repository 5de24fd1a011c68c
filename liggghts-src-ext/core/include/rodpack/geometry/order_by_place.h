// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_GEOMETRY_ORDER_BY_PLACE_H
#define RODPACK_GEOMETRY_ORDER_BY_PLACE_H

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

namespace rodpack {

struct TaggedPlace {
  double x, y;
  int tag;
};

/// Indices in the order of strips of this thickness (> 0) across the larger extent, and along each
/// strip; equal places by their tags. What is as near as the thickness lies in the same strip or in
/// the next one, so near in memory, and no farther in a longer packing. `outwards`: the strips on
/// both sides of the middle by their distance from it, so that both ends come last.
inline std::vector<int> order_by_place(const std::vector<TaggedPlace>& places, double thickness,
                                       bool outwards = false) {
  double low[2] = {0.0, 0.0}, high[2] = {0.0, 0.0};
  for (const TaggedPlace& place : places) {
    const double at[2] = {place.x, place.y};
    const bool first = &place == places.data();
    for (int d = 0; d < 2; ++d) {
      low[d] = first ? at[d] : std::min(low[d], at[d]);
      high[d] = first ? at[d] : std::max(high[d], at[d]);
    }
  }
  const bool wide = high[0] - low[0] > high[1] - low[1];
  const int axis = wide ? 0 : 1;
  const double first = outwards ? 0.5 * (low[axis] + high[axis]) : low[axis];
  std::vector<std::tuple<double, double, int, int>> keys;  // strip, place in it, tag; index
  keys.reserve(places.size());
  for (const TaggedPlace& place : places) {
    const double distance = (wide ? place.x : place.y) - first;
    keys.emplace_back(std::floor((outwards ? std::fabs(distance) : distance) / thickness),
                      wide ? place.y : place.x, place.tag, static_cast<int>(keys.size()));
  }
  std::sort(keys.begin(), keys.end());
  std::vector<int> order;
  order.reserve(keys.size());
  for (const auto& key : keys) order.push_back(std::get<3>(key));
  return order;
}

}  // namespace rodpack

#endif
