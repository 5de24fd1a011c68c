// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/profile_figure.h"

#include <algorithm>
#include <vector>

#include "figures/figure.h"
#include "figures/edges/shading.h"
#include "reading/number_text.h"

namespace rodpack {

void plot_profile(const PressureProfile& profile, const JanssenFit* fit, const std::string& stem) {
  const double d = profile.particle_diameter;
  std::vector<double> depth, pressure, vertical, horizontal;
  const double top = *std::max_element(profile.yy.begin(), profile.yy.end());
  const auto unit = scaled_unit(top, "N/m");
  for (std::size_t k = 0; k < profile.depth.size(); ++k) {
    depth.push_back(profile.depth[k] / d);
    pressure.push_back(profile.pressure[k] * unit.factor);
    vertical.push_back(profile.yy[k] * unit.factor);
    horizontal.push_back(profile.xx[k] * unit.factor);
  }
  std::string law;
  if (fit)
    law = ", [" + number_text(fit->from / d) + ":" + number_text(fit->to / d) + "] " +
          number_text(fit->pressure * unit.factor) + "*(1-exp(-x/" + number_text(fit->depth / d) +
          ")) with lines dashtype 2 linewidth 1.4 linecolor '#000000' title '" +
          (fit->saturates ? "Janssen" : "Janssen (not saturating)") + "'";
  const double floor = profile.depth_of_floor / d;
  const auto& [from, to] = profile.undisturbed;
  const bool some = to > from;
  const std::string grey = some ? grey_strip('x', 0, from / d) + grey_strip('x', to / d, floor)
                                : grey_strip('x', 0, floor);
  draw_figure(
      stem, 1.4,
      datablock("p", {depth, pressure, vertical, horizontal}) + grey +
          "set xlabel 'depth below the surface, down to the floor, {/:Italic h} / {/:Italic d}_p'\n"
          "set ylabel 'stress (" +
          unit.name +
          ")'\n"
          "set key tmargin left horizontal maxcols 2 Left reverse\nset xrange [0:" +
          number_text(floor) +
          "]\nset yrange [0:*]\n"
          "set samples 300\n"
          "plot $p using 1:2 with lines linewidth 1.8 linecolor '" +
          colour::blue +
          "' title '{/:Italic P}_0', $p using 1:3 with lines linewidth 1.2 linecolor '" +
          colour::vermilion +
          "' title '{/:Italic σ}_{yy}', $p using 1:4 with lines linewidth 1.2 linecolor '" +
          colour::grey + "' title '{/:Italic σ}_{xx}'" + law +
          (grey.empty()
               ? ""
               : ", " + grey_key(profile.reach / profile.scale, profile.walls_divided_out)) +
          "\n");
}

}  // namespace rodpack
