// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/json_file.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <vector>

#include "reading/data_error.h"
#include "reading/parsing.h"
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

// Functions that walk through JSON call themselves, the library's too: unlimited depth would let a
// file overflow the stack.
constexpr int deepest = 32;

Json parse(const std::string& text, const std::string& file) {
  std::vector<std::set<std::string>> keys(deepest + 2);  // of the objects that are open
  const auto watch = [&](int depth, Json::parse_event_t event, Json& parsed) {
    if (depth > deepest)
      throw DataError(file + ": expected JSON at most " + std::to_string(deepest) +
                      " objects and lists deep, found a deeper one");
    const auto level = static_cast<std::size_t>(depth);
    if (event == Json::parse_event_t::object_start) keys[level + 1].clear();
    if (event == Json::parse_event_t::key) {
      const auto key = parsed.get<std::string>();
      if (!keys[level].insert(key).second)
        throw DataError(file + ": expected each key once in an object, found '" + shortened(key) +
                        "' twice");
    }
    return true;
  };
  try {
    return Json::parse(text, watch);
  } catch (const Json::parse_error& error) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
    throw DataError(file + ":" + std::to_string(1 + std::count(text.begin(), end, '\n')) +
                    ": expected a JSON object, found an error in it here");
  } catch (const Json::exception& error) {  // a number that is too large
    throw DataError(file + ": expected a JSON object, found " + shortened(error.what()));
  }
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
  if (!std::filesystem::is_regular_file(file))
    throw DataError(file + ": no such file, or it cannot be read");
  auto json = parse(read_text(file), file);
  if (!json.is_object()) throw DataError(file + ": expected a JSON object { \"key\": value, ... }");
  return json;
}

nlohmann::ordered_json json_object_if_sound(const std::string& file) {
  try {
    return read_json_object(file);
  } catch (const DataError&) {
    return nullptr;
  }
}

}  // namespace rodpack
