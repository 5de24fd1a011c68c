// SPDX-License-Identifier: GPL-2.0-or-later
// Bundles of one body in lanes of four; see kernel_motion.h.

constexpr int bundle_bodies = 1;  // bodies in a bundle

/// Four numbers of each body, which lie where these point.
inline Lanes load_each(const double* const (&places)[bundle_bodies]) {
  return load_lanes(places[0]);
}
inline void store_each(double* const (&places)[bundle_bodies], Lanes x) {
  store_lanes(places[0], x);
}
/// The same four numbers for every body.
inline Lanes of_every_body(const double* vector) { return load_lanes(vector); }
/// One number of each body, in all lanes of that body.
inline Lanes each_number(const double* const (&of)[bundle_bodies], int index) {
  return all_lanes(of[0][index]);
}
/// Stores the positions and directions of so many bodies, given as lanes of x, y, cosine and sine.
inline void store_poses(Lanes (&numbers)[4], PlanarKinematics* of, int members) {
  bundles_to_numbers(numbers);
  for (int k = 0; k < members; ++k) store_lanes(&of[k].x, numbers[k]);
}
