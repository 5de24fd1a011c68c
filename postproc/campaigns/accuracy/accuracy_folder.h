// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ACCURACY_FOLDER_H
#define RODPACK_ACCURACY_FOLDER_H

#include <string>
#include <vector>

#include "campaigns/accuracy/accuracy.h"

namespace rodpack {

/// Makes `folder` the one of these settings. @throws DataError when it is that of others.
void claim_folder(const std::string& folder, const AccuracySettings& settings);

/// Fields of each row of a CSV file, which begins with `header`; a missing file is made. A last
/// line that was cut short is removed from the file. @throws DataError for another header or number
/// of fields.
std::vector<std::vector<std::string>> read_fields(const std::string& file,
                                                  const std::string& header);
/// @throws DataError when the line cannot be written.
void append_line(const std::string& file, const std::string& line);

/// Runs a deck of `settings.inputs`/accuracy in `folder`/work. Returns what it printed.
std::string run_accuracy_deck(const AccuracySettings& settings, const std::string& folder,
                              const std::string& deck, const DeckVariables& variables);

}  // namespace rodpack

#endif
