// SPDX-License-Identifier: GPL-2.0-or-later
// The planar engine's inner loops for processors with AVX-512.
#include <cstdint>
#ifdef __x86_64__
#include <immintrin.h>
#endif

#include "arguments.h"

#ifdef __x86_64__

// After all other headers: what they define keeps the instructions of everybody.
#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx2,fma,avx512f,avx512vl,avx512dq"))), \
                             apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2,fma,avx512f,avx512vl,avx512dq")
#endif

namespace rodpack {

namespace {

namespace one_register {
#include "lanes_avx512.h"
#include "kernel.h"
#include "kernel_walls.h"
#include "bundles_avx512.h"
#include "kernel_motion.h"
}  // namespace one_register

namespace two_registers {
#include "lanes_avx512_twice.h"
#include "kernel.h"
}  // namespace two_registers

namespace several_registers = two_registers;
using namespace one_register;
#include "kernel_pairs.h"

}  // namespace

#ifdef __clang__
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif

PlanarKernel planar_kernel_avx512(bool total_force_cap) {
  return total_force_cap
             ? PlanarKernel{evaluate_pairs<true>, evaluate_walls<WholeLoad>, advance}
             : PlanarKernel{evaluate_pairs<false>, evaluate_walls<ElasticLoad>, advance};
}

}  // namespace rodpack

#endif
