// SPDX-License-Identifier: GPL-2.0-or-later
// The planar engine's inner loops for processors with AVX2.
#include <cstdint>
#ifdef __x86_64__
#include <immintrin.h>
#endif

#include "arguments.h"

#ifdef __x86_64__

// After all other headers: what they define keeps the instructions of everybody.
#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx2,fma"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2,fma")
#endif

namespace rodpack {

namespace {

namespace one_register {
#include "lanes_avx2.h"
#include "kernel.h"
}  // namespace one_register

namespace several_registers = one_register;
using namespace one_register;
#include "kernel_pairs.h"
#include "kernel_walls.h"
#include "bundles_of_one_body.h"
#include "kernel_motion.h"

}  // namespace

#ifdef __clang__
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif

PlanarKernel planar_kernel_avx2(bool total_force_cap) {
  return total_force_cap
             ? PlanarKernel{evaluate_pairs<true>, evaluate_walls<WholeLoad>, advance}
             : PlanarKernel{evaluate_pairs<false>, evaluate_walls<ElasticLoad>, advance};
}

}  // namespace rodpack

#endif
