// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_READING_TEXT_FILE_H
#define RODPACK_READING_TEXT_FILE_H

#include <string>

namespace rodpack {

/// Returns the contents of `file`, empty when there is none.
std::string read_text(const std::string& file);

/// Writes `content` to `file`, replacing it. @throws DataError when that fails.
void write_text(const std::string& file, const std::string& content);

/// Adds `line` and a line end to `file`, and has it written at once.
/// @throws DataError when that fails.
void append_line(const std::string& file, const std::string& line);

}  // namespace rodpack

#endif
