// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_REPORT_MIXTURE_MEASURES_H
#define RODPACK_REPORT_MIXTURE_MEASURES_H

#include <filesystem>
#include <nlohmann/json.hpp>

#include "reading/space/spatial_packing.h"
#include "report/measures.h"

namespace rodpack {

/// The part of analyse_run(), the only one that includes this, for a mixture: composition, S2 and
/// coordination by kinds and partial G_ab(r), as tables and a figure in `out` and "mixture" in the
/// summary. Does nothing where all particles are of one kind. What cannot be measured goes into the
/// summary's "notes". @throws DataError when a column is missing or drawing fails.
void report_mixture(const Packing& packing, const Frame& bodies, const MeasuredContacts& contacts,
                    const std::filesystem::path& out, nlohmann::ordered_json& summary);
void report_mixture(const SpatialPacking& packing, const Frame& bodies,
                    const MeasuredContacts& contacts, const std::filesystem::path& out,
                    nlohmann::ordered_json& summary);

}  // namespace rodpack

#endif
