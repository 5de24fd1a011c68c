// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PAGE_WORDS_H
#define RODPACK_PAGE_WORDS_H

#include <nlohmann/json.hpp>
#include <string>

namespace rodpack {

/// What a key of a JSON file or the header of a column means, in HTML.
struct Wording {
  std::string label;  // solid fraction, up to the surface
  std::string unit;   // N/m; empty for a pure number
};

/// Returns the words for a key that names its unit ("container_width_m"), as all of rodpack's do.
Wording wording(const std::string& key);

/// The same as the head of a column: "Bed height (m)"; `unit`: another one than the key names.
std::string heading(const std::string& key);
std::string heading(const std::string& key, const std::string& unit);

/// Says in words what particles a run had, by its parameters.json: "smooth spherocylinders of
/// AR = 5"; "particles" where it does not tell. Plain text.
std::string particles_in_words(const nlohmann::ordered_json& parameters);

}  // namespace rodpack

#endif
