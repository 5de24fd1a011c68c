// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/discharge/hopper_figure.h"

#include <map>

#include "figures/figure.h"
#include "reading/number_text.h"

namespace rodpack {

void plot_hopper_factors(const std::vector<HopperFactor>& factors, const std::string& stem) {
  std::map<double, std::vector<std::vector<double>>> by_width;  // columns of the figure
  for (const auto& each : factors) {
    auto& columns = by_width[each.width];
    columns.resize(3);
    columns[0].push_back(each.half_angle);
    columns[1].push_back(each.factor);
    columns[2].push_back(each.factor_error);
  }
  std::vector<double> angle, law;
  for (int a = 5; a <= 90; ++a) {
    angle.push_back(a);
    law.push_back(rose_tanaka_factor(a));
  }
  std::string blocks = datablock("law", {angle, law});
  std::string plots = "plot $law using 1:2 with lines linewidth 1.4 linecolor '" +
                      std::string(colour::vermilion) +
                      "' title 'Rose and Tanaka, {/:Italic φ}_d = 45°'";
  int k = 0;
  for (const auto& [width, columns] : by_width) {
    const auto name = "w" + std::to_string(++k);
    blocks += datablock(name, columns);
    plots += ", $" + name + " using 1:2:3 with yerrorbars pointtype " + std::to_string(2 * k + 3) +
             " pointsize 1.2 linewidth 1.4 linecolor '" +
             (k % 2 == 1 ? colour::blue : colour::grey) +
             "' title '{/:Italic D} = " + number_text(width, 3) + " {/:Italic d}_p'";
  }
  draw_figure(stem, 1.4,
              blocks +
                  "set xlabel 'half angle of the hopper (degrees)'\n"
                  "set ylabel 'flow rate over that above a flat bottom'\n"
                  "set xrange [0:90]\nset yrange [0:*]\nset xtics 15\nset key top right\n" +
                  plots + '\n');
}

}  // namespace rodpack
