// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_JSON_TEXT_H
#define RODPACK_JSON_TEXT_H

#include <string>

namespace LAMMPS_NS {

// Values as JSON has them.

/// A text in quotes, without control characters.
std::string json_string(const std::string& text);

/// The shortest text, of six digits or more, that reads back as the same number; null for what is
/// not finite.
std::string json_number(double number);

/// Three numbers in a list.
std::string json_vector(const double (&values)[3]);

}  // namespace LAMMPS_NS

#endif
