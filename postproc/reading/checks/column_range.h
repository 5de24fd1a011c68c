// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_READING_CHECKS_COLUMN_RANGE_H
#define RODPACK_READING_CHECKS_COLUMN_RANGE_H

#include <string>

#include "reading/checks/number_range.h"

namespace rodpack {

/// Returns the range of the column of that name in dumps of bodies, spheres and contacts, in the
/// column's unit; of a column that is not ours, null: any finite number. The limits are far beyond
/// every packing of grains, and keep what is computed from them finite: a value outside is a
/// damaged file or another unit.
const NumberRange* column_range(const std::string& name);

/// 0, 1, 2 when the column holds a place along x, y, z, which has to lie about the box; else -1.
int place_axis(const std::string& name);

}  // namespace rodpack

#endif
