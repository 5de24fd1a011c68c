// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/space/direction_figure.h"

#include <algorithm>

#include "figures/figure.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {

constexpr const char* axis_names = "xyz";

std::string axis_name(std::size_t axis) { return std::string(1, axis_names[axis % 3]); }

double highest(const DirectionHistogram& histogram) {
  double value = 1;
  for (std::size_t k = 0; k < histogram.density.size(); ++k)
    value = std::max(value, histogram.density[k] + histogram.standard_error[k]);
  return value;
}

// Boxes with their errors over the bins, and the line of isotropic directions.
void plot_bins(const DirectionHistogram& histogram, double last, const std::string& label,
               const std::string& density, const std::string& stem) {
  std::string commands =
      datablock("h", {histogram.from, histogram.to, histogram.density, histogram.standard_error});
  commands += "set xlabel '" + label + "'\n";
  commands += "set ylabel '" + density + " / isotropic'\n";
  commands += "set xrange [0:" + number_text(last) + "]\n";
  commands += "set yrange [0:" + number_text(1.08 * highest(histogram)) + "]\n";
  commands += "set xtics " + number_text(last / 6) +
              "\nset mxtics 3\nset key outside top right horizontal\n";
  commands +=
      "plot $h using (($1+$2)/2):3:($2-$1) with boxes linecolor '#8CBBD9', "
      "$h using (($1+$2)/2):($4 > 0 ? $3-$4 : NaN):(0):(2*$4) with vectors heads size ";
  commands += number_text(last / 150);
  commands += ",90 linewidth 0.8 linecolor '";
  commands += colour::blue;
  commands += "', 1 with lines dashtype 2 linewidth 1 linecolor '";
  commands += colour::grey;
  commands += "' title 'isotropic'\n";
  draw_figure(stem, 1.4, commands);
}

}  // namespace

void plot_polar_angle(const DirectionHistogram& histogram, const std::string& what,
                      std::size_t vertical, const std::string& stem) {
  plot_bins(histogram, 90,
            "angle of a " + what + " to the vertical, " + axis_name(vertical) + " (°)",
            "density per solid angle", stem);
}

void plot_azimuth(const DirectionHistogram& histogram, const std::string& what,
                  std::size_t vertical, const std::string& stem) {
  // The first bin goes over either end of the range: it is drawn at both.
  auto both = histogram;
  both.from.push_back(180 + histogram.from.front());
  both.to.push_back(180 + histogram.to.front());
  both.density.push_back(histogram.density.front());
  both.standard_error.push_back(histogram.standard_error.front());
  plot_bins(both, 180,
            "azimuth of a " + what + " about " + axis_name(vertical) + ", from " +
                axis_name(vertical + 1) + " to " + axis_name(vertical + 2) + " (°)",
            "density", stem);
}

}  // namespace rodpack
