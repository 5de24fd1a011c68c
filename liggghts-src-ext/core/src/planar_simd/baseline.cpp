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

PlanarKernel planar_kernel_baseline() { return {evaluate_pairs, evaluate_walls, advance}; }

}  // namespace rodpack
