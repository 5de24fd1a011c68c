// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_PRESSURE_PROFILE_H
#define RODPACK_ANALYSIS_PRESSURE_PROFILE_H

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/fields.h"

namespace rodpack {

/// Contact stress in the central vertical slice, 2 AR d_p wide, where x is periodic as wide as the
/// period (postproc/README.md, Definitions), one entry per depth, from the surface down to the
/// floor; means over the slice's width.
struct PressureProfile {
  double particle_diameter = 0;    // d_p, m
  double scale = 0;                // w, m
  double depth_of_floor = 0;       // m
  double reach = 0;                // kernel_reach(), m
  double inclination = 0;          // of gravity against -y, rad
  bool walls_divided_out = false;  // by the kernel's share between them
  // Depths between which the averages hold nothing of the space beyond walls and surface, m; none
  // when the second is not larger. Set for a packing's own profile alone.
  std::array<double, 2> undisturbed{};
  std::vector<double> depth;               // h below the surface of the bed, m
  std::vector<double> xx, xy, yx, yy;      // N/m
  std::vector<PrincipalStress> principal;  // of the mean stress
  std::vector<double> pressure;            // P_0 = (sigma_1 + sigma_2) / 2, N/m
  std::vector<double> solid_fraction;
};

/// A mean P_0(h) as a profile, for fit_janssen().
/// @param depth_over_dp  h below the highest surface, d_p; the last one is that of the floor
/// @param pressure       P_0, N/m; depths without a value are left out
/// @param omega          the kernel's width, m
PressureProfile mean_profile(const std::vector<double>& depth_over_dp,
                             const std::vector<std::optional<double>>& pressure,
                             double particle_diameter, double omega);

/// Averages over the frames that were added; walls and surface are those of the first one.
class ProfileSample {
 public:
  explicit ProfileSample(FieldOptions options) : options_(std::move(options)) {}
  /// Adds a frame; bodies and contacts are of the same timestep. @throws DataError as add_frame().
  void add(const Packing& packing, const Frame& bodies, const Frame& contacts);
  /// @throws TooFewParticles when no frame was added or there is no bed.
  PressureProfile result() const;

 private:
  FieldOptions options_;
  Packing packing_;
  std::unique_ptr<CoarseGraining> averages_;
  int frames_ = 0;
};

/// Writes a CSV table with the columns h_over_dp, pressure_N_m, stress_xx_N_m ..., sigma_1_N_m,
/// sigma_2_N_m, sigma_1_direction_deg, anisotropy, solid_fraction.
void write_profile_table(const PressureProfile& profile, const std::string& file);
}  // namespace rodpack

#endif
