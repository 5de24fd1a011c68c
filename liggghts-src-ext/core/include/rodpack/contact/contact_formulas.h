// SPDX-License-Identifier: GPL-2.0-or-later
// The formulas of a contact, each once: for one contact (`Real` is double) and for the contacts in
// a register of the planar engine (`Real` is Lanes). SI units.
//
// This is a text to be included inside a namespace in which lane_less(a, b) and lane_choice(mask,
// a, b) are known for these numbers. contact_law.h does so for double. A source that is compiled
// for the instructions of one kind of processor does so in an unnamed namespace of its own: the
// compiler splits up registers in a template that it has read without these instructions, and a
// function that it has compiled with them could take the place of everybody's.

/// A vector in the plane of motion.
template <class Real>
struct Vector2 {
  Real x, y;
};

/// z component of a x b: the torque of a force b at the lever a, or the component of b along the
/// tangent z x a of a unit normal a.
template <class Real>
inline Real cross_z(Vector2<Real> a, Vector2<Real> b) {
  return a.x * b.y - a.y * b.x;
}

template <class Real>
inline Real dot(Vector2<Real> a, Vector2<Real> b) {
  return a.x * b.x + a.y * b.y;
}

/// Turns a vector from the frame of a body into space.
template <class Real>
inline Vector2<Real> turned(Real cosine, Real sine, Vector2<Real> vector) {
  return {cosine * vector.x - sine * vector.y, sine * vector.x + cosine * vector.y};
}

/// The vector with these components along the unit normal and the tangent z x normal.
template <class Real>
inline Vector2<Real> in_space(Vector2<Real> normal, Real along_normal, Real along_tangent) {
  return {along_normal * normal.x - along_tangent * normal.y,
          along_normal * normal.y + along_tangent * normal.x};
}

// ---- where the surfaces touch, and how they move there

/// Distance from the centre of a sphere to the contact point, half-way into the overlap.
template <class Real>
inline Real lever_length(Real radius, Real overlap) {
  return radius - 0.5 * overlap;
}

/// Component of the lever from the centre of a body to a contact: `arm` leads to the centre of its
/// sphere, and from there it is `length` against the normal, which points from j to i. For j, on
/// whose side the normal leaves, `length` is to be given with a minus sign.
template <class Real>
inline Real lever_component(Real arm, Real length, Real normal) {
  return arm - length * normal;
}

template <class Real>
inline Vector2<Real> lever_in_plane(Vector2<Real> arm, Real length, Vector2<Real> normal) {
  return {lever_component(arm.x, length, normal.x), lever_component(arm.y, length, normal.y)};
}

/// Velocity (or its change, or a small displacement) of the point at `lever` of a body whose centre
/// has `velocity` and that turns at `spin` about z. Given a difference of two velocities and the
/// spin -w of the other body, the result is that of the first relative to the second.
template <class Real>
inline Vector2<Real> velocity_at(Vector2<Real> velocity, Real spin, Vector2<Real> lever) {
  return {velocity.x - spin * lever.y, velocity.y + spin * lever.x};
}

/// Component of the rate at which the normal of two spheres turns, 1/s: from that of the velocity
/// of their centres relative to each other, their velocity of separation and the inverse of their
/// distance.
template <class Real>
inline Real turning_rate_component(Real relative, Real separation_velocity, Real normal,
                                   Real inverse_distance) {
  return (relative - separation_velocity * normal) * inverse_distance;
}

/// Component of the rate of the lever of lever_component(), whose arm changes at `arm_rate`: the
/// overlap changes its length, and the normal turns at `turn`. `side` is 1 for i and -1 for j,
/// `length` is positive for both.
template <class Real>
inline Real lever_rate_component(Real arm_rate, double side, Real length, Real separation_velocity,
                                 Real normal, Real turn) {
  return arm_rate - side * (0.5 * separation_velocity * normal + length * turn);
}

// ---- the law: linear spring and dashpot, Coulomb's cap (contact_law.h)

/// Force of spring and dashpot along the normal, positive when it pushes. A contact has no tension:
/// where this viscoelastic force is negative, the normal force is cut off at 0.
template <class Real>
inline Real viscoelastic_force(Real stiffness, Real overlap, Real damping,
                               Real separation_velocity) {
  return stiffness * overlap - damping * separation_velocity;
}

