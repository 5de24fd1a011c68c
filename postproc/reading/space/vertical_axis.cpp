// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/space/vertical_axis.h"

#include <string>

#include "reading/data_error.h"
#include "reading/parsing.h"

namespace rodpack {

std::optional<std::size_t> vertical_axis(const RunParameters& parameters) {
  const auto found = parameters.values.find("vertical_axis");
  if (found == parameters.values.end()) return std::nullopt;
  for (const std::size_t axis : {0U, 1U, 2U})
    if (*found == std::string(1, "xyz"[axis])) return axis;
  throw DataError(parameters.file +
                  ": key 'vertical_axis': expected \"x\", \"y\" or \"z\", found " +
                  shortened(found->dump()));
}

}  // namespace rodpack
