// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_READING_CHECKS_PLANAR_H
#define RODPACK_READING_CHECKS_PLANAR_H

#include <string>

#include "reading/dump.h"

namespace rodpack {

// Planar measures look at x and y alone. What is not planar would get numbers that mean nothing.

/// How far from the common plane a point of a particle's axis may be, in d_p: there, discs that
/// touch in the plane overlap by less than 1 % of their diameter. LIGGGHTS's own fix multisphere
/// leaks up to 0.04 d_p out of the plane.
constexpr double planar_tolerance = 0.1;

/// Says why the bodies are not in one plane z = constant: their centres (column z), or the ends of
/// rods as their quaternions put them, as far as the dump has these columns; empty if they are. A
/// straight rod may be turned about its axis, a curved one has to lie in the plane.
/// `particle_diameter`: d_p, m. The text names file, line and particle.
std::string why_bodies_not_planar(const Frame& bodies, double particle_diameter);
/// @throws DataError with that text.
void require_planar_bodies(const Frame& bodies, double particle_diameter);

/// The same of spheres, whose centres count.
std::string why_spheres_not_planar(const Frame& spheres, double particle_diameter);
/// @throws DataError with that text.
void require_planar_spheres(const Frame& spheres, double particle_diameter);

/// Says why the contacts are not those of a planar packing: a normal out of the x-y plane, as that
/// of a floor that carries a bed with gravity along z; empty if they are. Dumps without normals
/// pass.
std::string why_contacts_not_planar(const Frame& contacts);
/// @throws DataError with that text.
void require_planar_contacts(const Frame& contacts);

}  // namespace rodpack

#endif
