// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/space/direction_figure.h"

#include <algorithm>

#include "figures/figure.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {

constexpr const char* axis_names = "xyz";

std::string axis_name(std::size_t axis) { return std::string(1, axis_names[axis % 3]); }

struct BinsPlot {
  double last;                 // upper end of the axis of angles, degrees
  std::string angle, density;  // labels of the axes
  double least_top = 1;        // that the axis of densities has to reach
  std::string blocks, curve;   // further data, and what to draw of them over the boxes
};

// Boxes with their errors over the bins, and the line of isotropic directions.
void plot_bins(const DirectionHistogram& histogram, const BinsPlot& plot, const std::string& stem) {
  double top = plot.least_top;
  for (std::size_t k = 0; k < histogram.density.size(); ++k)
    top = std::max(top, histogram.density[k] + histogram.standard_error[k]);
  std::string commands =
      datablock("h", {histogram.from, histogram.to, histogram.density, histogram.standard_error});
  commands += plot.blocks + "set xlabel '" + plot.angle + "'\n";
  commands += "set ylabel '" + plot.density + "'\n";
  commands += "set xrange [0:" + number_text(plot.last) + "]\n";
  commands += "set yrange [0:" + number_text(1.08 * top) + "]\n";
  commands += "set xtics " + number_text(plot.last / 6) +
              "\nset mxtics 3\nset key outside top right horizontal\n";
  commands +=
      "plot $h using (($1+$2)/2):3:($2-$1) with boxes linecolor '#8CBBD9', "
      "$h using (($1+$2)/2):($4 > 0 ? $3-$4 : NaN):(0):(2*$4) with vectors heads size ";
  commands += number_text(plot.last / 150);
  commands += ",90 linewidth 0.8 linecolor '";
  commands += colour::blue;
  commands += "', 1 with lines dashtype 2 linewidth 1 linecolor '";
  commands += colour::grey;
  commands += "' title 'isotropic'" + plot.curve + "\n";
  draw_figure(stem, 1.4, commands);
}

std::string polar_label(const std::string& what, std::size_t vertical) {
  return "angle of a " + what + " to the vertical, " + axis_name(vertical) + " (°)";
}

}  // namespace

void plot_polar_angle(const DirectionHistogram& histogram, const std::string& what,
                      std::size_t vertical, const std::string& stem) {
  plot_bins(histogram,
            {90, polar_label(what, vertical), "density per solid angle / isotropic", 1, "", ""},
            stem);
}

void plot_fabric(const Fabric& fabric, const std::string& stem) {
  double top = 1;
  std::vector<double> angle, force, error;
  for (std::size_t k = 0; k < fabric.force.size(); ++k) {
    if (!(fabric.polar.count[k] > 0)) continue;
    angle.push_back((fabric.polar.from[k] + fabric.polar.to[k]) / 2);
    force.push_back(fabric.force[k]);
    error.push_back(fabric.force_standard_error[k]);
    top = std::max(top, force.back() + error.back());
  }
  const std::string colour = colour::vermilion;
  plot_bins(
      fabric.polar,
      {90, polar_label("contact normal", fabric.vertical), "density / isotropic, force / mean", top,
       datablock("f", {angle, force, error}),
       ", $f using 1:2:3 with yerrorbars pointtype 7 pointsize 0.7 linewidth 0.8 linecolor '" +
           colour + "' title 'normal force'"},
      stem);
}

void plot_azimuth(const DirectionHistogram& histogram, const std::string& what,
                  std::size_t vertical, const std::string& stem) {
  // The first bin goes over either end of the range: it is drawn at both.
  auto both = histogram;
  both.from.push_back(180 + histogram.from.front());
  both.to.push_back(180 + histogram.to.front());
  both.density.push_back(histogram.density.front());
  both.standard_error.push_back(histogram.standard_error.front());
  plot_bins(both,
            {180,
             "azimuth of a " + what + " about " + axis_name(vertical) + ", from " +
                 axis_name(vertical + 1) + " to " + axis_name(vertical + 2) + " (°)",
             "density / isotropic", 1, "", ""},
            stem);
}

}  // namespace rodpack
