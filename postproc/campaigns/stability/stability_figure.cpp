// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "campaigns/stability/stability.h"
#include "figures/figure.h"
#include "rodpack/motion/stability_limit.h"

namespace rodpack {

void plot_stability(const std::vector<StabilityLimit>& rows, const std::string& stem) {
  struct CurveStyle {
    const char *title, *colour;
    int point;
  };
  const CurveStyle styles[] = {{"velocity Verlet (built-in)", "#202020", 7},
                               {"Adams–Bashforth 1", "#56B4E9", 5},
                               {"Adams–Bashforth 2", "#009E73", 9},
                               {"Adams–Bashforth 3", colour::vermilion, 13},
                               {"Adams–Bashforth 4", colour::blue, 11}};
  std::string blocks, plots;
  for (int order = 0; order < 5; ++order) {
    std::vector<double> eta, limit, measured_eta, measured;
    for (const auto& row : rows) {
      if (row.order != order) continue;
      measured_eta.push_back(row.damping_ratio);
      measured.push_back(row.limit_measured);
    }
    if (measured.empty()) continue;
    for (int k = 0; k <= 180; ++k) {
      // The points lie closer to 0, where the curve of order 2 is steep.
      eta.push_back(0.9 * (k / 180.0) * (k / 180.0));
      limit.push_back(stability_limit(order, eta.back()));
    }
    const std::string name = std::to_string(order);
    const std::string style = std::string(" linecolor '") + styles[order].colour + "'";
    blocks += datablock("theory" + name, {eta, limit}) +
              datablock("measured" + name, {measured_eta, measured});
    plots += (plots.empty() ? "plot " : ", ") + ("$theory" + name) +
             " using 1:2 with lines linewidth 1.2" + style + ", $measured" + name +
             " using 1:2 with points pointsize 1.1 pointtype " +
             std::to_string(styles[order].point) + style + " title '" + styles[order].title + "'";
  }
  draw_figure(stem, 1.4,
              blocks +
                  "set xlabel 'damping ratio {/:Italic η}'\n"
                  "set ylabel 'largest stable step {/:Italic ω}Δ{/:Italic t}'\n"
                  "set xrange [-0.01:0.91]\nset yrange [0:2.1]\nset xtics 0.2\n"
                  "set key outside top center horizontal maxcols 2 Left reverse\n" +
                  plots + "\n");
}

}  // namespace rodpack
