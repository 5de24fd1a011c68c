// SPDX-License-Identifier: GPL-2.0-or-later
#include "prime_seed.h"

#include <climits>
#include <cstdint>

#include "math_extra_liggghts.h"

namespace LAMMPS_NS {

std::string prime_seed(int seed) {
  // splitmix64's finaliser (Steele, Lea, Flood, OOPSLA 2014)
  std::uint64_t mixed = static_cast<std::uint64_t>(seed) + 0x9e3779b97f4a7c15ULL;
  mixed = (mixed ^ (mixed >> 30)) * 0xbf58476d1ce4e5b9ULL;
  mixed = (mixed ^ (mixed >> 27)) * 0x94d049bb133111ebULL;
  mixed ^= mixed >> 31;
  // LIGGGHTS adds the rank to the seed of some generators, which has to stay below INT_MAX.
  int prime = 10007 + static_cast<int>(mixed % (INT_MAX - 20000000));
  while (!MathExtraLiggghts::isPrime(prime)) ++prime;
  return std::to_string(prime);
}

}  // namespace LAMMPS_NS
