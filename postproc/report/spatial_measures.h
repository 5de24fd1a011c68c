// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_REPORT_SPATIAL_MEASURES_H
#define RODPACK_REPORT_SPATIAL_MEASURES_H

#include <filesystem>
#include <nlohmann/json.hpp>

#include "reading/space/spatial_packing.h"
#include "report/measures.h"

namespace rodpack {

/// The part of analyse_run(), the only one that includes this, for a scene in space: orientation,
/// G(r), pair correlation along and across the axis, solid fraction over height, contact forces,
/// fabric, stresses over depth and fields on a grid with their maps, each with its table and
/// figures in the folder `out` and its numbers in `summary`. What cannot be measured goes into the
/// summary's "notes" with the reason. `time`: s, or the timestep where that is not known. Returns
/// how many measures were made.
/// @throws DataError when drawing fails or a column of the contacts is malformed.
int report_in_space(const SpatialPacking& packing, const Frame& bodies,
                    const MeasuredContacts& contacts, double time, const std::filesystem::path& out,
                    nlohmann::ordered_json& summary);

}  // namespace rodpack

#endif
