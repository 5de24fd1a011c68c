// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CONTACT_CONTACT_PAIRS_H
#define RODPACK_CONTACT_CONTACT_PAIRS_H

#include <array>
#include <vector>

namespace rodpack {

using Vector = std::array<double, 3>;

/// One contact of two primary spheres, or of a sphere and a wall. SI units.
struct SphereContact {
  long i, j;  // ids of the particles; j is of no meaning at a wall
  bool wall;
  Vector point;               // of contact, m
  Vector force;               // exerted on i by j, N
  Vector centre_i, centre_j;  // centres of mass, in the periodic images that touch, m
};

/// What one particle exerts on another through all of their contacts, or a wall through one.
struct Interaction {
  Vector from;    // centre of mass of the particle i on which the force acts, m
  Vector branch;  // from there to the partner's centre of mass or the wall's contact point, m
  Vector force;   // on i, N
  Vector moment;  // of the force about i's centre of mass, N m
  bool wall;
};

struct TouchingPair {
  long i, j;     // ids, i < j
  int contacts;  // of their spheres
};

struct ContactPairs {
  std::vector<Interaction> interactions;
  std::vector<TouchingPair> pairs;  // of particles, each once, sorted
};

/// Sums the contacts of each pair of particles; those of a wall stay apart, each with its own
/// contact point. Two particles that touch in two periodic images have two interactions.
ContactPairs sum_pairs(std::vector<SphereContact> contacts);

/// Sorted, each pair once: those of several processes, whose contacts add up.
std::vector<TouchingPair> merge_pairs(std::vector<TouchingPair> pairs);

/// How many particles a particle touches, and in how many contacts. Walls do not count.
struct Touching {
  int particles = 0;
  int contacts = 0;
};

/// Counts for each particle what it touches. `count`: of the particles, whose ids are below it and
/// are the indices of the result.
std::vector<Touching> count_touching(const std::vector<TouchingPair>& pairs, std::size_t count);

}  // namespace rodpack

#endif
