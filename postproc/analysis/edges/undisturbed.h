// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_EDGES_UNDISTURBED_H
#define RODPACK_ANALYSIS_EDGES_UNDISTURBED_H

#include <array>
#include <vector>

#include "analysis/fields.h"
#include "reading/packing.h"
#include "rodpack/averaging/averaging_kernel.h"
#include "rodpack/geometry/disc_in_rectangle.h"

namespace rodpack {

/// Relative margin of comparisons of lengths: those in parameters.json and in dumps are rounded to
/// six digits or more.
constexpr double length_rounding = 1e-5;

/// Returns how far from a place the kernel still counts for what is read off there, m: 3 w, or its
/// end if that is nearer.
double kernel_reach(const AveragingKernel& kernel);

/// Returns the part of a bed where averages hold nothing of the empty space beyond walls and
/// surface: further than `reach` (m) from each of them. Endless where there is no wall, and where
/// the densities are normalised by the kernel's share on this side of it. With left >= right or
/// bottom >= top there is no such part. Lengths that differ by rounding alone are equal.
Rectangle undisturbed_part(const Packing& packing, double reach,
                           Normalisation normalisation = Normalisation::none);

/// Returns whether the central slice, 2 AR d_p wide, lies in it as far as the side walls go.
bool slice_is_undisturbed(const Packing& packing, double reach,
                          Normalisation normalisation = Normalisation::none);

/// Returns the heights of the central slice, y from and to, m, that lie in it; to <= from when none
/// do.
std::array<double, 2> undisturbed_heights(const Packing& packing, double reach,
                                          Normalisation normalisation = Normalisation::none);

/// Returns what of `whole` lies outside `inner`: up to four rectangles without common area, none of
/// them empty; all of `whole` when `inner` is empty.
std::vector<Rectangle> parts_outside(const Rectangle& inner, const Rectangle& whole);

}  // namespace rodpack

#endif
