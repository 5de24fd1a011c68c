// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/edges/shading.h"

#include "figures/figure.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {
const std::string grey = "#E6E6E6";
}

std::string shade_title(double reach, bool surface_alone) {
  return "within " + number_text(reach, 3) + "{/:Italic ω} of " +
         (surface_alone ? "the surface" : "wall or surface");
}

std::string hatch_block(const std::string& name, const std::vector<Rectangle>& parts) {
  std::vector<std::vector<double>> columns(6);
  for (const auto& part : parts) {
    const double row[] = {part.left, part.bottom, part.left, part.right, part.bottom, part.top};
    for (std::size_t c = 0; c < columns.size(); ++c) columns[c].push_back(row[c]);
  }
  return datablock(name, columns);
}

std::string hatched(const std::string& name) {
  return "$" + name +
         " using 1:2:3:4:5:6 with boxxyerror fillstyle transparent pattern 4 linewidth 0.7 "
         "linecolor rgb '#60FFFFFF'";
}

std::string grey_strip(char axis, double from, double to) {
  if (!(to > from)) return {};
  const bool along_x = axis == 'x';
  const auto corner = [&](double value, const char* end) {
    const std::string place = "first " + number_text(value), edge = std::string("graph ") + end;
    return along_x ? place + ", " + edge : edge + ", " + place;
  };
  return "set object rectangle from " + corner(from, "0") + " to " + corner(to, "1") +
         " behind fillstyle solid noborder fillcolor '" + grey + "'\n";
}

std::string grey_key(double reach, bool surface_alone) {
  return "keyentry with boxes fillstyle solid noborder fillcolor '" + grey + "' title '" +
         shade_title(reach, surface_alone) + "'";
}

std::string surface_look() {
  return std::string("linewidth 1.6 linecolor '") + colour::vermilion + "'";
}

}  // namespace rodpack
