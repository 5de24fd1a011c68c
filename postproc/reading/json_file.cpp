// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/json_file.h"

#include <algorithm>
#include <filesystem>

#include "reading/data_error.h"
#include "reading/text_file.h"
#include "rodpack/version.h"

namespace rodpack {
namespace {
using Json = nlohmann::ordered_json;

bool is_list_of_numbers(const Json& json) {
  return json.is_array() && std::all_of(json.begin(), json.end(), [](const Json& each) {
           return each.is_number() || each.is_null();
         });
}

// As Json::dump(2), but for the lists of numbers, which it gives a line for each.
void append(std::string& text, const Json& json, const std::string& indent) {
  if (json.empty() || !json.is_structured() || is_list_of_numbers(json)) {
    text += json.dump();
    return;
  }
  const bool object = json.is_object();
  text += object ? "{" : "[";
  const char* separator = "\n";
  for (const auto& item : json.items()) {
    text += separator + indent + "  ";
    if (object) text += Json(item.key()).dump() + ": ";
    append(text, item.value(), indent + "  ");
    separator = ",\n";
  }
  text += "\n" + indent + (object ? "}" : "]");
}

}  // namespace

void write_json(const std::string& file, const nlohmann::ordered_json& content) {
  nlohmann::ordered_json signed_content = content;
  signed_content["rodpack"] = {{"version", version()}, {"commit", commit()}};
  std::string text;
  append(text, signed_content, "");
  write_text(file, text + "\n");
}

nlohmann::ordered_json read_json_object(const std::string& file) {
  if (!std::filesystem::exists(file)) throw DataError(file + ": no such file");
  auto json = Json::parse(read_text(file), nullptr, false);
  if (!json.is_object()) throw DataError(file + ": expected a JSON object");
  return json;
}

}  // namespace rodpack
