// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_DUMPS_COLUMNS_H
#define RODPACK_DUMPS_COLUMNS_H

#include <cstddef>

/// What the text dumps of bodies, spheres and contacts hold: the styles write these columns, the
/// post-processor reads them, liggghts-src-ext/doc explains them. Each dump has its columns by
/// name, all of them in the order of the file, and a row of values in the same order.
namespace rodpack {

/// One column: its name in the dump's header line, and the SI unit of its values, empty for a pure
/// number.
struct DumpColumn {
  const char* name;
  const char* unit;
  bool is_integer;
};

/// The dump of bodies has one row per particle, body or plain sphere.
namespace body_dump {

constexpr DumpColumn id = {"id", "", true};
constexpr DumpColumn type = {"type", "", true};  // of the template; atom type of a plain sphere
constexpr DumpColumn nspheres = {"nspheres", "", true};
constexpr DumpColumn x = {"x", "m", false}, y = {"y", "m", false}, z = {"z", "m", false};
constexpr DumpColumn angle = {"angle", "rad", false};  // of the body x axis in the x-y plane
constexpr DumpColumn vx = {"vx", "m/s", false}, vy = {"vy", "m/s", false},
                     vz = {"vz", "m/s", false};
constexpr DumpColumn omegax = {"omegax", "rad/s", false}, omegay = {"omegay", "rad/s", false},
                     omegaz = {"omegaz", "rad/s", false};
constexpr DumpColumn qw = {"qw", "", false}, qx = {"qx", "", false}, qy = {"qy", "", false},
                     qz = {"qz", "", false};                     // body to space
constexpr DumpColumn half_length = {"half_length", "m", false};  // l_axial / 2
constexpr DumpColumn radius = {"radius", "m", false};            // of the primary spheres
constexpr DumpColumn curvature = {"curvature", "rad", false};    // theta, 0 for a straight chain
constexpr DumpColumn area = {"area", "m2", false};               // covered
constexpr DumpColumn mass = {"mass", "kg", false};

constexpr DumpColumn columns[] = {id, type,        nspheres, x,         y,      z,   angle, vx,
                                  vy, vz,          omegax,   omegay,    omegaz, qw,  qx,    qy,
                                  qz, half_length, radius,   curvature, area,   mass};

struct BodyRow {
  double id, type, nspheres;
  double centre[3];  // of mass
  double angle;
  double velocity[3], angular_velocity[3];
  double quaternion[4];
  double half_length, radius, curvature, area, mass;
};

}  // namespace body_dump

/// The dump of spheres has one row per primary sphere.
namespace sphere_dump {

constexpr DumpColumn id = {"id", "", true};
constexpr DumpColumn body = {"body", "", true};  // id of its particle in the dump of bodies
constexpr DumpColumn type = {"type", "", true};  // atom type
constexpr DumpColumn x = {"x", "m", false}, y = {"y", "m", false}, z = {"z", "m", false};
constexpr DumpColumn radius = {"radius", "m", false};
constexpr DumpColumn fx = {"fx", "N", false}, fy = {"fy", "N", false}, fz = {"fz", "N", false};
constexpr DumpColumn fsum = {"fsum", "N", false};  // sum of the magnitudes of its contact forces

constexpr DumpColumn columns[] = {id, body, type, x, y, z, radius, fx, fy, fz, fsum};

struct SphereRow {
  double id, body, type;
  double centre[3];
  double radius;
  double force[3];  // of its contacts, without gravity
  double force_sum;
};

}  // namespace sphere_dump

/// The dump of contacts has one row per contact, of two spheres or of a sphere i and a wall.
namespace contact_dump {

constexpr DumpColumn body_i = {"body_i", "", true}, body_j = {"body_j", "", true};
constexpr DumpColumn sphere_i = {"sphere_i", "", true}, sphere_j = {"sphere_j", "", true};
constexpr DumpColumn wall = {"wall", "", true};  // 1, and body_j = sphere_j = 0; else 0
constexpr DumpColumn x = {"x", "m", false}, y = {"y", "m", false}, z = {"z", "m", false};
constexpr DumpColumn fx = {"fx", "N", false}, fy = {"fy", "N", false}, fz = {"fz", "N", false};
constexpr DumpColumn bix = {"bix", "m", false}, biy = {"biy", "m", false},
                     biz = {"biz", "m", false};
constexpr DumpColumn bjx = {"bjx", "m", false}, bjy = {"bjy", "m", false},
                     bjz = {"bjz", "m", false};
constexpr DumpColumn overlap_n = {"overlap_n", "m", false}, overlap_t = {"overlap_t", "m", false};
constexpr DumpColumn nx = {"nx", "", false}, ny = {"ny", "", false}, nz = {"nz", "", false};
constexpr DumpColumn type_i = {"type_i", "", true}, type_j = {"type_j", "", true};  // atom types

constexpr DumpColumn columns[] = {
    body_i, body_j, sphere_i, sphere_j, wall, x,         y,         z,  fx, fy, fz,     bix,
    biy,    biz,    bjx,      bjy,      bjz,  overlap_n, overlap_t, nx, ny, nz, type_i, type_j};

struct ContactRow {
  double body_i, body_j, sphere_i, sphere_j, wall;
  double point[3];         // half-way into the overlap
  double force[3];         // exerted on i by j
  double centre_i[3];      // of mass, in the periodic images that touch
  double centre_j[3];      // of a wall the point
  double overlap, spring;  // the latter: length of the tangential spring
  double normal[3];        // from j to i
  double type_i, type_j;   // of a wall that of its material
};

}  // namespace contact_dump

/// Whether a row holds one value for each column.
template <class Row, std::size_t number>
constexpr bool fits(const DumpColumn (&)[number]) {
  return sizeof(Row) == number * sizeof(double);
}

static_assert(fits<body_dump::BodyRow>(body_dump::columns), "one value per column");
static_assert(fits<sphere_dump::SphereRow>(sphere_dump::columns), "one value per column");
static_assert(fits<contact_dump::ContactRow>(contact_dump::columns), "one value per column");

}  // namespace rodpack

#endif
