// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/incline/chute_figure.h"

#include <algorithm>
#include <cmath>

#include "figures/figure.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {

// Panel `number` of `count` side by side.
std::string panel(int number, int count) {
  const double left = 0.07, right = 0.015, gap = 0.075;
  const double width = (1 - left - right - (count - 1) * gap) / count;
  const double from = left + number * (width + gap);
  return "set lmargin at screen " + number_text(from) + "\nset rmargin at screen " +
         number_text(from + width) + "\nset tmargin at screen 0.96\nset bmargin at screen 0.2\n";
}

std::string line(const std::string& columns, const char* colour, const std::string& rest) {
  return "$p using " + columns + " with lines linewidth 1.8 linecolor '" + colour + "' " + rest;
}

}  // namespace

void plot_chute(const ChuteProfile& profile, const std::string& stem) {
  const double d = profile.particle_diameter;
  const double speed = std::sqrt(profile.slope.gravity * d);
  // Above the surface hardly anything is averaged over, and ratios of it say nothing.
  const double most =
      *std::max_element(profile.solid_fraction.begin(), profile.solid_fraction.end());
  const double top = *std::max_element(profile.load_onto.begin(), profile.load_onto.end());
  const auto unit = scaled_unit(top, "N/m");
  std::vector<double> height, velocity, fraction, onto, down, load_onto, load_down;
  std::size_t last = profile.height.size() - 1;
  while (last > 0 && profile.solid_fraction[last] < 0.01 * most) --last;
  for (std::size_t k = 0; k <= last; ++k) {
    height.push_back(profile.height[k] / d);
    velocity.push_back(profile.velocity[k] / speed);
    fraction.push_back(profile.solid_fraction[k]);
    onto.push_back(profile.yy[k] * unit.factor);
    down.push_back(-profile.xy[k] * unit.factor);
    load_onto.push_back(profile.load_onto[k] * unit.factor);
    load_down.push_back(profile.load_down[k] * unit.factor);
  }
  // A bed at rest has no range of its own.
  const auto ends = std::minmax_element(velocity.begin(), velocity.end());
  const double slowest = std::min(0.0, *ends.first), fastest = std::max(0.01, *ends.second);
  const std::string dashes = "dashtype 2 linewidth 1.2 linecolor '#000000'";
  draw_figure(stem, 2.2,
              datablock("p", {height, velocity, fraction, onto, down, load_onto, load_down}) +
                  "set multiplot\nset yrange [0:" + number_text(height.back()) + "]\n" +
                  panel(0, 3) +
                  "set ylabel 'height above the base / {/:Italic d}_p'\n"
                  "set xlabel 'velocity, {/:Italic u} / ({/:Italic g d}_p)^{1/2}'\nset xrange [" +
                  number_text(slowest, 6) + ":" + number_text(1.05 * fastest, 6) +
                  "]\n"
                  "plot " +
                  line("2:1", colour::blue, "notitle") + "\n" + panel(1, 3) +
                  "unset ylabel\nset xlabel 'solid fraction {/:Italic φ}'\nset xrange [0:1]\n"
                  "plot " +
                  line("3:1", colour::blue, "notitle") + "\n" + panel(2, 3) +
                  "set xlabel 'stress (" + unit.name +
                  ")'\nset xrange [*<0:*]\nset key top right\n"
                  "plot " +
                  line("4:1", colour::blue, "title '{/:Italic σ}_{yy}'") + ", " +
                  line("5:1", colour::vermilion, "title '-{/:Italic σ}_{xy}'") +
                  ", $p using 6:1 with lines " + dashes +
                  " title 'load from above', $p using 7:1 with lines " + dashes +
                  " notitle\nunset multiplot\n",
              2.2);
}

void plot_rheology(const std::vector<double>& inertial_number, const std::vector<double>& friction,
                   const std::vector<double>& solid_fraction, const std::string& stem) {
  const auto points = [](const std::string& columns) {
    return "plot $p using " + columns + " with points pointtype 7 pointsize 1.2 linecolor '" +
           std::string(colour::blue) + "' notitle\n";
  };
  draw_figure(stem, 2,
              datablock("p", {inertial_number, friction, solid_fraction}) +
                  "set multiplot\nset xrange [0:*]\nset offsets 0, graph 0.05, graph 0.1, graph "
                  "0.1\nset xlabel 'inertial number {/:Italic I}'\n" +
                  panel(0, 2) + "set ylabel 'friction, -{/:Italic σ}_{xy} / {/:Italic σ}_{yy}'\n" +
                  points("1:2") + panel(1, 2) + "set ylabel 'solid fraction {/:Italic φ}'\n" +
                  points("1:3") + "unset multiplot\n",
              1.8);
}

}  // namespace rodpack
