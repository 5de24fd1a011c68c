// SPDX-License-Identifier: GPL-2.0-or-later
#include "page/json_input.h"

#include <filesystem>

#include "reading/data_error.h"
#include "reading/text_file.h"

namespace rodpack {

nlohmann::ordered_json read_json_object(const std::string& file) {
  if (!std::filesystem::exists(file)) throw DataError(file + ": no such file");
  auto json = nlohmann::ordered_json::parse(read_text(file), nullptr, false);
  if (!json.is_object()) throw DataError(file + ": expected a JSON object");
  return json;
}

}  // namespace rodpack
