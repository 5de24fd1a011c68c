// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/mixture/partial_rdf_figure.h"

#include <limits>

#include "figures/figure.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {

// Okabe and Ito's, after colour::blue and colour::vermilion.
constexpr const char* curve_colours[most_partial_curves] = {
    colour::blue, colour::vermilion, "#009E73", "#CC79A7", "#E69F00", "#56B4E9"};

std::vector<double> seen_alone(std::vector<double> g, const std::vector<double>& expected) {
  for (std::size_t k = 0; k < g.size(); ++k)
    if (!(expected[k] > 0)) g[k] = std::numeric_limits<double>::quiet_NaN();
  return g;
}

}  // namespace

void plot_partial_rdf(const PartialRdf& rdf, const Mixture& mixture, const std::string& stem) {
  std::string blocks = datablock("total", {rdf.r, seen_alone(rdf.total, rdf.expected)});
  std::string plots = "plot 1 with lines dashtype 2 linewidth 1 linecolor '" +
                      std::string(colour::grey) +
                      "' notitle, $total using 1:2 with lines "
                      "linewidth 1 linecolor '" +
                      colour::grey + "' title 'all'";
  for (std::size_t k = 0; k < rdf.pairs.size() && k < most_partial_curves; ++k) {
    const auto& pair = rdf.pairs[k];
    const auto name = "pair" + std::to_string(k);
    blocks += datablock(name, {rdf.r, seen_alone(pair.g, pair.expected)});
    plots += ", $" + name + " using 1:2 with lines linewidth 1.3 linecolor '" + curve_colours[k] +
             "' title '" + mixture.species[pair.a].name + " – " + mixture.species[pair.b].name +
             "'";
  }
  draw_figure(stem, 1.4,
              blocks +
                  "set xlabel 'distance {/:Italic r} / {/:Italic d}_p'\n"
                  "set ylabel 'partial {/:Italic G}({/:Italic r})'\n"
                  "set key noenhanced outside top center horizontal\n"
                  "set yrange [0:*]\nset xrange [0:" +
                  number_text(rdf.r.back() + rdf.r.front()) + "]\n" + plots + "\n");
}

}  // namespace rodpack
