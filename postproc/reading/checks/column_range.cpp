// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/checks/column_range.h"

#include <array>
#include <map>

namespace rodpack {
namespace {

// Whole numbers up to here are exact as double.
constexpr double largest_id = 9007199254740992.0;

std::map<std::string, NumberRange> make_ranges() {
  std::map<std::string, NumberRange> ranges;
  const auto add = [&](std::initializer_list<const char*> names, const NumberRange& range) {
    for (const char* name : names) ranges.emplace(name, range);
  };
  const auto around_zero = [](double high) { return NumberRange{-high, high}; };
  add({"id", "body", "body_i", "body_j", "sphere_i", "sphere_j", "type", "type_i", "type_j"},
      {0, largest_id, true});
  add({"nspheres"}, {1, 1e6, true});
  add({"wall"}, {0, 1, true});
  add({"angle"}, around_zero(1e3));
  add({"curvature"}, {0, 7});  // up to 2 pi, printed with few digits
  add({"qw", "qx", "qy", "qz", "nx", "ny", "nz"}, around_zero(1.1));
  add({"half_length", "radius"}, {1e-12, 1e3});
  add({"area"}, {1e-24, 1e6});
  add({"mass"}, {1e-30, 1e12});
  add({"vx", "vy", "vz"}, around_zero(1e9));
  add({"omegax", "omegay", "omegaz"}, around_zero(1e12));
  add({"fx", "fy", "fz"}, around_zero(1e15));
  add({"fsum"}, {0, 1e15});
  add({"overlap_n"}, around_zero(1e3));
  add({"overlap_t"}, {0, 1e3});
  return ranges;
}

}  // namespace

const NumberRange* column_range(const std::string& name) {
  static const auto ranges = make_ranges();
  const auto found = ranges.find(name);
  return found == ranges.end() ? nullptr : &found->second;
}

int place_axis(const std::string& name) {
  for (const char* prefix : {"", "bi", "bj"}) {
    constexpr std::array<char, 3> axes{'x', 'y', 'z'};
    for (std::size_t axis = 0; axis < axes.size(); ++axis)
      if (name == prefix + std::string(1, axes[axis])) return static_cast<int>(axis);
  }
  return -1;
}

}  // namespace rodpack
