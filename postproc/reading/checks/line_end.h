// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_READING_CHECKS_LINE_END_H
#define RODPACK_READING_CHECKS_LINE_END_H

#include <string>

namespace rodpack {

/// @throws DataError naming the file when it does not end in a line end: what programs write line
/// by line does, and a last field that was cut short may still look like a number. An empty file
/// and one that cannot be read pass.
void require_line_end(const std::string& file);

}  // namespace rodpack

#endif
