// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/orientation_figure.h"

#include <algorithm>
#include <cmath>

#include "figures/figure.h"
#include "reading/angles.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {

double largest(const OrientationDistribution& distribution) {
  double value = 0;
  for (std::size_t k = 0; k < distribution.density.size(); ++k)
    value = std::max(value, distribution.density[k] + distribution.standard_error[k]);
  return value;
}
}  // namespace

void plot_orientation_linear(const OrientationDistribution& distribution, const std::string& stem) {
  const double width = distribution.range / static_cast<double>(distribution.centre.size());
  const std::string range = number_text(distribution.range);
  // The first bin goes over either end of the range: it is drawn at both.
  auto centre = distribution.centre, density = distribution.density;
  auto error = distribution.standard_error;
  centre.push_back(distribution.range);
  density.push_back(density.front());
  error.push_back(error.front());
  const std::string uniform = number_text(1 / distribution.range);
  draw_figure(stem, 1.4,
              datablock("h", {centre, density, error}) +
                  "set xlabel 'orientation {/:Italic γ} (°)'\n"
                  "set ylabel 'probability density (1/°)'\n"
                  "set xrange [0:" +
                  range + "]\n" + "set yrange [0:" + number_text(1.08 * largest(distribution)) +
                  "]\n" + "set xtics " + (distribution.curved ? "60" : "30") + "\n" +
                  "set boxwidth " + number_text(width) + "\n" +
                  "set key outside top right horizontal\n"
                  "plot $h using 1:2 with boxes linecolor '#8CBBD9', "
                  "$h using ($3 > 0 ? $1 : NaN):($2-$3):(0):(2*$3) with vectors heads size " +
                  number_text(width / 4) + ",90 linewidth 0.8 linecolor '" + colour::blue + "', " +
                  uniform + " with lines dashtype 2 linewidth 1 linecolor '" + colour::grey +
                  "' title 'isotropic'\n");
}

namespace {

// Curves in polar coordinates, separated by blank lines as gnuplot wants its polygons.
std::string arc(double radius, double from, double to, int pieces) {
  std::string points;
  for (int s = 0; s <= pieces; ++s) {
    const double angle = (from + (to - from) * s / pieces) * degree;
    points +=
        number_text(radius * std::cos(angle)) + " " + number_text(radius * std::sin(angle)) + "\n";
  }
  return points;
}

// A sector for each bin, in units of the density `outer`.
std::string sectors_of(const OrientationDistribution& distribution, double outer) {
  const double width = distribution.range / static_cast<double>(distribution.centre.size());
  const bool half = !distribution.curved;
  std::string sectors = "$sectors << EOD\n";
  const auto add_sector = [&](double density, double from, double to) {
    sectors += "0 0\n" + arc(density / outer, from, to, 8) + "0 0\n\n\n";
  };
  for (std::size_t k = 0; k < distribution.density.size(); ++k)
    add_sector(distribution.density[k], distribution.centre[k] - (half && k == 0 ? 0 : width / 2),
               distribution.centre[k] + width / 2);
  // The bin of 0 degrees ends a half rose, too.
  if (half) add_sector(distribution.density.front(), 180 - width / 2, 180);
  return sectors + "EOD\n";
}

}  // namespace

void plot_orientation_polar(const OrientationDistribution& distribution, const std::string& stem) {
  const double step = round_step(largest(distribution) / 2);
  const double outer =
      step *
      std::ceil(*std::max_element(distribution.density.begin(), distribution.density.end()) / step);
  const bool half = !distribution.curved;
  const double bottom = half ? -0.24 : -1.36;

  std::string grid = "$grid << EOD\n";
  std::string labels;
  for (int ring = 1; ring * step <= outer * 1.001; ++ring) {
    const double radius = ring * step / outer;
    grid += arc(radius, 0, half ? 180 : 360, half ? 90 : 180) + "\n";
    // Half rose: under the base line; full rose: between two spokes.
    const double tilt = half ? 0 : 45 * degree;
    labels += "set label '{/*0.8 " + number_text(ring * step, 3) + "}' at " +
              number_text(radius * std::cos(tilt)) + "," +
              number_text(half ? -0.06 : radius * std::sin(tilt)) +
              " center front textcolor '#404040'\n";
  }
  for (int angle = 0; angle <= (half ? 180 : 330); angle += 30) {
    const double c = std::cos(angle * degree);
    const double s = std::sin(angle * degree);
    grid += "0 0\n" + number_text(c) + " " + number_text(s) + "\n\n";
    labels += "set label '" + std::to_string(angle) + "°' at " + number_text(1.11 * c) + "," +
              number_text(1.09 * s) + " center\n";
  }
  grid += "EOD\n";
  labels +=
      "set label 'probability density (1/°)' at 0," + number_text(bottom + 0.06) + " center\n";
  draw_figure(stem, half ? 1.7 : 0.98,
              sectors_of(distribution, outer) + grid + labels +
                  "unset border\nunset tics\nset lmargin 1\nset rmargin 1\nset tmargin 0.5\n"
                  "set bmargin 0.5\nset size ratio -1\n"
                  "set xrange [-1.25:1.25]\nset yrange [" +
                  number_text(bottom) + ":1.2]\n" +
                  "plot $sectors using 1:2 with filledcurves closed linecolor '#8CBBD9', "
                  "$sectors using 1:2 with lines linewidth 0.7 linecolor '" +
                  colour::blue +
                  "', $grid using 1:2 with lines linewidth 0.6 linecolor '#A0A0A0'\n");
}

}  // namespace rodpack
