// SPDX-License-Identifier: GPL-2.0-or-later
// The planar engine's inner loops for every processor.
#include <cstdint>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "rodpack/planar_forces.h"
#include "rodpack/planar_scene.h"

namespace rodpack {

namespace {

#include "rodpack/lanes_halves.h"
#include "rodpack/planar_kernel.h"
#include "rodpack/planar_kernel_bodies.h"

}  // namespace

PlanarKernel planar_kernel_baseline() { return {evaluate_pairs, evaluate_walls, advance}; }

}  // namespace rodpack
