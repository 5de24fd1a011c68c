// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PAGE_JSON_INPUT_H
#define RODPACK_PAGE_JSON_INPUT_H

#include <nlohmann/json.hpp>
#include <string>

namespace rodpack {

/// Reads a JSON object, its keys in their order. @throws DataError when the file is missing or
/// holds none.
nlohmann::ordered_json read_json_object(const std::string& file);

}  // namespace rodpack

#endif
