// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_JANSSEN_FIT_H
#define RODPACK_ANALYSIS_JANSSEN_FIT_H

#include <string>

#include "analysis/pressure_profile.h"

namespace rodpack {

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
/// @throws TooFewParticles where gravity is not along -y, in a bed lower than 6 w, where the
/// smoothing outweighs the law, with fewer than 5 depths, and when the fit does not converge.
JanssenFit fit_janssen(const PressureProfile& profile);

/// Says the fit in one line: "P_j = ... +- ... N/m, h_c = ... +- ... d_p", or that the pressure
/// does not saturate. `particle_diameter`: d_p, m; `unit`: of the pressure, in space Pa.
std::string describe(const JanssenFit& fit, double particle_diameter,
                     const std::string& unit = "N/m");

}  // namespace rodpack

#endif
