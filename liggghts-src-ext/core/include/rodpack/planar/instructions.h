// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_INSTRUCTIONS_H
#define RODPACK_PLANAR_INSTRUCTIONS_H

#include <string>
#include <vector>

namespace rodpack {

/// Sets of processor instructions that the planar engine was compiled for; automatic: the best that
/// this processor has.
enum class PlanarInstructions { automatic, baseline, avx2, avx512 };

/// "auto", "baseline", "avx2" or "avx512".
const char* name_of(PlanarInstructions instructions);
/// @throws std::invalid_argument for any other name, or a set that the processor does not have.
PlanarInstructions planar_instructions(const std::string& name);
/// The set itself, or the best that this processor has.
PlanarInstructions chosen(PlanarInstructions instructions);
/// Those that this processor has, best last.
std::vector<PlanarInstructions> available_planar_instructions();

}  // namespace rodpack

#endif
