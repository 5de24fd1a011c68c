// SPDX-License-Identifier: GPL-2.0-or-later
// The planar engine's inner loops for every processor.
#include <cstdint>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "arguments.h"

namespace rodpack {

namespace {

#include "lanes_halves.h"
#include "kernel.h"
#include "kernel_bodies.h"

}  // namespace

PlanarKernel planar_kernel_baseline(bool total_force_cap) {
  return total_force_cap
             ? PlanarKernel{evaluate_pairs<WholeLoad>, evaluate_walls<WholeLoad>, advance}
             : PlanarKernel{evaluate_pairs<ElasticLoad>, evaluate_walls<ElasticLoad>, advance};
}

}  // namespace rodpack
