// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_SPACE_PACKING_PICTURE_H
#define RODPACK_FIGURES_SPACE_PACKING_PICTURE_H

#include <string>

#include "figures/render.h"

namespace rodpack {

/// Draws one frame of the spheres' dump (columns `body x y z radius`, for colours `fx fy fz` or
/// `fsum`, whose sum over a particle shades all of it) of a scene in space, in perspective, with
/// light, shadows and fog, by the ray tracer Tachyon: container, colour bar with unit, axes, and a
/// scale bar that holds at the middle of the bed. Orientation is the angle of the particle's long
/// axis to the vertical. `stem`.svg and `stem`.png. @throws NoRayTracer when there is none,
/// DataError when a column is missing, the vertical is unknown, or drawing fails.
void render_in_space(const Frame& spheres, const RenderOptions& options, const std::string& stem);

}  // namespace rodpack

#endif
