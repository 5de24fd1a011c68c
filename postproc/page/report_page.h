// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PAGE_REPORT_PAGE_H
#define RODPACK_PAGE_REPORT_PAGE_H

#include <string>

namespace rodpack {

/// Writes the page of a study's folder (see write_study_page()) to `folder`/report.html, or of
/// a run folder (with parameters.json) to `folder`/analysis/report.html. Returns the file's name.
/// @throws DataError when the folder is neither, has not been analysed, or a file cannot be read or
///   written.
std::string write_report_page(const std::string& folder);

}  // namespace rodpack

#endif
