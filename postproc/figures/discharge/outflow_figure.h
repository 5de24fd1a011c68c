// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_DISCHARGE_OUTFLOW_FIGURE_H
#define RODPACK_FIGURES_DISCHARGE_OUTFLOW_FIGURE_H

#include <optional>
#include <string>
#include <vector>

#include "analysis/discharge/beverloo_fit.h"
#include "analysis/discharge/outflow.h"

namespace rodpack {

/// Draws the discharged particles of one run over time, with the line of its steady rate, into
/// `stem`.png and .svg.
void plot_outflow(const OutflowHistory& history, const Outflow& outflow, const std::string& stem);

/// Runs of one half angle of the hopper, and their law.
struct WidthSeries {
  std::string name;                        // of the symbols, where there are several series
  std::vector<double> width, rate, error;  // D / d_p, Q sqrt(d_p / g) and its standard error
  std::vector<double> clogged;             // widths of runs that clogged
  std::optional<BeverlooFit> fit;
};

/// Draws Q sqrt(d_p / g) with standard errors over D / d_p, and the law where there is one, into
/// `stem`.png and .svg. Runs that clogged are marked at Q = 0.
void plot_beverloo(const std::vector<WidthSeries>& series, const std::string& stem);

}  // namespace rodpack

#endif
