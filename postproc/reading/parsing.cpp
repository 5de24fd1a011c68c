// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/parsing.h"

#include <algorithm>

#include "reading/data_error.h"

namespace rodpack {

std::string_view take_word(std::string_view& rest) {
  const auto begin = std::min(rest.find_first_not_of(" \t"), rest.size());
  const auto end = std::min(rest.find_first_of(" \t", begin), rest.size());
  const auto word = rest.substr(begin, end - begin);
  rest.remove_prefix(end);
  return word;
}

bool starts_with(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

std::string shortened(std::string_view text) {
  constexpr std::size_t longest = 60;
  return text.size() <= longest ? std::string(text) : std::string(text.substr(0, longest)) + "...";
}

std::size_t column_index(const std::vector<std::string>& names, const std::string& name,
                         const std::string& where) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    std::string message = where + ": no column '" + name + "'; the columns are:";
    for (const auto& each : names) message += " " + each;
    throw DataError(message);
  }
  return static_cast<std::size_t>(found - names.begin());
}

}  // namespace rodpack
