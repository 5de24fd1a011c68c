// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ENSEMBLE_CASE_NAME_H
#define RODPACK_ENSEMBLE_CASE_NAME_H

#include <nlohmann/json.hpp>
#include <string>

namespace rodpack {

/// Names the case of a run by its parameters.json: spheres, coarse-AR2, smooth-AR7,
/// curved-AR5-theta60 (smooth ones; else curved-coarse-AR5-theta60), overlap0.3-AR5; then what
/// differs from the paper's contact law: -kn4000, -kt500 (unless half of kn), -eta0.4
/// (-etan, -etat if they differ), -mu0.1.
/// Keys that are missing count as the paper's values.
std::string case_name(const nlohmann::json& parameters);

/// Whether the case `a` of these parameters and that name comes before `b`: spheres first, straight
/// before curved, then by surface, aspect ratio, opening angle and name.
bool case_before(const nlohmann::json& a, const std::string& name_a, const nlohmann::json& b,
                 const std::string& name_b);

}  // namespace rodpack

#endif
