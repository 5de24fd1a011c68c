// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_FIELDS_H
#define RODPACK_ANALYSIS_FIELDS_H

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "reading/packing.h"
#include "rodpack/averaging/coarse_graining.h"
#include "rodpack/geometry/disc_in_rectangle.h"

namespace rodpack {

/// By what densities are divided: nothing (Goldhirsch, as in the paper); the kernel's share between
/// side walls and above the floor; or that, and below the bed's surface.
enum class Normalisation { none, walls, walls_and_surface };

struct FieldOptions {
  std::optional<double> scale;                  // w, m; none: see the next
  std::optional<double> scale_in_diameters;     // w / d_p; none: 3 AR
  std::optional<double> spacing;                // of the grid, m; none: w/4
  std::optional<std::array<double, 4>> window;  // xlo, xhi, ylo, yhi of the grid, m; none: the bed
  std::string kernel = "gaussian";
  std::string line = "auto";
  double tolerance = 1e-6;
  bool couple_stress = false;
  Normalisation normalisation = Normalisation::none;
};

/// Returns the space that a kernel may count, m: between the packing's walls, up to the bed's
/// surface if that is asked for; endless where there is no wall, everywhere for `none`.
Rectangle counted_space(const Packing& packing, Normalisation normalisation);

/// Returns the scale w of the averaging, m. @throws DataError when it is not positive.
double averaging_scale(const Packing& packing, const FieldOptions& options);

/// Reads the rows of a contacts dump (body_i body_j wall x y z fx fy fz bix biy biz bjx bjy bjz).
/// @throws DataError when a column is missing.
std::vector<SphereContact> read_contacts(const Frame& contacts);

/// Reads the rows of a bodies dump (id x y z vx vy vz mass); how many others each touches from
/// `pairs`. `extent`: covered area or volume of each, m^2 or m^3.
std::vector<Particle> read_particles(const Frame& bodies, const std::vector<double>& extent,
                                     const std::vector<TouchingPair>& pairs);

/// Choose kernel, line rule and periods for a two-dimensional packing.
AveragingKernel averaging_kernel(const Packing& packing, const FieldOptions& options);
CoarseGrainingOptions averaging_options(const Packing& packing, const FieldOptions& options);

/// Returns `grid`. @throws DataError when it has more places than memory is meant for.
Grid checked_grid(const Grid& grid);

/// What one frame adds to the sums.
struct AveragedFrame {
  std::vector<Particle> particles;
  std::vector<Interaction> interactions;
  void add_to(CoarseGraining& averages) const;
};
/// Reads it from the particles of a bodies frame and, unless null, the contacts of the same
/// timestep; `dimension`: 2, with the column `area`, or 3, with body_volumes().
/// @throws DataError when a column is missing, the timesteps differ, a contact names a particle
/// that is not among the bodies or is far from it, or, in two dimensions, is out of the plane.
AveragedFrame averaged_frame(const Frame& bodies, const Frame* contacts, int dimension);
/// Adds it to the sums. @throws as averaged_frame().
void add_frame(CoarseGraining& averages, const Frame& bodies, const Frame* contacts);

/// Fields on the grid of FieldOptions, averaged over the frames that were added; the walls, the
/// surface and so the default grid are those of the first one.
class FieldSample {
 public:
  explicit FieldSample(FieldOptions options) : options_(std::move(options)) {}
  /// @throws DataError as add_frame(), and for a grid that is empty or lies beside the packing.
  void add(const Packing& packing, const Frame& bodies, const Frame* contacts);
  /// @throws TooFewParticles when no frame was added.
  const CoarseGraining& averages() const;
  /// The fields, normalised as the options say, by walls and surface of the first frame.
  std::vector<Field> fields() const;
  /// What the options divide them by.
  Normalisation normalisation() const { return options_.normalisation; }

 private:
  FieldOptions options_;
  std::unique_ptr<CoarseGraining> averages_;
  Rectangle space_{};
  int frames_ = 0;
};

/// Finds the field of that name. @throws std::out_of_range when there is none.
const Field& field_named(const std::vector<Field>& fields, const std::string& name);

/// Principal values of the symmetric part of a plane stress, and the direction of the larger one.
struct PrincipalStress {
  double larger, smaller;  // N/m
  double direction;        // of the larger one, degrees in [0, 180) from the x axis
};
/// Computes them from the components, N/m.
PrincipalStress principal_stress(double xx, double xy, double yx, double yy);

/// (larger - smaller) / (larger + smaller): 0 isotropic; 0 too without compression.
double anisotropy(const PrincipalStress& stress);

/// Writes `stem`.csv and `stem`.vti; `time_s`: s. @throws DataError when one cannot be written.
void write_fields(const CoarseGraining& averages, const std::vector<Field>& fields, double time_s,
                  const std::string& stem);

}  // namespace rodpack

#endif
