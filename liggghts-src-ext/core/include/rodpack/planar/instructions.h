// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_INSTRUCTIONS_H
#define RODPACK_PLANAR_INSTRUCTIONS_H

#include <string>
#include <vector>

namespace rodpack {

/// Sets of processor instructions that the planar engine was compiled for; automatic: the best that
/// this processor has.
enum class PlanarInstructions { automatic, baseline, avx2, avx512 };

/// The name of a set: "auto", "baseline", "avx2" or "avx512".
const char* name_of(PlanarInstructions instructions);
/// The set of that name. @throws std::invalid_argument for any other name, or a set that the
/// processor does not have.
PlanarInstructions planar_instructions(const std::string& name);
/// The set itself, or the best that this processor has.
PlanarInstructions chosen(PlanarInstructions instructions);
/// The sets that this processor has, the best one last.
std::vector<PlanarInstructions> available_planar_instructions();

}  // namespace rodpack

#endif
