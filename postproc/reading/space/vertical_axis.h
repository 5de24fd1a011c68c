// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_READING_SPACE_VERTICAL_AXIS_H
#define RODPACK_READING_SPACE_VERTICAL_AXIS_H

#include <cstddef>
#include <optional>

#include "reading/parameters.h"

namespace rodpack {

/// Returns which axis points up, 0 to 2, as the key 'vertical_axis' of scenes in space states; none
/// in a plane. @throws DataError naming file and key when it is none of x, y, z.
std::optional<std::size_t> vertical_axis(const RunParameters& parameters);

}  // namespace rodpack

#endif
