// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_REPORT_SCENE_H
#define RODPACK_REPORT_SCENE_H

#include <nlohmann/json.hpp>
#include <string>

namespace rodpack {

/// Says in a sentence or two, plain text, what sets a deposition apart from the paper's where its
/// container is narrower than 20 l_axial or lower than 2 m, as that of the preset `quick` is: such
/// a bed orders otherwise. Empty where it is not, or where `parameters` (parameters.json) does not
/// tell.
std::string scene_unlike_the_papers(const nlohmann::json& parameters);

}  // namespace rodpack

#endif
