// SPDX-License-Identifier: GPL-2.0-or-later
// The planar engine's inner loops for every processor.
#include <cstdint>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "arguments.h"

namespace rodpack {

namespace {

namespace one_register {
#include "lanes_halves.h"
#include "kernel.h"
}  // namespace one_register

namespace several_registers = one_register;
using namespace one_register;
#include "kernel_pairs.h"
#include "kernel_walls.h"
#include "bundles_of_one_body.h"
#include "kernel_motion.h"

}  // namespace

PlanarKernel planar_kernel_baseline(bool total_force_cap) {
  return total_force_cap
             ? PlanarKernel{evaluate_pairs<true>, evaluate_walls<WholeLoad>, advance}
             : PlanarKernel{evaluate_pairs<false>, evaluate_walls<ElasticLoad>, advance};
}

}  // namespace rodpack
