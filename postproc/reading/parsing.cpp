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
  std::string result(text.substr(0, longest));
  for (char& each : result)
    if (static_cast<unsigned char>(each) < ' ' || each == 127) each = '?';
  return text.size() <= longest ? result : result + "...";
}

std::size_t column_index(const std::vector<std::string>& names, const std::string& name,
                         const std::string& where) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    std::string message = where + ": no column '" + name + "'; the columns are:";
    constexpr std::size_t most = 50;
    for (std::size_t k = 0; k < names.size() && k < most; ++k) message += " " + shortened(names[k]);
    throw DataError(message + (names.size() > most ? " ..." : ""));
  }
  return static_cast<std::size_t>(found - names.begin());
}

}  // namespace rodpack
