// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/solid_fraction_figure.h"

#include <vector>

#include "figures/figure.h"
#include "figures/edges/shading.h"
#include "reading/number_text.h"

namespace rodpack {

void plot_solid_fraction(const SolidFraction& field, double particle_diameter, double floor,
                         const std::string& stem) {
  auto height = field.height;
  for (auto& each : height) each /= particle_diameter;
  const double surface = height.back(), top = 1.05 * surface;
  const double from = (field.lowest - floor) / particle_diameter;
  const double to = surface - 3 * field.scale / particle_diameter;
  const bool some = field.up_to_3_scales_below && field.side_distance_kept;
  const std::string grey =
      some ? grey_strip('y', 0, from) + grey_strip('y', to, surface) : grey_strip('y', 0, surface);
  const std::string mean = some
                               ? "set label 'mean between the grey: {/:Italic φ} = " +
                                     number_text(*field.up_to_3_scales_below, 3) +
                                     "' at graph 0.05, first " + number_text((from + to) / 2) + "\n"
                               : "";
  const auto covered = field.covered_below_surface;
  draw_figure(
      stem, 1.0,
      datablock("phi", {height, field.phi}) + datablock("surface", {{0, 1}, {surface, surface}}) +
          datablock("covered", {{covered, covered}, {0, surface}}) + grey + mean +
          "set xlabel 'solid fraction {/:Italic φ}'\n"
          "set ylabel 'height above the floor / {/:Italic d}_p'\n"
          "set key tmargin left vertical maxrows 4 Left reverse\n"
          "set xrange [0:1]\nset yrange [0:" +
          number_text(top) + "]\n" + "plot $phi using 2:1 with lines linewidth 1.6 linecolor '" +
          colour::blue +
          "' title 'averaged with {/:Italic ω}', $covered using 1:2 with lines dashtype 2 "
          "linewidth 1.2 linecolor '" +
          colour::grey + "' title 'area of the particles / of the bed: " + number_text(covered, 3) +
          "', " + "$surface using 1:2 with lines " + surface_look() + " title 'surface', " +
          grey_key(3, false) + "\n");
}

}  // namespace rodpack
