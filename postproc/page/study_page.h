// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PAGE_STUDY_PAGE_H
#define RODPACK_PAGE_STUDY_PAGE_H

#include <string>

namespace rodpack {

/// Writes `folder`/report.html, the page of a study, or of what "rodpack ensemble -o" wrote: what
/// was run, solid fractions beside published values, claims with their verdicts, figures, numbers,
/// packings to be asked (of each case the run of the lowest seed), cost, notes. Returns the file's
/// name.
/// @throws DataError when ensemble.json is missing, or a file cannot be read or written.
std::string write_study_page(const std::string& folder);

}  // namespace rodpack

#endif
