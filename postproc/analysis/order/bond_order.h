// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_ORDER_BOND_ORDER_H
#define RODPACK_ANALYSIS_ORDER_BOND_ORDER_H

#include <complex>
#include <cstddef>
#include <vector>

#include "reading/dump.h"
#include "reading/packing.h"

namespace rodpack {

/// Sixfold bond order of points in a plane, one value each:
///   psi_6 = sum_k l_k exp(6 i theta_k) / sum_k l_k,
/// theta_k the direction to neighbour k and l_k the length of the side that its Voronoi cell shares
/// with that of the point (Mickel et al., J. Chem. Phys. 138, 044501, 2013). So a neighbour that
/// only just is one counts next to nothing, and psi_6 has no jumps. |psi_6| is 1 in a triangular
/// lattice and 0 in a square one; n equal sides in random directions give 1 / sqrt(n), rms.
/// Not a number where the cell is open, at the rim, and where points coincide.
/// `x`, `y`: in one unit.
std::vector<std::complex<double>> sixfold_bond_orders(const std::vector<double>& x,
                                                      const std::vector<double>& y);

/// Means over the points of particles.
struct BondOrder {
  double local = 0;            // mean of |psi_6|: how hexagonal the surroundings are
  double local_error = 0;      // standard error, points taken as independent
  double global = 0;           // |mean of psi_6|: 1 in one crystal, near 0 in many grains
  std::size_t points = 0;      // those that were counted
  std::size_t near_edges = 0;  // left out: closer than AR d_p to a wall or the surface
};

/// Collects psi_6 over one or several frames. The points are AR on each centreline, evenly from end
/// centre to end centre: the sphere centres of a coarse particle, every second one of a smooth one,
/// the centre of a sphere. So both surfaces of one AR are compared at the same points; where they
/// lie hexagonally, the spheres of neighbours lie in each other's grooves.
class BondOrderSample {
 public:
  /// @throws DataError as body_points().
  void add(const Frame& bodies, const Packing& packing);
  /// @throws TooFewParticles when no point was counted.
  BondOrder result() const;

 private:
  std::complex<double> sum_ = 0;
  double sum_of_moduli_ = 0, sum_of_squares_ = 0;
  std::size_t points_ = 0, near_edges_ = 0;
};

}  // namespace rodpack

#endif
