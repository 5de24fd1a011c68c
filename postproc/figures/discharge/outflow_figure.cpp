// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/discharge/outflow_figure.h"

#include "figures/figure.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {

// Okabe and Ito's, in the order of the series; beyond six they begin again.
std::string series_colour(std::size_t series) {
  const char* colours[] = {colour::blue, colour::vermilion, "#009E73",
                           "#CC79A7",    "#E69F00",         "#56B4E9"};
  return colours[series % 6];
}

}  // namespace

void plot_outflow(const OutflowHistory& history, const Outflow& outflow, const std::string& stem) {
  std::string rate;
  if (outflow.rate) {
    // The steady line goes through the count where its interval begins.
    std::size_t i = 0;
    while (i + 1 < history.time.size() && history.time[i] < outflow.from) ++i;
    rate = ", [" + number_text(outflow.from) + ':' + number_text(outflow.to) + "] " +
           number_text(history.discharged[i]) + '+' + number_text(*outflow.rate) + "*(x-" +
           number_text(history.time[i]) + ") with lines linewidth 2.4 linecolor '" +
           colour::vermilion + "' title 'steady rate'";
  }
  draw_figure(stem, 1.4,
              datablock("n", {history.time, history.discharged}) +
                  "set xlabel 'time since the opening (s)'\nset ylabel 'discharged particles'\n"
                  "set xrange [0:*]\nset yrange [0:*]\nset key bottom right\n"
                  "plot $n using 1:2 with lines linewidth 1.4 linecolor '" +
                  colour::blue + "' title 'counted'" + rate + '\n');
}

void plot_beverloo(const std::vector<WidthSeries>& series, const std::string& stem) {
  std::string blocks, plots;
  const auto add = [&](const std::string& plot) {
    plots += (plots.empty() ? "plot " : ", ") + plot;
  };
  const bool one = series.size() == 1;
  bool titled = false;
  for (std::size_t k = 0; k < series.size(); ++k) {
    const auto& fit = series[k].fit;
    if (!fit) continue;
    add("(x > " + number_text(fit->k) + " ? " + number_text(fit->c) + "*(x-(" +
        number_text(fit->k) + "))**" + number_text(fit->law) +
        " : NaN) with lines linewidth 1.4 linecolor '" +
        (one ? colour::vermilion : series_colour(k)) + "' " +
        (!titled ? "title 'Beverloo, exponent " + number_text(2 * fit->law) + "/2'" : "notitle"));
    titled = true;
  }
  std::vector<double> clogged;
  for (std::size_t k = 0; k < series.size(); ++k) {
    const auto& each = series[k];
    clogged.insert(clogged.end(), each.clogged.begin(), each.clogged.end());
    if (each.width.empty()) continue;
    const auto name = "q" + std::to_string(k);
    blocks += datablock(name, {each.width, each.rate, each.error});
    add("$" + name + " using 1:2:3 with yerrorbars pointtype " + std::to_string(7 + 2 * (k % 4)) +
        " pointsize 1.2 linewidth 1.4 linecolor '" + series_colour(k) + "' title '" +
        (one ? "runs" : each.name) + "'");
  }
  if (!clogged.empty()) {
    blocks += datablock("c", {clogged, std::vector<double>(clogged.size(), 0.0)});
    add("$c using 1:2 with points pointtype 2 pointsize 1.6 linewidth 1.8 linecolor '" +
        std::string(colour::grey) + "' title 'clogged'");
  }
  draw_figure(stem, 1.4,
              blocks +
                  "set xlabel 'width of the orifice, {/:Italic D} / {/:Italic d}_p'\n"
                  "set ylabel 'flow rate, {/:Italic Q} ({/:Italic d}_p / {/:Italic g})^{1/2}'\n"
                  "set offsets 0, graph 0.05, graph 0.05, 0\n"
                  "set xrange [0:*]\nset yrange [0:*]\nset key top left\nset samples 400\n" +
                  plots + '\n');
}

}  // namespace rodpack
