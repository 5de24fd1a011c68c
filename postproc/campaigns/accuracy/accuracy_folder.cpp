// SPDX-License-Identifier: GPL-2.0-or-later
#include "campaigns/accuracy/accuracy_folder.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "campaigns/launch/deck_folder.h"
#include "reading/data_error.h"
#include "reading/json_file.h"
#include "reading/text_file.h"

namespace rodpack {

namespace fs = std::filesystem;

namespace {

/// Returns what has to be the same for all rows of a folder.
nlohmann::json common(const AccuracySettings& settings) {
  return {{"liggghts", fs::absolute(settings.liggghts.program).lexically_normal().string()},
          {"inputs", settings.inputs},
          {"steps", settings.steps},
          {"repeats", settings.repeats},
          {"timed_steps", settings.timed_steps},
          {"bed_lines", settings.bed_scene.lines},
          {"bed_per_line", settings.bed_scene.per_line},
          {"bed_aspect_ratio", settings.bed_scene.aspect_ratio},
          {"bed_surface", settings.bed_scene.surface}};
}

bool has_rows(const std::string& file) {
  const std::string text = read_text(file);
  return std::count(text.begin(), text.end(), '\n') > 1;
}

}  // namespace

void claim_folder(const std::string& folder, const AccuracySettings& settings) {
  const std::string file = folder + "/settings.json";
  const auto wanted = common(settings);
  if (!has_rows(folder + "/accuracy.csv") && !has_rows(folder + "/beds.csv")) {
    fs::create_directories(folder);
    write_json(file, wanted);
    return;
  }
  const nlohmann::json found = json_object_if_sound(file);
  if (!found.is_object())
    throw DataError(file + ": expected the settings of the rows in " + folder + ", as JSON");
  for (const auto& [key, value] : wanted.items())
    if (!found.contains(key) || found.at(key) != value)
      throw DataError(file + ": " + key + " is " +
                      (found.contains(key) ? found.at(key).dump() : std::string("missing")) +
                      ", expected " + value.dump() + ": other settings need another folder");
}

Table resume_table(const std::string& file, const std::string& header) {
  const std::string all = read_text(file);
  const auto last = all.rfind('\n');
  if (last == std::string::npos)
    write_text(file, header + "\n");
  else if (last + 1 < all.size())
    write_text(file, all.substr(0, last + 1));
  return read_table(file, header);
}

std::string run_accuracy_deck(const AccuracySettings& settings, const std::string& folder,
                              const std::string& deck, const DeckVariables& variables) {
  const std::string work = folder + "/work";
  for (const char* left : {"/end.dump", "/contacts.dump", "/energies.txt"}) fs::remove(work + left);
  return run_deck(settings.liggghts, find_deck("accuracy/" + deck, settings.inputs), variables,
                  work);
}

}  // namespace rodpack
