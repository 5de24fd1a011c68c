// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ENSEMBLE_RUN_ANALYSIS_H
#define RODPACK_ENSEMBLE_RUN_ANALYSIS_H

#include <nlohmann/json.hpp>
#include <string>

#include "ensemble/cases.h"

namespace rodpack {

/// Says why the run's analysis/ cannot be used: there is none, it is of another version of rodpack
/// or of its tables, older than result.json, or of other parameters or another frame than the
/// run's last. Empty when it can.
std::string why_not_current(const FinishedRun& run);

/// Reads analysis/summary.json of a run whose analysis is current. @throws DataError when it is
/// not.
nlohmann::json read_summary(const FinishedRun& run);

}  // namespace rodpack

#endif
