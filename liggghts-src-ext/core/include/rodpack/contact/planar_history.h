// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CONTACT_PLANAR_HISTORY_H
#define RODPACK_CONTACT_PLANAR_HISTORY_H

#include "../motion/multistep.h"
#include "contact_history.h"
#include "contact_law.h"

namespace rodpack {

/// What a contact in the plane of motion remembers (contact_history.h): of vectors, the component
/// along the tangent z x n, n the normal from j to i. It stays as it is when i and j change places,
/// and turns with the contact by itself.
struct PlanarHistory {
  double spring = 0.0;                         // m
  double velocity[max_multistep_order] = {};   // of the last steps, newest first, m/s
  double since = 0.0;                          // time from touch to the end of its step, s
  double viscoelastic = 0.0;                   // normal force before its cut-off at 0, N
  double earlier = 0.0;                        // the same one evaluation before the last, N; known
                                               // under the cap of the whole normal force alone
  double touch_rate = 0.0;                     // of the normal force, assumed at touch, N/s
  bool relaxes = false;                        // whether the dashpots have a relaxation time; then:
  double felt_velocity = 0.0;                  // what the normal one felt, m/s
  int known = 0;                               // evaluations, at most slots + 1; 0: no contact
  bool sliding = false, just_touched = false;  // at the last evaluation, which was the first
};

inline PlanarHistory to_plane(const NormalHistory& normal_force, const TangentialHistory& friction,
                              Vector2<double> normal) {
  const auto along = [&](const double* vector) {
    return cross_z<double>(normal, {vector[0], vector[1]});
  };
  PlanarHistory history;
  history.spring = along(friction.spring);
  for (int k = 0; k < friction.slots; ++k) history.velocity[k] = along(friction.velocity[k]);
  history.since = friction.since;
  history.known = friction.known;
  history.sliding = friction.sliding;
  history.viscoelastic = normal_force.viscoelastic;
  history.touch_rate = normal_force.touch_rate;
  history.relaxes = normal_force.relaxes;
  history.felt_velocity = normal_force.felt_velocity;
  history.just_touched = normal_force.just_touched;
  return history;
}

/// What the cap of the whole normal force remembers of a contact, with its k_n (N/m) and normal
/// dashpot (kg/s): the force that it follows is that of contact_law.h, with the same history.
inline CapHistory to_cap(const PlanarHistory& history, const NormalHistory& normal_force,
                         double stiffness, double damping) {
  CapHistory cap;
  cap.normal = normal_force;
  cap.earlier = history.earlier;
  cap.has_earlier = history.known > 1;
  cap.stiffness = stiffness;
  cap.damping = damping;
  return cap;
}

/// Sets all but the steps and the constants of the contact.
inline void to_space(const PlanarHistory& history, Vector2<double> normal,
                     NormalHistory& normal_force, TangentialHistory& friction) {
  const auto along = [&](double component, double* vector) {
    const Vector2<double> tangential = in_space<double>(normal, 0.0, component);
    vector[0] = tangential.x;
    vector[1] = tangential.y;
    vector[2] = 0.0;
  };
  along(history.spring, friction.spring);
  for (int k = 0; k < friction.slots; ++k) along(history.velocity[k], friction.velocity[k]);
  friction.since = history.since;
  friction.known = history.known;
  friction.sliding = history.sliding;
  normal_force.viscoelastic = history.viscoelastic;
  normal_force.touch_rate = history.touch_rate;
  normal_force.relaxes = history.relaxes;
  normal_force.felt_velocity = history.felt_velocity;
  normal_force.just_touched = history.just_touched;
}

}  // namespace rodpack

#endif
