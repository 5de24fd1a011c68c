// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PAGE_RUN_PAGE_H
#define RODPACK_PAGE_RUN_PAGE_H

#include <string>

namespace rodpack {

/// Writes `run_folder`/analysis/report.html: parameters, results in words and units, the packing to
/// be zoomed and asked, all figures of the analysis, notes. Returns the file's name.
/// @throws DataError when the run has not been analysed, or a file cannot be read or written.
std::string write_run_page(const std::string& run_folder);

}  // namespace rodpack

#endif
