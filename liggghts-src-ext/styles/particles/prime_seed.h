// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PRIME_SEED_H
#define RODPACK_PRIME_SEED_H

#include <string>

namespace LAMMPS_NS {

/// A seed for LIGGGHTS's generators, which insist on a prime above 10000: any positive integer is
/// scattered over the primes, so that runs with seeds 1, 2, 3 ... draw unrelated numbers (the first
/// numbers of Park and Miller's generator are proportional to the seed).
std::string prime_seed(int seed);

}  // namespace LAMMPS_NS

#endif
