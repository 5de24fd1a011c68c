// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PAGE_STUDY_RESULTS_H
#define RODPACK_PAGE_STUDY_RESULTS_H

#include <string>

#include "page/study_runs.h"

namespace rodpack {

// What a study's folder `ensemble` holds, in HTML. A file that is missing is named, with the
// command that makes it.

/// table2.csv: solid fractions beside published values.
std::string solid_fraction_html(const Study& study);

/// claims.json: every claim of the paper with its test and verdict.
std::string claims_html(const Study& study);

/// All figures, with the captions that figures.json gives them, and those not drawn.
std::string study_figures_html(const Study& study);

/// Every number of every case: mean and standard error, in tables by theme.
std::string numbers_html(const Study& study);

}  // namespace rodpack

#endif
