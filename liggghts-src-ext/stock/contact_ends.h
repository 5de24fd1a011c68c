// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CONTACT_ENDS_H
#define RODPACK_CONTACT_ENDS_H

namespace rodpack {

/// Whether somebody has to be told of the ends of contacts: an integrator that makes them good, or
/// a model that has to forget. Stock code then hands every contact that has ended to its models,
/// and not those alone that are still as close as the contact distance factor of neigh_modify says.
inline bool& ends_are_told() {
  static bool told = false;
  return told;
}

/// Whether a pair was in contact when it was evaluated last, and its end is wanted.
inline bool wants_end(const int* contact_flags) {
  return contact_flags && *contact_flags && ends_are_told();
}

/// The same of a sphere and a primitive wall, by their history of `values` doubles.
inline bool wants_end(const double* history, int values) {
  if (!history || !ends_are_told()) return false;
  for (int k = 0; k < values; ++k)
    if (history[k] != 0.0) return true;
  return false;
}

/// The same of a particle and a triangle of a mesh, by the history of all its triangles: a pointer
/// to LIGGGHTS's FixContactHistoryMesh, NULL where contacts remember nothing.
template <class MeshHistory>
bool wants_end(MeshHistory* contacts, int particle, int triangle) {
  if (!contacts || !ends_are_told()) return false;
  const int known = contacts->nneighs(particle);
  for (int k = 0; k < known; ++k)
    if (contacts->partner(particle, k) == triangle)
      return wants_end(contacts->contacthistory(particle, k), contacts->get_dnum());
  return false;
}

}  // namespace rodpack

#endif
