// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_AVERAGING_KERNEL_SHARE_H
#define RODPACK_AVERAGING_KERNEL_SHARE_H

#include <vector>

#include "../geometry/disc_in_rectangle.h"
#include "../geometry/upright_container.h"
#include "averaging_kernel.h"
#include "coarse_graining.h"

namespace rodpack {

/// Share of the kernel about the place (x, y), m, that lies inside `container` (m, infinite where
/// there is no wall): 1 far from the walls, 1/2 on one, 1/4 in a corner. Two dimensions.
/// The Gaussian: a product of error functions, which leaves out its cut-off and so errs by the
/// share beyond that at most; Heaviside's: closed form; Lucy's: quadrature along the radius, to
/// 1e-9.
/// @throws std::invalid_argument for a kernel of three dimensions.
double kernel_share(const AveragingKernel& kernel, double x, double y, const Rectangle& container);

/// The same in three dimensions, of the Gaussian alone: a product of error functions, and over the
/// cross-section of a cylinder the sum of equal steps of an angle, along which the integrand is
/// analytic and periodic, so that it errs by rounding alone.
/// @throws std::invalid_argument for another kernel.
double kernel_share(const AveragingKernel& kernel, const Vector& place,
                    const UprightContainer& container);

/// Divides the densities among the fields (all but velocity, coordination_number and
/// contacts_per_particle, which are ratios) by the kernel's share inside `container`, so that they
/// are means over the part of the kernel where there can be particles; outside all fields are 0.
/// A uniform scene keeps its densities up to the walls. The balance of forces holds for the fields
/// before, not after: the share has a gradient.
/// @throws std::invalid_argument as kernel_share().
void normalise_by_share(const CoarseGraining& averages, const Rectangle& container,
                        std::vector<Field>& fields);
void normalise_by_share(const CoarseGraining& averages, const UprightContainer& container,
                        std::vector<Field>& fields);

}  // namespace rodpack

#endif
