// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/energies_figure.h"

#include "figures/figure.h"
#include "reading/data_error.h"

namespace rodpack {

void plot_energies(const EnergyHistory& energies, const std::string& source,
                   const std::string& stem) {
  bool drawable = false;
  for (std::size_t i = 0; i < energies.time.size(); ++i)
    drawable = drawable || energies.kinetic[i] > 0 || energies.elastic[i] > 0;
  if (!drawable) throw DataError(source + ": no positive energy to draw");
  draw_figure(stem, 1.4,
              datablock("energies", {energies.time, energies.kinetic, energies.elastic}) +
                  "set xlabel 'time (s)'\nset ylabel 'energy (J)'\n"
                  "set logscale y\nset format y '10^{%T}'\nset mytics 10\n"
                  "set key outside top center horizontal\nset autoscale xfix\n"
                  "positive(e) = e > 0 ? e : NaN\n"
                  "plot $energies using 1:(positive($2)) with lines linewidth 1.4 linecolor '" +
                  colour::vermilion + "' title 'kinetic {/:Italic E}_k', " +
                  "$energies using 1:(positive($3)) with lines linewidth 1.4 linecolor '" +
                  colour::blue + "' title 'elastic {/:Italic E}_p'\n");
}

}  // namespace rodpack
