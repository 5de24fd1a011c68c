// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/deck_folder.h"

#include <filesystem>

#include "rodpack/data_error.h"

namespace rodpack {

namespace fs = std::filesystem;

std::string find_deck(const std::string& name, const std::string& folder) {
  if (!folder.empty()) {
    const fs::path deck = fs::path(folder) / name;
    if (!fs::exists(deck)) throw DataError(folder + ": expected a folder with the deck " + name);
    return fs::absolute(deck).string();
  }
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path();
  for (const fs::path& start : {program, fs::current_path()})
    for (fs::path at = start;; at = at.parent_path()) {
      const fs::path deck = at / "inputs" / name;
      if (fs::exists(deck)) return deck.string();
      if (at == at.parent_path()) break;
    }
  throw DataError("no deck inputs/" + name + " above " + program.string() + " or " +
                  fs::current_path().string() + ": name the folder inputs/ with --inputs");
}

}  // namespace rodpack
