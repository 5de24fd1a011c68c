// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CONTACT_FORCE_CHANGE_H
#define RODPACK_CONTACT_FORCE_CHANGE_H

#include <algorithm>
#include <cstddef>

#include "../geometry/vector3.h"
#include "contact_law.h"

namespace rodpack {

// Events of a contact. A contact force is smooth in time but for touch, end, and changes between
// the branches of its law. A multistep formula that extrapolates through such an event is of first
// order where the force jumps (a dashpot at touch) and of second where it has a kink.
//
// Once the event is known, one step late, three things restore the order: the impulse and the
// displacement that the step has missed, and records of the past that continue the new branch
// smoothly backwards, so that the next steps extrapolate the right function. All of them follow
// from the difference D(t) = new branch - old branch, taken as linear since the event; they add up
// over the contacts of a body, and the two bodies of a contact get opposite ones, so that momentum
// is conserved to round-off. With a linear D each of the two or three steps that use it errs by
// O(dt^3), once per event: third order.

/// Moments of the change D of a force (N) or torque (N m) since an event in the last step.
template <int components>
struct ChangeOf {
  double now[components];      // D at the end of the step
  double rate[components];     // dD/dt
  double impulse[components];  // integral of D since the event
  /// Integral over time of that impulse, as it grew since the event: displacement times mass.
  double impulse_integral[components];

  ChangeOf& operator+=(const ChangeOf& other) {
    for (int d = 0; d < components; ++d) {
      now[d] += other.now[d];
      rate[d] += other.rate[d];
      impulse[d] += other.impulse[d];
      impulse_integral[d] += other.impulse_integral[d];
    }
    return *this;
  }

  ChangeOf& operator*=(double factor) {
    for (int d = 0; d < components; ++d) {
      now[d] *= factor;
      rate[d] *= factor;
      impulse[d] *= factor;
      impulse_integral[d] *= factor;
    }
    return *this;
  }

  /// The moments of a component.
  ChangeMoments<double> component(int d) const {
    return {now[d], rate[d], impulse[d], impulse_integral[d]};
  }
  /// Sets those of a component.
  void set(int d, const ChangeMoments<double>& moments) {
    now[d] = moments.now;
    rate[d] = moments.rate;
    impulse[d] = moments.impulse;
    impulse_integral[d] = moments.impulse_integral;
  }

  /// past_force() and past_momentum() of component d.
  double past_force(int d, double age) const { return rodpack::past_force(component(d), age); }
  double past_momentum(int d, double age) const {
    return rodpack::past_momentum(component(d), age);
  }
};

/// Changes of a force or torque in space, of a force in the plane of x and y, of a torque about z.
typedef ChangeOf<3> ForceChange;
typedef ChangeOf<2> PlanarForceChange;
typedef ChangeOf<1> PlanarTorqueChange;

static_assert(offsetof(ForceChange, now) == 0 && offsetof(ForceChange, rate) == 24 &&
                  offsetof(ForceChange, impulse) == 48 &&
                  offsetof(ForceChange, impulse_integral) == 72 && sizeof(ForceChange) == 96,
              "changes of spheres' forces are stored, and sent, as plain doubles");

/// A change that is `now` and grows by `rate`, of an event that lies `since` seconds back.
template <int components>
inline ChangeOf<components> linear_change(const double (&now)[components],
                                          const double (&rate)[components], double since) {
  ChangeOf<components> change;
  const double half = 0.5 * since * since, third = since * since * since / 3.0;
  for (int d = 0; d < components; ++d) {
    change.now[d] = now[d];
    change.rate[d] = rate[d];
    change.impulse[d] = since * now[d] - half * rate[d];
    change.impulse_integral[d] = half * now[d] - third * rate[d];
  }
  return change;
}

/// dashpot_moments() of each component.
template <int components>
inline ChangeOf<components> dashpot_change(double coefficient,
                                           const double (&acceleration)[components],
                                           const double (&velocity)[components],
                                           const double (&displacement)[components], double dt) {
  ChangeOf<components> change;
  for (int d = 0; d < components; ++d)
    change.set(d, dashpot_moments(coefficient, acceleration[d], velocity[d], displacement[d], dt));
  return change;
}

/// The torque of a changed force at `lever` (m), which moves at `lever_rate` (m/s). `product`(a, b,
/// d) is component d of that of two vectors.
template <int of_torque, int of_force, class Product>
inline ChangeOf<of_torque> torque_change(const double (&lever)[of_force],
                                         const double (&lever_rate)[of_force],
                                         const ChangeOf<of_force>& force, Product product) {
  const ChangeMoments<const double*> moments = {force.now, force.rate, force.impulse,
                                                force.impulse_integral};
  ChangeOf<of_torque> torque;
  for (int d = 0; d < of_torque; ++d)
    torque.set(d, torque_moments<double>(
                      moments, [&](const double* of) { return product(lever, of, d); },
                      [&](const double* of) { return product(lever_rate, of, d); }));
  return torque;
}

/// The torque of a changed force in space, from lever and lever rate.
inline ForceChange torque_change(const double (&lever)[3], const double (&lever_rate)[3],
                                 const ForceChange& force) {
  return torque_change<3>(lever, lever_rate, force, [](const double* a, const double* b, int d) {
    const int e = (d + 1) % 3, f = (d + 2) % 3;
    return a[e] * b[f] - a[f] * b[e];
  });
}

/// The same in the plane.
inline PlanarTorqueChange torque_change(const double (&lever)[2], const double (&lever_rate)[2],
                                        const PlanarForceChange& force) {
  return torque_change<1>(lever, lever_rate, force, [](const double* a, const double* b, int) {
    return cross_z<double>({a[0], a[1]}, {b[0], b[1]});
  });
}

/// The part of a change in space that `count` components from `first` on make up.
template <int count>
inline ChangeOf<count> components_of(const ForceChange& change, int first) {
  ChangeOf<count> part;
  for (int d = 0; d < count; ++d) {
    part.now[d] = change.now[first + d];
    part.rate[d] = change.rate[first + d];
    part.impulse[d] = change.impulse[first + d];
    part.impulse_integral[d] = change.impulse_integral[first + d];
  }
  return part;
}

/// The part of the change of a force that lies in the plane of x and y.
inline PlanarForceChange in_plane(const ForceChange& force) { return components_of<2>(force, 0); }
/// The part of the change of a torque that is about z.
inline PlanarTorqueChange about_z(const ForceChange& torque) { return components_of<1>(torque, 2); }

/// Time since a quantity that is `before` one step ago and `now` now was 0: of the line through
/// both. They mostly differ in sign; where a jump of the bodies in the step before has changed
/// `before`, it may have the sign of `now` already, and the zero lies further back, at most two
/// steps. One step where the line tells nothing.
inline double time_since_zero(double before, double now, double dt) {
  const double steps = now / (now - before);
  return dt * (steps >= 0.0 ? std::min(2.0, steps) : 1.0);
}

}  // namespace rodpack

#endif
