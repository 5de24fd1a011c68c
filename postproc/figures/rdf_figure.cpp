// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/rdf_figure.h"

#include <limits>

#include "figures/figure.h"
#include "reading/number_text.h"

namespace rodpack {

std::vector<double> drawn_g(const Rdf& rdf) {
  auto g = rdf.g;
  for (std::size_t k = 0; k < rdf.expected.size(); ++k)
    if (!(rdf.expected[k] > 0)) g[k] = std::numeric_limits<double>::quiet_NaN();
  return g;
}

void plot_rdf(const Rdf& rdf, const std::string& stem) {
  const std::string style = std::string(" linecolor '") + colour::blue + "'";
  draw_figure(stem, 1.4,
              datablock("g", {rdf.r, drawn_g(rdf), rdf.standard_error}) +
                  "set xlabel 'distance {/:Italic r} / {/:Italic d}_p'\n"
                  "set ylabel 'radial distribution function {/:Italic G}({/:Italic r})'\n"
                  "set key outside top right horizontal\n"
                  "set yrange [0:*]\nset xrange [0:" +
                  number_text(rdf.r.back() + rdf.r.front()) +
                  "]\n"
                  "plot 1 with lines dashtype 2 linewidth 1 linecolor '" +
                  colour::grey + "', " +
                  "$g using 1:($2-$3):($2+$3) with filledcurves fillstyle transparent solid 0.25" +
                  style + " title '± standard error', $g using 1:2 with lines linewidth 1.3" +
                  style + " title '{/:Italic G}({/:Italic r})'\n");
}

}  // namespace rodpack
