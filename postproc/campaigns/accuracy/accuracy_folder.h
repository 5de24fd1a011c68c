// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CAMPAIGNS_ACCURACY_ACCURACY_FOLDER_H
#define RODPACK_CAMPAIGNS_ACCURACY_ACCURACY_FOLDER_H

#include <string>

#include "campaigns/accuracy/accuracy.h"
#include "reading/table.h"

namespace rodpack {

/// Makes `folder` the one of these settings. @throws DataError when it is that of others.
void claim_folder(const std::string& folder, const AccuracySettings& settings);

/// The rows of a CSV file to which an interrupted campaign comes back, `header` its first line; a
/// missing file is made with the header alone. A last line that was cut short is removed from the
/// file. @throws DataError for another header or number of fields.
Table resume_table(const std::string& file, const std::string& header);

/// Runs a deck of `settings.inputs`/accuracy in `folder`/work. Returns what it printed.
std::string run_accuracy_deck(const AccuracySettings& settings, const std::string& folder,
                              const std::string& deck, const DeckVariables& variables);

}  // namespace rodpack

#endif
