// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_READING_PARAMETERS_H
#define RODPACK_READING_PARAMETERS_H

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace rodpack {

/// The parameters.json that a simulation leaves in its run folder: a flat object, SI units in the
/// names of the keys.
struct RunParameters {
  std::string file;
  nlohmann::json values;

  /// Returns the value of a key, in the unit that its name says. @throws DataError naming file and
  /// key when it is missing or no number in the range of that parameter.
  double number(const std::string& key) const;
  /// The same of a number that has to be above 0.
  double positive_number(const std::string& key) const;
};

/// Reads the parameters in `file`. @throws DataError as read_json_object(), and when the key
/// 'units' is there and not "si".
RunParameters read_parameters(const std::string& file);

/// Reads the parameters.json at `given`, or, when that is empty, in the folder of `dump` or the one
/// above it, if there is one. @throws DataError as read_parameters().
std::optional<RunParameters> find_parameters(const std::string& dump, const std::string& given);

}  // namespace rodpack

#endif
