// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CAMPAIGNS_LAUNCH_DECK_FOLDER_H
#define RODPACK_CAMPAIGNS_LAUNCH_DECK_FOLDER_H

#include <string>

namespace rodpack {

/// Finds the file `name` (such as "comparison/in.comparison") of the repository's inputs/.
/// `folder`: that folder inputs/; empty: the first one that holds the deck in the folders above the
/// running program, else that of the repository it was built from.
/// @throws DataError naming the deck and where it was looked for.
std::string find_deck(const std::string& name, const std::string& folder);

}  // namespace rodpack

#endif
