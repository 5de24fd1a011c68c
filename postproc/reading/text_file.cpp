// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/text_file.h"

#include <fstream>
#include <iterator>

#include "reading/data_error.h"

namespace rodpack {

std::string read_text(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void write_text(const std::string& file, const std::string& content) {
  std::ofstream out(file, std::ios::binary);
  out << content;
  out.close();
  if (!out) throw DataError(file + ": cannot be written");
}

void append_line(const std::string& file, const std::string& line) {
  std::ofstream out(file, std::ios::app | std::ios::binary);
  out << line << '\n' << std::flush;
  if (!out) throw DataError(file + ": cannot be written");
}

}  // namespace rodpack
