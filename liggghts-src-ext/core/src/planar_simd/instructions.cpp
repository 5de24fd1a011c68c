// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/planar/instructions.h"

#include <algorithm>
#include <stdexcept>

#include "arguments.h"

namespace rodpack {

namespace {

bool available(PlanarInstructions instructions) {
  switch (instructions) {
#ifdef __x86_64__
    case PlanarInstructions::avx2:
      return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    case PlanarInstructions::avx512:
      return available(PlanarInstructions::avx2) && __builtin_cpu_supports("avx512f") &&
             __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq");
#else
    case PlanarInstructions::avx2:
    case PlanarInstructions::avx512:
      return false;
#endif
    default:
      return true;
  }
}

}  // namespace

const char* name_of(PlanarInstructions instructions) {
  switch (instructions) {
    case PlanarInstructions::baseline:
      return "baseline";
    case PlanarInstructions::avx2:
      return "avx2";
    case PlanarInstructions::avx512:
      return "avx512";
    default:
      return "auto";
  }
}

std::vector<PlanarInstructions> available_planar_instructions() {
  std::vector<PlanarInstructions> sets;
  for (const PlanarInstructions set :
       {PlanarInstructions::baseline, PlanarInstructions::avx2, PlanarInstructions::avx512})
    if (available(set)) sets.push_back(set);
  return sets;
}

PlanarInstructions planar_instructions(const std::string& name) {
  std::string expected = "auto";
  for (const PlanarInstructions set : available_planar_instructions())
    expected += std::string(", ") + name_of(set);
  for (const PlanarInstructions set : {PlanarInstructions::automatic, PlanarInstructions::baseline,
                                       PlanarInstructions::avx2, PlanarInstructions::avx512}) {
    if (name != name_of(set)) continue;
    if (available(set)) return set;
    throw std::invalid_argument("instructions is '" + name +
                                "', which this processor does not support, expected " + expected);
  }
  throw std::invalid_argument("instructions is '" + name + "', expected " + expected);
}

PlanarInstructions chosen(PlanarInstructions instructions) {
  return instructions == PlanarInstructions::automatic ? available_planar_instructions().back()
                                                       : instructions;
}

PlanarKernel planar_kernel(PlanarInstructions wanted, bool total_force_cap) {
  const PlanarInstructions instructions = chosen(wanted);
  if (!available(instructions)) planar_instructions(name_of(instructions));  // throws
#ifdef __x86_64__
  if (instructions == PlanarInstructions::avx512) return planar_kernel_avx512(total_force_cap);
  if (instructions == PlanarInstructions::avx2) return planar_kernel_avx2(total_force_cap);
#endif
  return planar_kernel_baseline(total_force_cap);
}

}  // namespace rodpack
