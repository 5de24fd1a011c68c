// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CONTACT_CONTACT_HISTORY_H
#define RODPACK_CONTACT_CONTACT_HISTORY_H

#include <algorithm>
#include <cstdint>

#include "../motion/multistep.h"

namespace rodpack {

// What a contact remembers from one evaluation of its force to the next, and how that is stored as
// an array of doubles: the only kind of value that LIGGGHTS keeps for a contact, and writes to
// restart files. SI units.

/// What a contact remembers of its normal force.
struct NormalHistory {
  /// Force of spring and dashpot at the last evaluation, before its cut-off at 0, N.
  double viscoelastic = 0.0;
  /// Rate of the force that was assumed at touch, N/s.
  double touch_rate = 0.0;
  /// The last evaluation was the first, in the step in which the surfaces touched.
  bool just_touched = false;
  /// Whether its dashpot has a relaxation time, and the velocity that it felt then, m/s
  /// (dashpot_relaxation.h).
  bool relaxes = false;
  double felt_velocity = 0.0;
  /// Number of the step after the last evaluation, the one that it was made for; 0: never.
  std::int64_t next_step = 0;
};

/// What a contact remembers of its tangential force; vectors lie in the plane of contact of the
/// last evaluation.
struct TangentialHistory {
  /// How many velocities are kept, at most max_multistep_order; this number is not stored.
  int slots = 0;
  /// Integral of the tangential velocity over the life of the contact, m.
  double spring[3] = {0.0, 0.0, 0.0};
  /// Tangential velocities of the last steps, newest first, m/s; with a relaxation time the newest
  /// is the one that the dashpot felt.
  double velocity[max_multistep_order][3] = {};
  /// Evaluations that have been made, counted up to slots + 1; 0 where there is no contact.
  int known = 0;
  bool sliding = false;
  /// Number of the step of the last evaluation.
  std::int64_t step = 0;
  /// Time from touch to the end of the step of touch, s.
  double since = 0.0;
  /// Constants of the contact, for its end: `friction` of its cap (friction_cap.h), k_t (N/m),
  /// tangential dashpot (kg/s).
  double friction = 0.0, stiffness = 0.0, damping = 0.0;

  TangentialHistory() = default;
  explicit TangentialHistory(int velocities) : slots(velocities) {}
};

/// What a contact remembers for a cap of friction that has the dashpot of the normal force in it.
struct CapHistory {
  NormalHistory normal;
  /// The force of spring and dashpot one evaluation before the last, N, if there was one.
  double earlier = 0.0;
  bool has_earlier = false;
  /// Constants of the normal force, for the contact's end: k_n (N/m), dashpot (kg/s).
  double stiffness = 0.0, damping = 0.0;
};

/// How many doubles each of the histories takes.
constexpr int stored_normal_values = 4;
constexpr int stored_tangential_values(int slots) { return 3 * (slots + 1) + 6; }
/// The step in it is not stored, which the tangential history knows.
constexpr int stored_cap_values = 7;
/// How many doubles the first two take, the normal one first.
constexpr int stored_history_values(int slots) {
  return stored_normal_values + stored_tangential_values(slots);
}

namespace detail {
// The part of a normal history that a CapHistory stores too, three doubles: all but the step.
inline NormalHistory unpack_force(const double* stored) {
  NormalHistory history;
  history.viscoelastic = stored[0];
  history.touch_rate = stored[1];
  history.just_touched = stored[2] != 0.0;
  return history;
}
inline void pack_force(const NormalHistory& history, double* stored) {
  stored[0] = history.viscoelastic;
  stored[1] = history.touch_rate;
  stored[2] = history.just_touched ? 1.0 : 0.0;
}
}  // namespace detail

// The third number says what the second one is: with a relaxation time no events are followed, and
// what the dashpot felt takes the place of the rate at touch.
constexpr double stored_felt_velocity = 2.0;

inline NormalHistory unpack_normal(const double* stored) {
  NormalHistory history;
  history.relaxes = stored[2] == stored_felt_velocity;
  if (history.relaxes) {
    history.viscoelastic = stored[0];
    history.felt_velocity = stored[1];
  } else {
    history = detail::unpack_force(stored);
  }
  history.next_step = static_cast<std::int64_t>(stored[3]);
  return history;
}

inline void pack(const NormalHistory& history, double* stored) {
  detail::pack_force(history, stored);
  if (history.relaxes) {
    stored[1] = history.felt_velocity;
    stored[2] = stored_felt_velocity;
  }
  stored[3] = static_cast<double>(history.next_step);
}

/// Sliding is stored as the sign of the number of evaluations.
inline TangentialHistory unpack_tangential(const double* stored, int slots) {
  TangentialHistory history(slots);
  std::copy_n(stored, 3, history.spring);
  for (int k = 0; k < slots; ++k) std::copy_n(stored + 3 * (k + 1), 3, history.velocity[k]);
  const double* const rest = stored + 3 * (slots + 1);
  history.sliding = rest[0] < 0.0;
  history.known = static_cast<int>(history.sliding ? -rest[0] : rest[0]);
  history.step = static_cast<std::int64_t>(rest[1]);
  history.since = rest[2];
  history.friction = rest[3];
  history.stiffness = rest[4];
  history.damping = rest[5];
  return history;
}

inline void pack(const TangentialHistory& history, double* stored) {
  std::copy_n(history.spring, 3, stored);
  for (int k = 0; k < history.slots; ++k) std::copy_n(history.velocity[k], 3, stored + 3 * (k + 1));
  double* const rest = stored + 3 * (history.slots + 1);
  rest[0] = history.sliding ? -history.known : history.known;
  rest[1] = static_cast<double>(history.step);
  rest[2] = history.since;
  rest[3] = history.friction;
  rest[4] = history.stiffness;
  rest[5] = history.damping;
}

inline CapHistory unpack_cap(const double* stored) {
  CapHistory history;
  history.normal = detail::unpack_force(stored);
  history.stiffness = stored[3];
  history.damping = stored[4];
  history.earlier = stored[5];
  history.has_earlier = stored[6] != 0.0;
  return history;
}

inline void pack(const CapHistory& history, double* stored) {
  detail::pack_force(history.normal, stored);
  stored[3] = history.stiffness;
  stored[4] = history.damping;
  stored[5] = history.earlier;
  stored[6] = history.has_earlier ? 1.0 : 0.0;
}

}  // namespace rodpack

#endif
