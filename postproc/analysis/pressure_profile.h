// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PRESSURE_PROFILE_H
#define RODPACK_PRESSURE_PROFILE_H

#include <memory>
#include <string>
#include <vector>

#include "analysis/fields.h"

namespace rodpack {

/// Contact stress in the central vertical slice, 2 AR d_p wide (physics.md section 5), one entry
/// per depth, from the surface down to the floor; means over the slice's width.
struct PressureProfile {
  double particle_diameter = 0;            // d_p, m
  double scale = 0;                        // w, m
  double depth_of_floor = 0;               // m
  std::vector<double> depth;               // h below the surface of the bed, m
  std::vector<double> xx, xy, yx, yy;      // N/m
  std::vector<PrincipalStress> principal;  // of the mean stress
  std::vector<double> pressure;            // P_0 = (sigma_1 + sigma_2) / 2, N/m
  std::vector<double> solid_fraction;
};

/// Averages over the frames that were added; walls and surface are those of the first one.
class ProfileSample {
 public:
  explicit ProfileSample(FieldOptions options) : options_(std::move(options)) {}
  /// @throws DataError as add_frame().
  void add(const Packing& packing, const Frame& bodies, const Frame& contacts);
  /// @throws TooFewParticles when no frame was added or there is no bed.
  PressureProfile result() const;

 private:
  FieldOptions options_;
  Packing packing_;
  std::unique_ptr<CoarseGraining> averages_;
  int frames_ = 0;
};

/// P_0(h) = P_j (1 - exp(-h / h_c)), Janssen's law, fitted by least squares.
struct JanssenFit {
  double pressure = 0, pressure_error = 0;  // P_j and its standard error, N/m
  double depth = 0, depth_error = 0;        // h_c and its standard error, m
  double rms_residual = 0;                  // N/m
  double from = 0, to = 0;                  // depths of the fit, m
  bool saturates = false;                   // h_c is smaller than the depth `to`
};

/// Fits the depths from the surface to 3 w above the floor.
/// The standard errors come from the residuals; neighbouring depths share their noise through the
/// kernel, whose correlation over a distance x is exp(-x^2 / 4 w^2), so that the variances are
/// multiplied by its integral 2 sqrt(pi) w over the spacing of the depths.
/// @throws TooFewParticles in a bed lower than 6 w, where the smoothing outweighs the law, with fewer
/// than 5 depths, and when the fit does not converge.
JanssenFit fit_janssen(const PressureProfile& profile);

/// Columns h_over_dp, pressure_N_m, stress_xx_N_m ..., sigma_1_N_m, sigma_2_N_m,
/// sigma_1_direction_deg, anisotropy, solid_fraction.
void write_profile_table(const PressureProfile& profile, const std::string& file);
/// P_0 over depth, with the fit if there is one: `stem`.png and `stem`.svg.
void plot_profile(const PressureProfile& profile, const JanssenFit* fit, const std::string& stem);
/// "P_j = ... +- ... N/m, h_c = ... +- ... d_p" or that the pressure does not saturate.
std::string describe(const JanssenFit& fit, double particle_diameter);

}  // namespace rodpack

#endif
