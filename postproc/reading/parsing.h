// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_READING_PARSING_H
#define RODPACK_READING_PARSING_H

#include <charconv>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace rodpack {

// What all that reads text shares: of dumps, tables, JSON, logs and the command line.

/// Takes the next blank-separated word off the front of `rest`; empty at the end.
std::string_view take_word(std::string_view& rest);

/// Reads all of `text` as one number into `value`, a sign before it or none. Returns false, and
/// leaves `value` alone, when it is anything else; "inf" and "nan" are floating-point numbers.
template <class Number>
bool parse_number(std::string_view text, Number& value) {
  // The library's reader knows no '+', which "dump_modify format %+g" writes.
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  const auto* end = text.data() + text.size();
  Number parsed{};
  const auto result = std::from_chars(text.data(), end, parsed);
  if (result.ec != std::errc() || result.ptr != end) return false;
  value = parsed;
  return true;
}

bool starts_with(std::string_view text, std::string_view start);

/// `text` cut off after 60 characters, '?' for what a terminal could take for a command, for error
/// messages.
std::string shortened(std::string_view text);

/// Longest line that the readers take, in characters: anything longer is no table of numbers.
constexpr std::size_t longest_line = 1000000;

/// Place of `name` among the names of columns. `where`: file and line of the names.
/// @throws DataError naming the column and those there are.
std::size_t column_index(const std::vector<std::string>& names, const std::string& name,
                         const std::string& where);

}  // namespace rodpack

#endif