/// The velocity that a dashpot with a relaxation time feels (dashpot_relaxation.h): what it felt
/// one step ago goes over to the velocity of the surfaces, of which it still lacks the share
/// `kept`.
template <class Real>
inline Real relaxed_velocity(Real felt, Real now, double kept) {
  return now + kept * (felt - now);
}

/// Force of spring and dashpot in the plane of contact, on i, before Coulomb's cap: the trial
/// force of a contact that sticks.
template <class Real>
inline Real trial_force(Real stiffness, Real spring, Real damping, Real velocity) {
  return -(stiffness * spring + damping * velocity);
}

/// The part of the spring in it, and, given a velocity in place of the spring, its rate.
template <class Real>
inline Real spring_force(Real stiffness, Real spring) {
  return -stiffness * spring;
}

/// Coulomb's cap of the tangential force: of mu times the normal stiffness and the overlap, or of
/// mu and the normal force. Given a rate in place of the latter, its rate.
template <class Real>
inline Real coulomb_cap(Real friction, Real load) {
  return friction * load;
}

/// The load under coulomb_cap(), by the kind of cap (friction_cap.h): the overlap of which the
/// normal spring makes its force, or the normal force, dashpot included.
struct ElasticLoad {
  static constexpr bool damped = false;
  template <class Real>
  static Real of(Real overlap, Real) {
    return overlap;
  }
};
struct WholeLoad {
  static constexpr bool damped = true;
  template <class Real>
  static Real of(Real, Real normal_force) {
    return normal_force;
  }
};

/// A divisor of which the inverse is known.
template <class Real>
struct KnownInverse {
  Real inverse;
};
template <class Real>
inline Real operator/(Real dividend, KnownInverse<Real> divisor) {
  return dividend * divisor.inverse;
}

/// Elongation of the tangential spring that alone carries `force`, the inverse of spring_force():
/// that of a contact that slides.
template <class Real, class Stiffness>
inline Real carrying_spring(Real force, Stiffness stiffness) {
  return -force / stiffness;
}

/// A contact that is evaluated one step after an evaluation of it, along its normal and one
/// tangent. `Numbers` names the types Real and Mask.
template <class Numbers>
struct LastingContact {
  typename Numbers::Real normal_stiffness, normal_damping, overlap, separation_velocity;
  typename Numbers::Real viscoelastic_before;  // one step ago
  typename Numbers::Real tangential_stiffness, tangential_damping, tangential_velocity;
  KnownInverse<typename Numbers::Real> inverse_stiffness;  // of the tangential spring
  typename Numbers::Real spring, spring_before;            // now and one step ago
  typename Numbers::Real friction;                         // of the cap: mu k_n, or mu
  typename Numbers::Mask slid;                             // one step ago
};

template <class Numbers>
struct LastingForce {
  typename Numbers::Real viscoelastic;        // along the normal before the cut-off at 0
  typename Numbers::Real normal, tangential;  // on i
  typename Numbers::Real spring;              // as the law wants it
  typename Numbers::Mask pushes, slides;      // the branches: not cut off, at the cap
  typename Numbers::Mask changes;             // of a branch within the step: the rest is void
};

/// The force on such a contact. Where `follows`, changes of branch are looked for as the limit of
/// small steps wants it (friction_step.h): with a dashpot, sliding goes on for as long as the
/// velocity has the direction of the spring. It has none where the normal force, and with it the
/// cap of a WholeLoad, was 0: friction that begins anew then is a change.
template <class Load, class Numbers>
inline LastingForce<Numbers> lasting_force(const LastingContact<Numbers>& contact,
                                           typename Numbers::Real zero, bool follows) {
  typedef typename Numbers::Real Real;
  typedef typename Numbers::Mask Mask;
  LastingForce<Numbers> result;
  result.viscoelastic = viscoelastic_force(contact.normal_stiffness, contact.overlap,
                                           contact.normal_damping, contact.separation_velocity);
  result.pushes = lane_less(zero, result.viscoelastic);
  result.normal = lane_choice(result.pushes, result.viscoelastic, zero);
  const Real cap = coulomb_cap(contact.friction, Load::of(contact.overlap, result.normal));
  const Real trial = trial_force(contact.tangential_stiffness, contact.spring,
                                 contact.tangential_damping, contact.tangential_velocity);
  const Mask negative = lane_less(trial, zero);
  result.slides = lane_less(cap, lane_choice(negative, -trial, trial));
  if (follows) {
    const Mask damped = lane_less(zero, contact.tangential_damping);
    const Mask goes_on = lane_less(zero, contact.tangential_velocity * contact.spring_before);
    result.slides = lane_choice(damped & contact.slid, goes_on, result.slides);
    const Mask pushed = lane_less(zero, contact.viscoelastic_before);
    result.changes = (result.pushes ^ pushed) | (damped & (result.slides ^ contact.slid));
  } else {
    result.changes = lane_less(zero, zero);
  }
  const Real at_cap = lane_choice(negative, -cap, cap);
  result.tangential = lane_choice(result.slides, at_cap, trial);
  result.spring = lane_choice(result.slides, carrying_spring(at_cap, contact.inverse_stiffness),
                              contact.spring);
  return result;
}

