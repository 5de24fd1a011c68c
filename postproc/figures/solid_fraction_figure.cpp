// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/solid_fraction_figure.h"

#include <vector>

#include "figures/figure.h"
#include "reading/number_text.h"

namespace rodpack {

void plot_solid_fraction(const SolidFraction& field, double particle_diameter, double floor,
                         const std::string& stem) {
  auto height = field.height;
  for (auto& each : height) each /= particle_diameter;
  std::string range;
  if (field.up_to_surface)
    range = "set object rectangle from graph 0, first " +
            number_text((field.lowest - floor) / particle_diameter) + " to graph 1, first " +
            number_text((field.surface - floor) / particle_diameter) +
            " behind fillstyle solid noborder fillcolor '#EEEEEE'\n"
            "set label 'mean over the grey range: {/:Italic φ} = " +
            number_text(*field.up_to_surface, 3) + "' at graph 0.05, 0.55\n";
  // Nearer to the surface the kernel averages over the empty space above it.
  if (field.up_to_3_scales_below)
    range += "set label 'up to 3{/:Italic ω} below the surface: {/:Italic φ} = " +
             number_text(*field.up_to_3_scales_below, 3) + "' at graph 0.05, 0.49\n";
  draw_figure(stem, 1.0,
              datablock("phi", {height, field.phi}) + range +
                  "set xlabel 'solid fraction {/:Italic φ}'\n"
                  "set ylabel 'height above the floor / {/:Italic d}_p'\n"
                  "set xrange [0:1]\nset yrange [0:" +
                  number_text(height.back()) +
                  "]\n"
                  "plot $phi using 2:1 with lines linewidth 1.6 linecolor '" +
                  colour::blue + "'\n");
}

}  // namespace rodpack
