// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_AVERAGING_COARSE_GRAINING_H
#define RODPACK_AVERAGING_COARSE_GRAINING_H

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "averaging_kernel.h"
#include "../contact/contact_pairs.h"
#include "line_rule.h"

namespace rodpack {

/// Evenly spaced places, x fastest, then y, then z. In two dimensions count[2] is 1.
struct Grid {
  Vector origin{{0, 0, 0}};   // first place, m
  Vector spacing{{1, 1, 1}};  // m
  std::array<int, 3> count{{1, 1, 1}};

  std::size_t size() const {
    return static_cast<std::size_t>(count[0]) * static_cast<std::size_t>(count[1]) *
           static_cast<std::size_t>(count[2]);
  }
  Vector place(std::size_t index) const;
};

/// Places about `spacing` apart that fill a box of `dimension` axes evenly, both ends included.
/// @throws std::invalid_argument when spacing is not positive, the box is empty, or the grid would
/// have more than 1e8 places.
Grid filling_grid(int dimension, const Vector& low, const Vector& high, double spacing);

/// One rigid particle. SI units.
struct Particle {
  Vector centre, velocity;  // of mass, m, m/s
  double mass;              // kg
  double extent;            // covered area (m^2, two dimensions) or volume (m^3)
  Touching touching;
};

/// A field of D-dimensional tensors of some rank at every place.
struct Field {
  std::string name;                         // contact_stress
  std::string unit;                         // as it ends names of columns: N_m for N/m; or empty
  std::vector<std::string> components;      // xx xy yx yy; one empty name for a scalar
  std::vector<std::vector<double>> values;  // components x places

  /// name, component and unit, joined by underscores: contact_stress_xx_N_m.
  std::string column(std::size_t component) const;
};

struct CoarseGrainingOptions {
  LineRule line;
  bool couple_stress = false;
  Vector period{{0, 0, 0}};  // of the scene along each axis, m; 0: not periodic
};

/// Fields of a scene of rigid particles by the kernel phi (Goldhirsch, Granular Matter 12, 239,
/// 2010; walls: Weinhart et al., Granular Matter 14, 289, 2012), as sums over particles and over
/// pairs of them. Two dimensions look at x and y alone. Compression counts positive:
///
///   contact stress   sigma_ab = -sum f_a r_b int phi(r - r_i - s r_ij) ds, f the force on i and
///                    r_b a component of r_ij = r_j - r_i; at a wall r_j is the contact point
///                    (sums are over pairs, integrals over s from 0 to 1)
///   kinetic stress   sum m v_a v_b phi - rho u_a u_b, that of the deviations from the velocity u
///   boundary force density  t = sum of wall forces on particles, each times phi(r - contact point)
///   couple stress    mu_ab = -sum r_b int [(c - x(s)) x f]_a phi(r - x(s)) ds, with c the contact
///                    point: the moment that is transmitted across x(s) = r_i + s r_ij
///
/// so that d sigma_ab / d r_b = rho g_a + t_a and d mu_ab / d r_b = e_abc sigma_bc at rest.
/// All sums are linear: those of several processes, or frames, add up.
class CoarseGraining {
 public:
  /// Averages at the places of a grid. @throws std::invalid_argument for a grid without places or
  /// of more dimensions than the kernel.
  CoarseGraining(const AveragingKernel& kernel, const Grid& grid,
                 const CoarseGrainingOptions& options = {});
  /// Averages at given places, in any order.
  CoarseGraining(const AveragingKernel& kernel, std::vector<Vector> places,
                 const CoarseGrainingOptions& options = {});

  void add(const Particle& particle);
  void add(const Interaction& interaction);

  std::size_t places() const { return places_; }
  Vector place(std::size_t index) const {
    return gridded_ ? grid_.place(index) : scattered_[index];
  }
  const AveragingKernel& kernel() const { return kernel_; }

  /// The sums so far, sums x places, to be added up over processes; then fields() holds for all.
  std::vector<double>& sums() { return sums_; }
  const Grid* grid() const { return gridded_ ? &grid_ : nullptr; }

  /// number_density, mass_density, solid_fraction, momentum_density, velocity (0 where there is no
  /// mass), contact_stress, kinetic_stress, boundary_force_density, coordination_number (touching
  /// particles of a particle), contacts_per_particle, and couple_stress if asked for. `frames`
  /// divides the sums: the mean over so many frames.
  std::vector<Field> fields(double frames = 1) const;

 private:
  struct GridRow {  // places of one y and z
    double x, y, z;
  };
  struct Range {
    int begin, end;
  };

  void prepare(const CoarseGrainingOptions& options);
  template <class Visit>
  void for_images(const Vector& low, const Vector& high, Visit visit) const;
  template <class Visit>
  void for_rows(const Vector& low, const Vector& high, Visit visit) const;
  void spread(const Vector& centre, std::size_t first, std::size_t count, const double* values);
  void spread_line(const Interaction& interaction, const Vector& from);
  Range columns_within(const GridRow& row, double low, double high) const;
  void add_weighted(std::size_t row, Range columns, std::size_t first, std::size_t count,
                    const double* values);

  AveragingKernel kernel_;
  CoarseGrainingOptions options_;
  int dimension_;
  bool gridded_;
  Grid grid_;
  std::vector<GridRow> rows_;       // by y where the places are scattered, one place each
  std::vector<Vector> scattered_;   // places, as given
  std::vector<std::size_t> order_;  // scattered: index of the place of each row
  int columns_;                     // places in a row
  std::size_t places_;
  Vector low_, high_;  // corners of the box around all places
  std::size_t particle_sums_, line_sums_;
  std::vector<double> sums_;
  std::vector<double> weights_, factors_;  // of one source, along a row
};

/// Comma-separated text: a header line, then a line per place with x_m, y_m (z_m) and every
/// component of every field, to 15 significant digits.
std::string csv_text(const CoarseGraining& averages, const std::vector<Field>& fields);

}  // namespace rodpack

#endif
