// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/checks/line_end.h"

#include <fstream>

#include "reading/data_error.h"

namespace rodpack {

void require_line_end(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  char last = '\n';
  if (in.seekg(-1, std::ios::end)) in.get(last);
  if (last != '\n')
    throw DataError(file + ": the file is cut short: its last line has no line end");
}

}  // namespace rodpack
