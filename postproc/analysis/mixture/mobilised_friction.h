// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_MIXTURE_MOBILISED_FRICTION_H
#define RODPACK_ANALYSIS_MIXTURE_MOBILISED_FRICTION_H

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "reading/dump.h"
#include "reading/scene/run_scene.h"

namespace rodpack {

/// A contact that can slide: its forces and what they are measured by.
struct FrictionalContact {
  double normal, tangential;   // magnitudes, N
  int lower_type, upper_type;  // atom types of its two sides; 0: not told, or of no matter
  double coefficient;          // mu
};

/// The friction of the contacts of a frame.
class FrictionOfContacts {
 public:
  /// Columns, where the table has more than one coefficient: `wall type_i type_j`; 0 in the last:
  /// not told, as of the walls of LIGGGHTS's own dumps. Both have to outlive this.
  /// @throws DataError when a column is missing.
  FrictionOfContacts(const Frame& contacts, const FrictionTable& table);
  /// A contact with its coefficient; forces: magnitudes, N. @throws DataError naming line and type
  /// where the table has none for it.
  FrictionalContact of(std::size_t row, double normal, double tangential) const;

 private:
  int type_of(std::size_t row, bool second, int least) const;
  double with_any(std::size_t row, int type) const;

  const Frame& contacts_;
  const FrictionTable& table_;
  const std::vector<double>*wall_ = nullptr, *first_ = nullptr, *second_ = nullptr;
};

/// What the contacts of two atom types mobilise, each other's or a wall's; 0: the wall's is not
/// told.
struct FrictionOfTypes {
  int lower_type = 0, upper_type = 0;
  double coefficient = 0;  // mu
  std::size_t contacts = 0;
  double mean = 0, sliding_fraction = 0;
};

/// f_t / (mu f_n), at most 1, mu that of the contact's two atom types: the law caps the elastic
/// part only, so that a dashpot may carry it beyond. One entry per bin, the last one with what
/// slides.
struct MobilisedFriction {
  double lowest = 0, highest = 0;  // mu
  std::size_t frictionless = 0;    // left out: contacts of mu = 0
  double mean = 0;
  double sliding_fraction = 0;           // of the contacts, at least 0.999 mobilised
  std::vector<double> centre;            // of the bins
  std::vector<double> count;             // contacts in the bin
  std::vector<double> density;           // integrates to 1
  std::vector<double> standard_error;    // binomial, of the density
  std::vector<FrictionOfTypes> by_type;  // of each pair that touches; empty where mu is the same
};

/// Measures it; none where no contact has friction.
std::optional<MobilisedFriction> mobilised_friction(const std::vector<FrictionalContact>& contacts);

/// Writes `stem`.csv of the bins, and `stem`_types.csv of the pairs of types, where there are some.
/// Returns the latter's name, or nothing.
std::string write_friction_tables(const MobilisedFriction& friction, const std::string& stem);

}  // namespace rodpack

#endif
