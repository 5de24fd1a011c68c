// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CAMPAIGNS_ACCURACY_ACCURACY_REFERENCES_H
#define RODPACK_CAMPAIGNS_ACCURACY_ACCURACY_REFERENCES_H

#include <array>
#include <vector>

#include "campaigns/accuracy/hybrid_motion.h"

namespace rodpack {

// What the scenes of `rodpack accuracy` are compared with: motions under the contact law of Lu et
// al. (liggghts-src-ext/doc/gran_model_spring_dashpot.md) in the limit of small steps, integrated
// with their events located, without any code of the program; or closed forms. SI units.

/// The law of one contact. Springs may be shortened, so one state per contact: the spring.
struct ReferenceLaw {
  double kn = 1000, kt = 500;       // N/m
  double eta_n = 0.2, eta_t = 0.2;  // damping ratios
  double mu = 0.3;                  // friction coefficient
};

struct SpherePair {
  ReferenceLaw law;
  double mass = 0, radius = 0;  // of each sphere, kg, m
  double speed = 0.5;           // of each, towards the other along x, m/s
  double offset = 0;            // of their lines of flight, m: the right one flies higher
  double spin = 0;              // of the left sphere, about z, rad/s
};

/// Velocity of the left sphere relative to the right one, m/s, and the sum of their spins, rad/s.
struct PairOutcome {
  double vx, vy, omega;
};

/// Computes what a collision leaves. `step`: s. @throws std::runtime_error when they do not touch.
PairOutcome collide(const SpherePair& pair, double step, Scheme scheme);

/// A rigid chain of equal spheres in the x-y plane above a floor at y = 0.
struct RodOnFloor {
  ReferenceLaw law;  // m_ij is the rod's mass
  double mass = 0, inertia = 0, radius = 0;
  std::vector<double> places;  // of the spheres' centres along the rod, from its centre, m
  double gravity = 0;          // along -y, m/s^2
};

struct PlanarState {
  double x, y, angle;    // of the centre, m; of the rod against x, rad
  double vx, vy, omega;  // m/s, rad/s
};

/// Returns the state a `time`, s, after `start`, which is out of contact. `step`: s.
PlanarState move(const RodOnFloor& rod, const PlanarState& start, double time, double step,
                 Scheme scheme);

/// Turns a free symmetric top: returns the unit quaternion (w, x, y, z), body to space, after
/// `time`, from the one at the start and the angular velocity there (space, rad/s). Moments: about
/// the body's x axis, its axis of symmetry, and across it. The body turns about the constant
/// angular momentum L at the rate |L| / across, and about its own axis at omega_1 (1 - along /
/// across).
std::array<double, 4> symmetric_top(const std::array<double, 4>& start,
                                    const std::array<double, 3>& omega, double along, double across,
                                    double time);

}  // namespace rodpack

#endif
