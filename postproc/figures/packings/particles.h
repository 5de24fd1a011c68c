// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_PACKINGS_PARTICLES_H
#define RODPACK_FIGURES_PACKINGS_PARTICLES_H

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "figures/drawing.h"
#include "reading/dump.h"

namespace rodpack {

/// Rows of the spheres' dump that show in a window (xlo, xhi, ylo, yhi, m).
std::vector<std::size_t> visible_spheres(const Frame& spheres, const std::array<double, 4>& window);

/// A small disc that joins two neighbouring spheres of one particle, m.
struct Joint {
  double x, y, radius;
  std::size_t sphere, other;  // rows of the two
};

/// Returns the joints of the particles' spheres among `rows` that hardly overlap, in which one
/// particle cannot be told from two. Each lies around the middle of the two centres with half
/// their radius, in the groove that no sphere of that size can reach: one that touches both begins
/// sqrt(3) - 1 radii off their line. In space (column `z`) a thin rod has its place. Spheres of a
/// particle follow each other by their column `id`, where there is none by their rows.
std::vector<Joint> joints_of(const Frame& spheres, const std::vector<std::size_t>& rows);

/// Draws the spheres of `rows` as discs of their true size with one outline around each particle;
/// `shade`: colour of a row. `diameter`: d_p, m.
void draw_particles(const PackingPicture& picture, Drawing& drawing, const Frame& spheres,
                    const std::vector<std::size_t>& rows, double diameter, const std::string& edge,
                    const std::function<std::string(std::size_t)>& shade);

}  // namespace rodpack

#endif
