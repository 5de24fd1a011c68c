// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_READING_JSON_FILE_H
#define RODPACK_READING_JSON_FILE_H

#include <nlohmann/json.hpp>
#include <string>

namespace rodpack {

/// Writes `content`, a JSON object, to `file`, replacing it: keys in their order, then "rodpack"
/// with its version and commit, indented by two, a list of numbers on one line. Every JSON file of
/// the post-processor is written here.
/// @throws DataError when that fails.
void write_json(const std::string& file, const nlohmann::ordered_json& content);

/// Reads a JSON object, its keys in their order. Every JSON file is read here, or by the next.
/// @throws DataError naming file and line when the file is missing, is not JSON, holds a number
///   that no double can hold, a key twice in one object, or objects and lists more than 32 deep;
///   and when it holds no object.
nlohmann::ordered_json read_json_object(const std::string& file);

/// The same, but null where the file cannot be used.
nlohmann::ordered_json json_object_if_sound(const std::string& file);

}  // namespace rodpack

#endif
