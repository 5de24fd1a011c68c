// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_MOTION_MASS_SCALING_H
#define RODPACK_MOTION_MASS_SCALING_H

#include <algorithm>

namespace rodpack {

// Selective mass scaling. A body of a bed is held by many contacts and oscillates faster than a
// pair, by a factor s that no one knows before the bed is there; the stable step falls with it
// (stability_limit.h). So the inertia of a body, in its equation of motion alone, grows by a factor
// f with the contacts that it has at the moment:
//   d v / dt = F / (f m),  d L / dt = T / f,  f = max(1, q / S^2),  q = sum of its contacts'
//   weights.
// Forces, weights and all that is at rest stay what they are; s stays below S.
//
// Why: with x, y and rotation in coordinates of unit mass, contact c adds k (n n^T + kappa t t^T)
// to the stiffness of either body, kappa = k_t / k_n, seen by translations and by rotations. A
// contact of two bodies counts twice at most, k (a - b)^2 <= 2 k (a^2 + b^2), so the highest
// frequency^2 of the network is below 2 times that of the stiffest body alone; and that of a matrix
// of blocks of translations and rotations is below the sum of both blocks', which gives 2 k / m
// times q. A pair has the frequency^2 2 k / m. For kappa <= 1/2 a contact on a sphere of radius R
// at the distance a from an axis has, whatever its direction,
//   (e . r x n)^2 + kappa |(e . r x t)|^2 <= a^2 + R^2,
// since the lever r of the contact is longer than that of the centre along n alone.
// SI units.

/// Weight of a contact of a body in planar motion with a sphere of its: base + per_square times the
/// square of the distance of the sphere's centre from the centre of mass, m.
struct ContactWeight {
  double base, per_square;
};

/// Weight of a contact of which the sphere's centre lies as far as the root of `square`, m^2, from
/// the centre of mass.
inline double contact_weight(const ContactWeight& weight, double square) {
  return weight.base + weight.per_square * square;
}

/// `moment` (kg m^2) about the axis across the plane, `radius` (m) of the spheres.
inline ContactWeight planar_contact_weight(double mass, double moment, double radius) {
  const double per_square = mass / moment;
  return {1.0 + per_square * radius * radius, per_square};
}

/// The same in space: `arm` (m) is that of the sphere's centre along the principal axes, which
/// `inertia` (kg m^2) belongs to.
inline double spatial_contact_weight(double mass, const double (&inertia)[3], double radius,
                                     const double (&arm)[3]) {
  double square = radius * radius, weight = 1.0;
  for (double along : arm) square += along * along;
  for (int d = 0; d < 3; ++d) weight += mass / inertia[d] * (square - arm[d] * arm[d]);
  return weight;
}

/// By how much the inertia of a body grows: `weight` is the sum of its contacts', `scaling` is S.
inline double inertia_factor(double weight, double scaling) {
  return std::max(1.0, weight / (scaling * scaling));
}

/// Particles and contacts of a packing of one law.
struct PackingLaw {
  double stiffness;            // k_n of a contact, N/m
  double damping_ratio;        // eta_n
  double lightest_mass;        // kg
  double dashpot_share = 1.0;  // share_in_fastest_motion() of the dashpots, 1 unless they relax
};

/// Largest stable step (s) of Adams-Bashforth steps of `order` (1..4), or of leapfrog (0), in any
/// packing under the mass scaling S (>= 1): y(S eta) / S over the frequency of a pair of the
/// lightest particles, with y = stability_limit(). For dashpots that stand beside all springs with
/// the same ratio to them, and k_t <= k_n / 2.
/// @throws std::invalid_argument for numbers out of range.
double mass_scaled_timestep_limit(int order, double scaling, const PackingLaw& law);

}  // namespace rodpack

#endif
