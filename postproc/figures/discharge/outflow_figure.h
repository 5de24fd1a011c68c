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

/// Draws Q sqrt(d_p / g) with standard errors over D / d_p, and the law where there is one, into
/// `stem`.png and .svg. `clogged`: widths of runs that clogged, marked at Q = 0.
void plot_beverloo(const std::vector<double>& width, const std::vector<double>& rate,
                   const std::vector<double>& rate_error, const std::vector<double>& clogged,
                   const std::optional<BeverlooFit>& fit, const std::string& stem);

}  // namespace rodpack

#endif
