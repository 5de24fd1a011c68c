// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_RENDER_H
#define RODPACK_FIGURES_RENDER_H

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "figures/drawing.h"
#include "reading/dump.h"
#include "reading/packing.h"
#include "reading/space/spatial_packing.h"

namespace rodpack {

enum class SphereColour {
  force,        // magnitude of the net contact force on the sphere (fx fy fz), N
  fsum,         // sum of the magnitudes of all contact forces on it, N
  orientation,  // direction of the long axis of its particle: [0, 180) degrees; in space the
                // angle to the vertical
  none
};

struct RenderOptions {
  SphereColour colour = SphereColour::force;
  std::optional<std::array<double, 4>> window;  // xlo, xhi, ylo, yhi, m; none: the whole bed
  std::optional<double> largest;  // top of the colour scale, N; none: 99 % of the spheres are below
  int pixels = 0;                 // longer side of the drawn window; 0: so that d_p is 8 pixels
  PackingOptions packing;         // walls and particle diameter
  SpaceOptions space;
  double azimuth = 30, elevation = 15;  // in space: where it is seen from, degrees, see Camera
};

/// Returns the shades by force (fx fy fz) or by the sum of forces (fsum).
ColourScale sphere_force_scale(const Frame& spheres, SphereColour colour,
                               std::optional<double> largest);

/// Draws one frame of the spheres' dump (columns `body x y radius`, for colours `fx fy fz` or
/// `fsum`): true aspect ratio, walls, colour bar with unit, scale bar; `stem`.svg and `stem`.png.
/// Spheres are drawn as discs of their true size, each particle within one thin dark outline.
/// @throws DataError when a column is missing, no sphere lies in the window, or drawing fails.
void render_spheres(const Frame& spheres, const RenderOptions& options, const std::string& stem);

}  // namespace rodpack

#endif