// ---- what an event in the step before has changed (force_change.h, event_correction.h)

/// Moments of the change D of a force or torque since an event in the last step: D now, its rate,
/// its integral over time since the event, and the integral over time of that integral.
template <class Value>
struct ChangeMoments {
  Value now, rate, impulse, impulse_integral;
};

/// What the record of a force gains that was made `age` seconds ago, for the records to continue
/// the new branch of the force backwards.
template <class Value>
inline Value past_force(const ChangeMoments<Value>& change, double age) {
  return change.now - age * change.rate;
}
/// The same of the record of the momentum.
template <class Value>
inline Value past_momentum(const ChangeMoments<Value>& change, double age) {
  return change.impulse - age * change.now + 0.5 * age * age * change.rate;
}

/// -coefficient times a velocity that has changed, where `acceleration`, `velocity` and
/// `displacement` are the changes of an event in the last step as seen at its end, and a step of
/// length `dt` has passed since: the dashpot of a contact whose bodies had an event.
template <class Real>
inline ChangeMoments<Real> dashpot_moments(Real coefficient, Real acceleration, Real velocity,
                                           Real displacement, double dt) {
  const Real a = -coefficient * acceleration, v = -coefficient * velocity;
  const Real x = -coefficient * displacement;
  return {v + dt * a, a, x + dt * (v + 0.5 * dt * a), dt * (x + dt * (0.5 * v + (dt / 6.0) * a))};
}

/// The torque of a changed force: `of_lever`(moment) is the product of the lever with a moment of
/// the force, `of_rate`(moment) that of the rate of the lever.
template <class Real, class Moment, class OfLever, class OfRate>
inline ChangeMoments<Real> torque_moments(const ChangeMoments<Moment>& force, OfLever of_lever,
                                          OfRate of_rate) {
  // int (L - (t_now - t) L') x D dt, and the integral of the impulse is int (t_now - t) D dt
  return {of_lever(force.now), of_lever(force.rate) + of_rate(force.now),
          of_lever(force.impulse) - of_rate(force.impulse_integral),
          of_lever(force.impulse_integral)};
}

/// By how much the motion of i's surface relative to j's, at a contact, has changed along one axis
/// in the step before because forces on their bodies jumped; as seen at the end of that step.
template <class Real>
struct JumpAlong {
  Real acceleration, velocity, displacement;
};

/// The tangential spring of a contact along one axis (m) with what it could not know of a jump: it
/// grows by the displacement, but for that of a contact that `slid`, which carries the cap whatever
/// way the surfaces go.
template <class Real, class Mask>
inline Real spring_after(const JumpAlong<Real>& jump, Mask slid, Real spring) {
  return lane_choice(slid, spring, spring + jump.displacement);
}
/// The same of its velocity `age` (s) before the end of the step of the jump, m/s: as of a motion
/// with the changed acceleration.
template <class Real>
inline Real velocity_after(const JumpAlong<Real>& jump, double age, Real velocity) {
  return velocity + (jump.velocity - age * jump.acceleration);
}

/// The viscoelastic force of the last evaluation (N), had its dashpot (kg/s) known of a jump;
/// `separation_jump`: of the velocity along the normal, m/s.
template <class Real>
inline Real viscoelastic_before(Real evaluated, Real damping, Real separation_jump) {
  return evaluated - damping * separation_jump;
}
