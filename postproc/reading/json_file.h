// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_READING_JSON_FILE_H
#define RODPACK_READING_JSON_FILE_H

#include <nlohmann/json.hpp>
#include <string>

namespace rodpack {

/// Writes `content`, a JSON object, to `file`, replacing it: keys in their order, indented by two.
/// Every JSON file of the post-processor is written here, so what all of them have to say belongs
/// here too. @throws DataError when that fails.
void write_json(const std::string& file, const nlohmann::ordered_json& content);

}  // namespace rodpack

#endif
