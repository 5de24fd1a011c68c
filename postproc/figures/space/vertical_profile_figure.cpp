// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/space/vertical_profile_figure.h"

#include <algorithm>

#include "figures/figure.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {

// Shades the ends of the axis of depths or heights, up to 3 w from either.
std::string shaded_ends(const VerticalProfile& profile) {
  const double d = profile.particle_diameter, end = profile.depth_of_floor / d;
  const double reach = std::min(3 * profile.scale / d, end / 2);
  std::string commands;
  const auto shade = [&](double from, double to) {
    commands += "set object rectangle from " + number_text(from) + ", graph 0 to " +
                number_text(to) + ", graph 1 behind fillcolor '#EEEEEE' fillstyle solid noborder\n";
  };
  shade(0, reach);
  shade(end - reach, end);
  return commands + "set xrange [0:" + number_text(end) + "]\n";
}

}  // namespace

void plot_vertical_stresses(const VerticalProfile& profile, const JanssenFit* fit,
                            const std::string& stem) {
  const double d = profile.particle_diameter;
  const double top = *std::max_element(profile.vertical.begin(), profile.vertical.end());
  const auto unit = scaled_unit(top, "Pa");
  std::vector<double> depth, vertical, first, second;
  for (std::size_t k = 0; k < profile.depth.size(); ++k) {
    depth.push_back(profile.depth[k] / d);
    vertical.push_back(profile.vertical[k] * unit.factor);
    first.push_back(profile.horizontal[0][k] * unit.factor);
    second.push_back(profile.horizontal[1][k] * unit.factor);
  }
  const auto curve = [](const std::string& column, std::size_t axis, const std::string& look) {
    const std::string name(1, "xyz"[axis % 3]);
    return "$p using 1:" + column + " with lines linewidth 1.4 " + look + " title '{/:Italic σ}_{" +
           name + name + "}'";
  };
  std::string commands = datablock("p", {depth, vertical, first, second}) + shaded_ends(profile);
  commands += "set xlabel 'depth {/:Italic h} / {/:Italic d}_p'\n";
  commands += "set ylabel 'stress (" + unit.name + ")'\n";
  commands += "set key top left Left reverse\nset yrange [0:*]\nset samples 300\nplot ";
  commands += curve("2", profile.axis, std::string("linecolor '") + colour::blue + "'");
  commands += ", ";
  commands += curve("3", profile.axis + 1, std::string("linecolor '") + colour::vermilion + "'");
  commands += ", ";
  commands +=
      curve("4", profile.axis + 2, std::string("dashtype 3 linecolor '") + colour::vermilion + "'");
  if (fit)
    commands += ", [" + number_text(fit->from / d) + ":" + number_text(fit->to / d) + "] " +
                number_text(fit->pressure * unit.factor) + "*(1-exp(-x/" +
                number_text(fit->depth / d) +
                ")) with lines dashtype 2 linewidth 1.4 linecolor '#000000' title '" +
                (fit->saturates ? "Janssen" : "Janssen (not saturating)") + "'";
  draw_figure(stem, 1.4, commands + "\n");
}

void plot_layers(const VerticalProfile& profile, const std::string& stem) {
  std::vector<double> height;
  for (const double each : profile.depth)
    height.push_back((profile.depth_of_floor - each) / profile.particle_diameter);
  std::string commands = datablock("p", {height, profile.solid_fraction}) + shaded_ends(profile);
  commands += "set xlabel 'height above the floor / {/:Italic d}_p'\n";
  commands += "set ylabel 'solid fraction {/:Italic φ}'\nset yrange [0:*]\n";
  commands += "plot $p using 1:2 with lines linewidth 1.4 linecolor '";
  commands += colour::blue;
  draw_figure(stem, 1.4, commands + "'\n");
}

}  // namespace rodpack
