// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "campaigns/comparison/comparison.h"
#include "figures/figure.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {

/// `values` over time without what a logarithmic axis cannot show.
std::string curve(const std::string& name, const std::vector<double>& time,
                  const std::vector<double>& values, double factor) {
  std::vector<double> shown_time, shown;
  for (std::size_t i = 0; i < time.size(); ++i)
    if (values[i] > 0) {
      shown_time.push_back(time[i]);
      shown.push_back(factor * values[i]);
    }
  if (shown.empty()) {  // gnuplot refuses an empty datablock
    shown_time.push_back(time.front());
    shown.push_back(0);
  }
  return datablock(name, {shown_time, shown});
}

std::vector<double> sum(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> result(a);
  std::transform(result.begin(), result.end(), b.begin(), result.begin(), std::plus<>());
  return result;
}

std::string log_axis(double lowest, double highest) {
  return "set logscale y\nset format y '10^{%T}'\nset yrange [" + number_text(lowest) + ":" +
         number_text(highest) + "]\n";
}

double largest(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

/// The smallest positive value, or `otherwise` if that is smaller.
double smallest(const std::vector<double>& values, double otherwise) {
  for (const double value : values)
    if (value > 0) otherwise = std::min(otherwise, value);
  return otherwise;
}

}  // namespace

void plot_separation(const Comparison& comparison, const std::string& stem) {
  const auto& builtin = comparison.builtin_rodpack;
  const auto& sampled = comparison.sampled_rodpack;
  const double factor = 1 / comparison.particle_diameter;
  const std::string limit = number_text(comparison.limit * factor);
  const double top =
      factor * std::max({largest(builtin.largest), largest(sampled.largest), comparison.limit});
  const double bottom =
      factor * smallest(builtin.largest, smallest(sampled.largest, comparison.limit));
  std::string mark;
  if (const auto time = builtin.parting_time())
    mark = "set arrow from " + number_text(*time) + ", graph 0 to " + number_text(*time) +
           ", graph 1 nohead dashtype 3 linecolor '" + colour::blue + "'\n";
  draw_figure(stem, 1.4,
              curve("builtin", builtin.time, builtin.largest, factor) +
                  curve("sampled", sampled.time, sampled.largest, factor) + mark +
                  log_axis(bottom / 3, 3 * top) +
                  "set mytics 10\nset xrange [0:" + number_text(builtin.time.back()) +
                  "]\n"
                  "set xlabel 'time (s)'\n"
                  "set ylabel 'largest distance from rodpack ({/:Italic d}_p)'\n"
                  "set key outside top center horizontal maxcols 2\n"
                  "plot $sampled using 1:2 with lines linewidth 1.4 linecolor '" +
                  colour::grey +
                  "' title 'built-in, sampled bodies', "
                  "$builtin using 1:2 with lines linewidth 1.4 linecolor '" +
                  colour::blue + "' title 'built-in', " + limit +
                  " with lines dashtype 2 linecolor '#404040' title 'parted'\n");
}

void plot_energy_comparison(const Comparison& comparison, const std::string& stem) {
  std::string data, plot;
  double highest = 0;
  const auto add = [&](const MethodRun& run, const std::string& title, const std::string& colour) {
    const auto kinetic = sum(run.series.kinetic_translational, run.series.kinetic_rotational);
    const auto elastic = sum(run.series.elastic_normal, run.series.elastic_tangential);
    highest = std::max({highest, largest(kinetic), largest(elastic)});
    data += curve(run.name + "_kinetic", run.bodies.time, kinetic, 1) +
            curve(run.name + "_elastic", run.bodies.time, elastic, 1);
    plot += (plot.empty() ? "plot $" : ", $") + run.name +
            "_kinetic using 1:2 with lines linewidth 1.4 linecolor '" + colour +
            "' title 'kinetic, " + title + "', $" + run.name +
            "_elastic using 1:2 with lines linewidth 1.4 dashtype 2 linecolor '" + colour +
            "' title 'elastic, " + title + "'";
  };
  add(comparison.builtin, "built-in", colour::blue);
  add(comparison.rodpack, "rodpack", colour::vermilion);
  draw_figure(stem, 1.4,
              data + log_axis(1e-10 * highest, 3 * highest) + "set mytics 10\nset xrange [0:" +
                  number_text(comparison.builtin.bodies.time.back()) +
                  "]\nset xlabel 'time (s)'\nset ylabel 'energy (J)'\n"
                  "set key outside top center horizontal maxcols 2\n" +
                  plot + "\n");
}

}  // namespace rodpack
