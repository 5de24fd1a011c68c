// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/csv_file.h"

#include "reading/number_text.h"
#include "reading/text_file.h"

namespace rodpack {

void write_csv(const std::string& file,
               const std::vector<std::pair<std::string, std::vector<double>>>& columns) {
  std::string text;
  for (const auto& [name, values] : columns) text += (text.empty() ? "" : ",") + name;
  text += '\n';
  for (std::size_t row = 0; row < columns.front().second.size(); ++row)
    for (std::size_t c = 0; c < columns.size(); ++c)
      text += number_text(columns[c].second[row]) + (c + 1 < columns.size() ? ',' : '\n');
  write_text(file, text);
}

std::string csv_line(const std::vector<std::string>& fields) {
  std::string line;
  for (std::size_t c = 0; c < fields.size(); ++c) line += (c > 0 ? "," : "") + fields[c];
  return line;
}

std::string csv_number(const std::optional<double>& value, int significant_digits) {
  return value ? number_text(*value, significant_digits) : "";
}

}  // namespace rodpack
