// SPDX-License-Identifier: GPL-2.0-or-later
#include "campaigns/launch/deck_folder.h"

#include <filesystem>

#include "reading/data_error.h"

namespace rodpack {

namespace fs = std::filesystem;

std::string find_deck(const std::string& name, const std::string& folder) {
  if (!folder.empty()) {
    const fs::path deck = fs::path(folder) / name;
    if (!fs::exists(deck)) throw DataError(folder + ": expected a folder with the deck " + name);
    return fs::absolute(deck).string();
  }
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path();
  for (fs::path at = program; at != at.root_path(); at = at.parent_path())
    if (fs::exists(at / "inputs" / name)) return (at / "inputs" / name).string();
  const fs::path built_from = fs::path(RODPACK_INPUTS) / name;
  if (!fs::exists(built_from))
    throw DataError("no deck inputs/" + name + " above " + program.string() + ", nor " +
                    built_from.string() + ": name the folder inputs/ with --inputs");
  return built_from.string();
}

}  // namespace rodpack
