// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_SPACE_VERTICAL_PROFILE_H
#define RODPACK_ANALYSIS_SPACE_VERTICAL_PROFILE_H

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "analysis/fields.h"
#include "analysis/janssen_fit.h"
#include "reading/space/spatial_packing.h"

namespace rodpack {

/// Means over the container's whole cross-section, one entry per depth, from the surface down to
/// the floor. Compression counts positive; forces are those on particles.
struct VerticalProfile {
  std::size_t axis = 2;          // the vertical, 0 to 2
  double particle_diameter = 0;  // d_p, m
  double scale = 0;              // w, m
  double depth_of_floor = 0;     // m
  double cross_section = 0;      // of the container, m^2
  std::vector<double> depth;     // h below the surface of the bed, m
  std::vector<double> solid_fraction;
  std::vector<double> density;   // kg/m^3
  std::vector<double> vertical;  // contact stress along the vertical, N/m^2
  std::array<std::vector<double>, 2>
      horizontal;                  // along SpatialWalls::horizontal(0) and (1), N/m^2
  std::vector<double> pressure;    // a third of the trace, N/m^2
  std::vector<double> wall_force;  // upward force of the walls per volume, N/m^3
};

/// Coarse graining along the vertical z alone: the fields of CoarseGraining with a Gaussian g of
/// standard deviation w in z that is even over the cross-section A, so that no side wall cuts it:
///
///   solid fraction   sum V_i g(z - z_i) / A, and the density with masses
///   contact stress   sigma_ab = -sum f_a b_b int g(z - z_i - s b_z) ds / A, over pairs, b the
///   branch
///
/// and d sigma_zz / dz = -density g + wall force at rest. The integral is an error function.
/// `options`: scale (none: AR d_p / 2), spacing (none: w/4) and normalisation, by the share of g
/// above the floor, and below the surface; the kernel is always Gaussian.
class VerticalProfileSample {
 public:
  explicit VerticalProfileSample(FieldOptions options) : options_(std::move(options)) {}
  /// Adds a frame; bodies and contacts are of the same timestep; without contacts, null, there is
  /// no stress. Walls and surface are those of the first one. @throws DataError when a column is
  /// missing, the vertical is periodic or has too many
  ///   places, TooFewParticles when there is no bed.
  void add(const SpatialPacking& packing, const Frame& bodies, const Frame* contacts);
  /// @throws TooFewParticles when no frame was added.
  VerticalProfile result() const;

 private:
  void start(const SpatialPacking& packing);

  FieldOptions options_;
  SpatialWalls walls_;
  double surface_ = 0;
  VerticalProfile sums_;
  int frames_ = 0;
};

/// Mean solid fraction from 3 w above the floor to 3 w below the surface, where the kernel reaches
/// beyond neither; none in a bed too low for two places there.
std::optional<double> mean_solid_fraction(const VerticalProfile& profile);

/// Fits Janssen's law to the vertical stress of the profile; as fit_janssen() of a plane, with
/// N/m^2 for N/m. @throws as that.
JanssenFit fit_janssen(const VerticalProfile& profile);

/// Writes a CSV table with the columns h_over_dp, solid_fraction, density_kg_m3,
/// stress_vertical_N_m2, stress_horizontal_1_N_m2, stress_horizontal_2_N_m2, pressure_N_m2,
/// wall_force_N_m3.
void write_vertical_profile_table(const VerticalProfile& profile, const std::string& file);
/// The same of the solid fraction alone, from the floor up: height_over_dp, solid_fraction,
/// density_kg_m3.
void write_layer_table(const VerticalProfile& profile, const std::string& file);

}  // namespace rodpack

#endif
