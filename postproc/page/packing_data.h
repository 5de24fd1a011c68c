// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PAGE_PACKING_DATA_H
#define RODPACK_PAGE_PACKING_DATA_H

#include <nlohmann/json.hpp>
#include <string>

namespace rodpack {

/// Packs the last frame of a run for the page's viewer (page/web/decode.js reads it), small enough
/// for 9000 particles: arrays of whole numbers, little endian, in base64.
///
/// - `particles`, `first_id` or `ids` (32 bits); `index_bits`: 16 or 32, of `contacts`
/// - `x` `y` `angle` `radius`: 16 bits, of the ranges `x_range` `y_range` (m), [0, 360)°,
///   `radius_range` (m); `shape`: 8 bits, place in `shapes`
/// - `shapes`: `half_length_m` (0 for a sphere), `gamma_range_deg` (180 straight, 360 curved, 0 a
/// sphere) and
///   `centres` of the primary spheres in the body's frame, in units of 2 (half length − radius)
/// - `shade`: 8 bits per sphere, place in `scale.colours`, as render_spheres() shades the
///   magnitude of the net contact force; of plain spheres the sum of the magnitudes
/// - `contacts`: `i`, `j` places of particles (from `particles` on: of `walls`), `force` 16 bits:
///   0 none, else f = lowest (highest / lowest)^((q − 1) / 65534), N; the sum over the sphere
///   contacts of a pair, as force_lines() has it; null, and `contacts_missing` says why, where they
///   are not known
/// - `bed`: `left` `right` `floor` `top` (m), `sides`, `bottom`: whether there are such walls
///
/// @throws DataError when the bodies' or spheres' dumps are missing, or when a sphere is not where
///   its particle has it.
nlohmann::ordered_json packing_data(const std::string& run_folder);

}  // namespace rodpack

#endif
