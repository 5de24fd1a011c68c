// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_INCLINE_CHUTE_PROFILE_H
#define RODPACK_ANALYSIS_INCLINE_CHUTE_PROFILE_H

#include <optional>
#include <string>
#include <vector>

#include "reading/packing.h"

namespace rodpack {

/// An inclined plane: its base is y = 0, down the slope is +x, and gravity is turned against it.
struct Slope {
  double angle = 0;    // of the base to the horizontal, rad
  double gravity = 0;  // m/s^2
};

/// What flows or rests on it, over the height above the base; means over the width and over all
/// frames. One entry per height. Compression counts positive.
struct ChuteProfile {
  Slope slope;
  double particle_diameter = 0;  // d_p, m
  double scale = 0;              // w of the averaging, m
  double surface = 0;            // of the bed above the base, mean over the frames, m
  double particle_mass = 0;      // mean, kg
  std::vector<double> height;    // y, m
  std::vector<double> solid_fraction;
  std::vector<double> density;                 // kg/m^2
  std::vector<double> velocity;                // u, down the slope, m/s
  std::vector<double> shear_rate;              // du/dy, 1/s
  std::vector<double> xx, xy, yx, yy;          // contact and kinetic stress together, N/m
  std::vector<double> kinetic_xy, kinetic_yy;  // the kinetic part, N/m
  // What the matter above y asks of the stress there, its weight less what walls carry of it, N/m:
  // at rest, and in a steady flow, yy = load_onto and xy = -load_down.
  std::vector<double> load_onto, load_down;
};

/// Coarse graining along y alone, with a Gaussian g of standard deviation w, even over the width W:
///
///   solid fraction  sum A_i g(y - y_i) / W, density and momentum likewise, u their ratio
///   stress          -sum f_a b_b int g(y - y_i - s b_y) ds / W over pairs, b the branch, as
///                   CoarseGraining has it; kinetic part sum m v_a v_b g / W - rho u_a u_b
///   load            sum m_i g_a int_y^inf g / W plus the forces of walls above y
///
/// so that d sigma_ay / dy = rho g_a + t_a and its integral hold exactly at rest.
class ChuteSample {
 public:
  /// `scale`: w, m; none: d_p AR / 2, at least d_p.
  ChuteSample(const Slope& slope, std::optional<double> scale);
  /// Adds a frame; bodies and contacts are of the same timestep, the base is a wall in the
  /// contacts. @throws DataError when a column is missing, or the contacts leave the plane.
  void add(const Packing& packing, const Frame& bodies, const Frame& contacts);
  /// @throws TooFewParticles when no frame was added.
  ChuteProfile result() const;

 private:
  void start(const Packing& packing);
  void add_bodies(const Frame& bodies);
  void add_contacts(const Frame& contacts);

  Slope slope_;
  std::optional<double> scale_;
  double width_ = 0;
  int frames_ = 0;
  ChuteProfile sums_;
  std::vector<double> momentum_[2], density_slope_, momentum_slope_;
  std::vector<double> flux_xx_, flux_xy_, flux_yy_;
};

/// How the shear rate grows with the depth h below the surface, du/dy = a h^n, from 3 w above the
/// base to 3 w below the surface; n is 1/2 in Bagnold's profile. Least squares of the logarithms;
/// the standard error is that of the residuals, whose variance counts 2 sqrt(pi) w / spacing times,
/// since the kernel correlates neighbouring heights.
struct ShearLaw {
  double exponent = 0, exponent_error = 0;
};
/// None where fewer than five heights shear there.
std::optional<ShearLaw> fit_shear(const ChuteProfile& profile);

/// Means over the same heights.
struct ChuteBulk {
  double friction = 0;         // -xy / yy
  double inertial_number = 0;  // du/dy sqrt(m / P), m of a particle, P = (xx + yy) / 2
  double solid_fraction = 0;
};
/// None where the bed is too low for any.
std::optional<ChuteBulk> bulk_of(const ChuteProfile& profile);

/// The largest of |yy - load_onto| and of |xy + load_down| over all heights, over the largest
/// load_onto: how far the fields are from balancing the weight.
struct Imbalance {
  double onto = 0, down = 0;
};
Imbalance imbalance_of(const ChuteProfile& profile);

/// Writes a CSV table with a row per height.
void write_chute_table(const ChuteProfile& profile, const std::string& file);

}  // namespace rodpack

#endif
