// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_ORIENTATION_H
#define RODPACK_ANALYSIS_ORIENTATION_H

#include <optional>
#include <string>
#include <vector>

#include "reading/packing.h"

namespace rodpack {

/// Returns gamma of one particle, degrees, counter-clockwise from the horizontal: [0, 180) for a
/// straight one (no head or tail); [0, 360) for a curved one, 0 where the arc bulges up, 180 where
/// it opens up. `angle`: direction of the body's x axis, rad; the arc bulges towards the body's +y.
double gamma_degrees(double angle, bool curved);

/// Two-dimensional nematic order: S2 exp(2 i director) = < exp(2 i gamma) >.
struct NematicOrder {
  double order;           // S2, 0 isotropic, 1 all parallel
  double standard_error;  // of the mean of cos 2(gamma - director), particles taken as independent
  double director;        // degrees, [0, 180)
};
/// Measures it. `gamma`: degrees, one per particle. @throws TooFewParticles when there is none.
NematicOrder nematic_order(const std::vector<double>& gamma);

/// Sixfold order of directions, which S2 does not see: particles at 0, 60 and 120 degrees.
struct SixfoldOrder {
  double order;           // S6 = |< exp(6 i gamma) >|; of n random directions 1 / sqrt(n), rms
  double mean_cosine;     // < cos 6 gamma >: S6 at 0, 60, 120 degrees, -S6 at 30, 90, 150
  double standard_error;  // of the mean cosine, particles taken as independent
};
/// Measures it, as nematic_order().
SixfoldOrder sixfold_order(const std::vector<double>& gamma);

/// Distribution of gamma over bins of equal width, centred on its multiples: 0, 5, 10 ... degrees.
/// The first one goes half a width over either end of the range, which are one direction.
struct OrientationDistribution {
  bool curved = false;
  double range = 180;                  // degrees; 360 for curved particles
  std::vector<double> centre;          // of the bins, degrees
  std::vector<double> count;           // particles in the bin
  std::vector<double> density;         // probability density, 1/degree; integrates to 1
  std::vector<double> standard_error;  // binomial, of the density
  std::size_t particles = 0;           // those that were counted
  std::size_t near_walls = 0;          // left out: closer than AR d_p to a side wall or the floor
  std::size_t spheres = 0;             // left out: no axis
  NematicOrder nematic{};
  SixfoldOrder sixfold{};
};

/// Straight and curved particles are mixed, whose gamma have different ranges.
class MixedParticles : public DataError {
 public:
  using DataError::DataError;
};

/// Collects particles over one or several frames.
class OrientationSample {
 public:
  /// Adds the particles of a frame. @throws MixedParticles when straight and curved ones are mixed.
  void add(const Packing& packing);
  /// Returns the distribution over so many `bins` of the whole range; without a number, over bins 5
  /// degrees wide. @throws TooFewParticles when no particle is left to count.
  OrientationDistribution distribution(std::optional<int> bins = {}) const;

 private:
  std::vector<double> gamma_;
  std::size_t near_walls_ = 0;
  std::size_t spheres_ = 0;
  std::optional<bool> curved_;
};

/// Writes a CSV table with the columns gamma_deg, count, probability_density_per_deg,
/// standard_error_per_deg.
void write_orientation_table(const OrientationDistribution& distribution, const std::string& file);
}  // namespace rodpack

#endif
