// SPDX-License-Identifier: GPL-2.0-or-later
#include "page/report_page.h"

#include <filesystem>

#include "page/run_page.h"
#include "page/study_page.h"
#include "page/study_runs.h"
#include "reading/data_error.h"

namespace rodpack {

std::string write_report_page(const std::string& folder) {
  const std::filesystem::path root(folder);
  if (!std::filesystem::is_directory(root)) throw DataError(folder + ": no such folder");
  if (std::filesystem::exists(root / "parameters.json")) return write_run_page(folder);
  if (is_study(folder)) return write_study_page(folder);
  // Dumps of a deck of one's own, without parameters.
  if (std::filesystem::exists(root / "analysis" / "summary.json")) return write_run_page(folder);
  throw DataError(folder +
                  ": expected the folder of a study (cases.json) or of a run (parameters.json, or "
                  "analysis/summary.json)");
}

}  // namespace rodpack
