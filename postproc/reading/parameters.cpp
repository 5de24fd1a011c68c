// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/parameters.h"

#include <filesystem>
#include <fstream>

#include "reading/dump.h"

namespace rodpack {

double RunParameters::number(const std::string& key) const {
  const auto found = values.find(key);
  if (found == values.end()) throw DataError(file + ": no key '" + key + "'");
  if (!found->is_number())
    throw DataError(file + ": key '" + key + "': expected a number, found " + found->dump());
  return found->get<double>();
}

RunParameters read_parameters(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw DataError(file + ": no such file, or it cannot be read");
  auto values = nlohmann::json::parse(in, nullptr, false);
  if (!values.is_object())
    throw DataError(file + ": expected a JSON object { \"key\": value, ... }");
  return {file, std::move(values)};
}

std::optional<RunParameters> find_parameters(const std::string& dump, const std::string& given) {
  if (!given.empty()) return read_parameters(given);
  const auto folder = std::filesystem::absolute(dump).parent_path();
  for (const auto& candidate : {folder, folder.parent_path()}) {
    const auto path = candidate / "parameters.json";
    if (std::filesystem::exists(path)) return read_parameters(path.string());
  }
  return std::nullopt;
}

}  // namespace rodpack
