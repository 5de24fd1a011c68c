// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_READING_WILDCARD_H
#define RODPACK_READING_WILDCARD_H

#include <string>
#include <vector>

namespace rodpack {

/// Whether a name holds a character of a wildcard pattern: * ? [.
bool is_wildcard(const std::string& name);

/// Returns what `pattern` stands for, in alphabetical order: the file of just that name if there is
/// one, else all that match. Part by part of the path, a name that exists is no pattern, so that
/// run[1]/dumps/bodies.*.dump are the dumps of the folder run[1], never of run1. As in a shell,
/// wildcards pass over names that begin with a dot.
std::vector<std::string> files_matching(const std::string& pattern);

}  // namespace rodpack

#endif
