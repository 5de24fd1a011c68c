// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/contact_forces_figure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "figures/figure.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {

void plot_distributions(const ContactForces& forces, const std::string& stem) {
  double lowest = std::numeric_limits<double>::max();
  for (const auto* each : {&forces.normal, &forces.tangential})
    for (const double density : each->density)
      if (density > 0) lowest = std::min(lowest, density);
  const double bottom = lowest / 2;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  // A logarithmic axis has no place for empty bins, which part the line, nor for the lower end of a
  // bar that reaches 0.
  const auto curve = [&](const std::string& name, const ForceDistribution& each) {
    std::vector<std::vector<double>> columns(4);
    for (std::size_t k = 0; k < each.density.size(); ++k) {
      columns[0].push_back(forces.force_over_mean[k]);
      columns[1].push_back(each.density[k] > 0 ? each.density[k] : none);
      columns[2].push_back(std::max(each.density[k] - each.standard_error[k], bottom));
      columns[3].push_back(each.density[k] + each.standard_error[k]);
    }
    const bool any = std::any_of(each.density.begin(), each.density.end(),
                                 [](double density) { return density > 0; });
    return any ? datablock(name, columns) : std::string();
  };
  const auto normal = curve("normal", forces.normal);
  const auto tangential = curve("tangential", forces.tangential);
  const auto plot = [](const std::string& name, const std::string& look, const std::string& title) {
    return ", $" + name + " using 1:2:3:4 with yerrorbars pointtype " + look + " linewidth 0.8, $" +
           name + " using 1:2 with linespoints linewidth 1.2 pointtype " + look + " title '" +
           title + "'";
  };
  const std::string points = " pointsize 0.7 linecolor '";
  draw_figure(stem, 1.4,
              normal + tangential +
                  "set xlabel 'force {/:Italic f} / ⟨{/:Italic f} ⟩'\n"
                  "set ylabel 'probability density {/:Italic P}({/:Italic f} / ⟨{/:Italic f} ⟩)'\n"
                  "set key outside top right horizontal\n"
                  "set logscale y\nset format y '10^{%T}'\nset mytics 10\n"
                  "set xrange [0:" +
                  number_text(forces.force_over_mean.back() + forces.force_over_mean.front()) +
                  "]\nset yrange [" + number_text(bottom) + ":*]\n" +
                  "plot exp(-x) with lines dashtype 2 linewidth 1 linecolor '" + colour::grey +
                  "' title 'e^{-x}'" + plot("normal", "7" + points + colour::blue + "'", "normal") +
                  (tangential.empty()
                       ? ""
                       : plot("tangential", "5" + points + colour::vermilion + "'", "tangential")) +
                  "\n");
}

void plot_friction(const MobilisedFriction& friction, const std::string& stem) {
  const double width = 1 / static_cast<double>(friction.centre.size());
  draw_figure(stem, 1.4,
              datablock("h", {friction.centre, friction.density, friction.standard_error}) +
                  "set xlabel 'mobilised friction {/:Italic f}_t / ({/:Italic μ f}_n)'\n"
                  "set ylabel 'probability density'\n"
                  "set xrange [0:1]\nset yrange [0:*]\nset boxwidth " +
                  number_text(width) + "\n" +
                  "plot $h using 1:2 with boxes linecolor '#8CBBD9', "
                  "$h using ($3 > 0 ? $1 : NaN):($2-$3):(0):(2*$3) with vectors heads size " +
                  number_text(width / 4) + ",90 linewidth 0.8 linecolor '" + colour::blue + "'\n");
}

void plot_coordination(const Coordination& coordination, const std::string& stem) {
  const double n = static_cast<double>(coordination.particles);
  std::vector<double> touching, contacts;
  for (std::size_t k = 0; k < coordination.number.size(); ++k) {
    touching.push_back(coordination.with_touching_particles[k] / n);
    contacts.push_back(coordination.with_contacts[k] / n);
  }
  draw_figure(stem, 1.4,
              datablock("h", {coordination.number, touching, contacts}) +
                  "set xlabel 'number per particle'\n"
                  "set ylabel 'fraction of particles'\n"
                  "set key outside top right horizontal\nset mxtics 1\n"
                  "set xrange [-0.6:" +
                  number_text(coordination.number.back() + 0.6) +
                  "]\nset yrange [0:*]\nset boxwidth 0.4\n" +
                  "plot $h using ($1-0.2):2 with boxes linecolor '" + colour::blue +
                  "' title 'touching particles', $h using ($1+0.2):3 with boxes linecolor '" +
                  colour::vermilion + "' title 'sphere contacts'\n");
}

}  // namespace

void plot_contact_forces(const ContactForces& forces, const std::string& stem) {
  plot_distributions(forces, stem);
  if (forces.friction) plot_friction(*forces.friction, stem + "_friction");
  plot_coordination(forces.coordination, stem + "_coordination");
}

}  // namespace rodpack
