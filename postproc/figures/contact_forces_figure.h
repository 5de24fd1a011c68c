// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_CONTACT_FORCES_FIGURE_H
#define RODPACK_FIGURES_CONTACT_FORCES_FIGURE_H

#include <string>

#include "analysis/contact_forces.h"

namespace rodpack {

/// Draws the distributions of the forces, the mobilised friction (if mu is known) and the
/// coordination: `stem`, `stem`_friction and `stem`_coordination, each .png and .svg. @throws
/// DataError when that fails.
void plot_contact_forces(const ContactForces& forces, const std::string& stem);

}  // namespace rodpack

#endif
