// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ORDER_BY_PLACE_H
#define RODPACK_ORDER_BY_PLACE_H

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace rodpack {

struct TaggedPlace {
  double x, y;
  int tag;
};

/// Bits 0, 1, 2, ... of a number at places 0, 2, 4, ...
inline std::uint64_t spread_bits(std::uint32_t number) {
  std::uint64_t spread = number;
  spread = (spread | spread << 16) & 0x0000ffff0000ffffULL;
  spread = (spread | spread << 8) & 0x00ff00ff00ff00ffULL;
  spread = (spread | spread << 4) & 0x0f0f0f0f0f0f0f0fULL;
  spread = (spread | spread << 2) & 0x3333333333333333ULL;
  return (spread | spread << 1) & 0x5555555555555555ULL;
}

/// Indices in the order of Morton's curve, along which neighbours in the plane mostly stay
/// neighbours, so that what is near is also near in memory; equal places by their tags.
/// Coordinates are resolved to 1/2^20 of the larger extent.
inline std::vector<int> order_by_place(const std::vector<TaggedPlace>& places) {
  double low[2] = {0.0, 0.0}, high[2] = {0.0, 0.0};
  for (const TaggedPlace& place : places) {
    const double at[2] = {place.x, place.y};
    const bool first = &place == places.data();
    for (int d = 0; d < 2; ++d) {
      low[d] = first ? at[d] : std::min(low[d], at[d]);
      high[d] = first ? at[d] : std::max(high[d], at[d]);
    }
  }
  const double cells = 1048575.0, extent = std::max(high[0] - low[0], high[1] - low[1]);
  const auto cell = [&](double distance) {
    const double place = distance / extent * cells;
    return place > 0.0 && place <= cells ? static_cast<std::uint32_t>(place) : 0u;
  };
  std::vector<std::uint64_t> keys;
  for (const TaggedPlace& place : places)
    keys.push_back(spread_bits(cell(place.x - low[0])) | spread_bits(cell(place.y - low[1])) << 1);
  std::vector<int> order(places.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return keys[a] != keys[b] ? keys[a] < keys[b] : places[a].tag < places[b].tag;
  });
  return order;
}

}  // namespace rodpack

#endif
