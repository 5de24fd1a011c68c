// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/space/axial_rdf_figure.h"

#include <algorithm>

#include "figures/drawing.h"
#include "figures/edges/map_drawing.h"
#include "figures/figure.h"
#include "reading/number_text.h"

namespace rodpack {

void plot_axial_rdf(const AxialRdf& rdf, const std::string& stem) {
  const double edge = *std::max_element(rdf.along.begin(), rdf.along.end()) + rdf.bin_width / 2;
  const std::string end = number_text(edge), width = number_text(rdf.bin_width);
  const double top = std::max(1.0, quantile_99(rdf.g));
  std::string commands = datablock("map", {rdf.along, rdf.across, rdf.g}) + palette_command();
  commands +=
      "set size ratio -1\nset tics out nomirror\n"
      "set xlabel 'along the axis / {/:Italic d}_p'\n"
      "set ylabel 'across the axis / {/:Italic d}_p'\n"
      "set cblabel 'pair correlation {/:Italic g}, to its 99 % quantile' offset 1,0\n";
  commands += "set cbrange [0:" + number_text(top, 3) + "]\n";
  commands += "set xrange [0:" + end + "]\nset yrange [0:" + end + "]\n";
  commands += "set boxwidth " + width + "\n";
  commands += "plot $map using 1:2:(" + number_text(rdf.bin_width / 2) + "):(" +
              number_text(rdf.bin_width / 2) + "):3 with boxxyerror linecolor palette\n";
  draw_figure(stem, 1.2, commands);
}

}  // namespace rodpack
