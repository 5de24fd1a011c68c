// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_CONTACT_H
#define RODPACK_PLANAR_CONTACT_H

#include <cmath>
#include <cstddef>

#include "rodpack/contact/contact_motion.h"
#include "rodpack/contact/tangential_history.h"
#include "../planar_simd/kinematics.h"
#include "rodpack/planar/scene.h"
#include "rodpack/geometry/vector3.h"

namespace rodpack {

/// A contact of two spheres of planar bodies, or of one with a wall: what the formulas of
/// normal_history.h and tangential_history.h ask of a `Contact`, with z = 0.
struct PlanarContact {
  bool is_wall;
  int body_i, body_j;               // a wall: -1
  double offset_i[2], offset_j[2];  // spheres' centres in the frames of their bodies
  double arm_i[3], arm_j[3];        // the same in space
  double body_v_i[3], body_v_j[3];  // velocities of the bodies' centres
  double v_i[3], v_j[3];            // of the spheres' centres
  double omega_i[3], omega_j[3];
  double delta[3], en[3];
  double radi, radj, radsum, rsq, r, rinv, deltan, cri, crj;
  double vn, vtr1, vtr2, vtr3;
  double kn, kt, gamman, gammat;

  Vector2<double> normal() const { return {en[0], en[1]}; }
  double tangential_velocity() const { return cross_z<double>(normal(), {vtr1, vtr2}); }
  /// The lever from the centre of mass of each body to the contact.
  Vector2<double> lever_i() const {
    return lever_in_plane<double>({arm_i[0], arm_i[1]}, cri, normal());
  }
  Vector2<double> lever_j() const {
    return lever_in_plane<double>({arm_j[0], arm_j[1]}, -crj, normal());
  }
};

/// The history of a contact in the plane of motion has been put along its present tangent.
inline detail::NoTurn turn_of_history(const PlanarContact&, double) { return detail::NoTurn(); }

namespace detail {

inline void place_sphere(const PlanarKinematics& body, const double (&offset)[2], double (&arm)[3],
                         double (&body_v)[3], double (&v)[3], double (&omega)[3]) {
  const Vector2<double> to_sphere = turned<double>(body.cosine, body.sine, {offset[0], offset[1]});
  const Vector2<double> velocity =
      velocity_at<double>({body.velocity[0], body.velocity[1]}, body.velocity[2], to_sphere);
  arm[0] = to_sphere.x;
  arm[1] = to_sphere.y;
  body_v[0] = body.velocity[0];
  body_v[1] = body.velocity[1];
  v[0] = velocity.x;
  v[1] = velocity.y;
  omega[2] = body.velocity[2];
  arm[2] = omega[0] = omega[1] = body_v[2] = v[2] = 0.0;
}

}  // namespace detail

/// Completes a contact of two spheres; offsets, radii, bodies and coefficients must be set.
inline void place_pair(PlanarContact& c, const PlanarKinematics& i, const PlanarKinematics& j) {
  c.is_wall = false;
  detail::place_sphere(i, c.offset_i, c.arm_i, c.body_v_i, c.v_i, c.omega_i);
  detail::place_sphere(j, c.offset_j, c.arm_j, c.body_v_j, c.v_j, c.omega_j);
  c.delta[0] = (i.x - j.x) + (c.arm_i[0] - c.arm_j[0]);
  c.delta[1] = (i.y - j.y) + (c.arm_i[1] - c.arm_j[1]);
  c.delta[2] = 0.0;
  c.rsq = dot(c.delta, c.delta);
  c.radsum = c.radi + c.radj;
  c.r = std::sqrt(c.rsq);
  complete_contact(c);
}

/// Completes a contact of a sphere with a wall. The distance is negative behind a solid one.
inline void place_wall(PlanarContact& c, const PlanarKinematics& i, const PlanarWall& wall) {
  c.is_wall = true;
  c.body_j = -1;
  detail::place_sphere(i, c.offset_i, c.arm_i, c.body_v_i, c.v_i, c.omega_i);
  for (int d = 0; d < 3; ++d)
    c.arm_j[d] = c.body_v_j[d] = c.v_j[d] = c.omega_j[d] = c.delta[d] = 0.0;
  c.delta[wall.axis] = (wall.axis == 0 ? i.x : i.y) + c.arm_i[wall.axis] - wall.position;
  if (c.delta[wall.axis] == 0.0) c.delta[wall.axis] = 1e-300;  // the normal is delta / r
  c.r = wall.side_of(c.delta[wall.axis]) * c.delta[wall.axis];
  c.rsq = c.r * c.r;
  c.radj = 0.0;
  c.radsum = c.radi;
  complete_contact(c);
}

}  // namespace rodpack

#endif
