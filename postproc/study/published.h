// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_STUDY_PUBLISHED_H
#define RODPACK_STUDY_PUBLISHED_H

#include <optional>
#include <string>
#include <vector>

#include "ensemble/ensemble.h"

namespace rodpack {

/// A value that somebody has published.
struct PublishedValue {
  std::string case_name;        // as in the study: coarse-AR2
  std::string quantity;         // as in EnsembleCase::numbers: solid_fraction
  double value = 0, error = 0;  // in the unit of the quantity
  double rounding = 0;  // standard deviation of what rounding took away: the last printed digit of
                        // the value over sqrt(12), as of a uniform distribution
  std::string source;
};

/// Finds the file of published values: `given`, unless it is empty; else published.csv in the
/// folder `study`; else inputs/study/published.csv, found as the decks are.
std::string find_published(const std::string& given, const std::string& study);

/// Reads a CSV table with the columns case, quantity, value, error, source.
/// @throws DataError naming file, line and what was expected when a case has neither the name of
/// one of the paper's nor of one of the ensemble's, a quantity is neither one that `rodpack
/// ensemble` has nor in the ensemble, the error is negative, or two lines give the same value.
std::vector<PublishedValue> read_published(const std::string& file, const Ensemble& ensemble);

/// What was measured beside what was published.
struct PublishedComparison {
  std::string case_name, quantity;
  EnsembleMean measured;
  std::optional<PublishedValue> published;
  double difference = 0;                 // measured less published
  std::optional<double> combined_error;  // root of the sum of the squares of the standard error,
                                         // the published error and its rounding; none for a single
                                         // repetition, whose error is not known

  /// The difference in units of the combined error.
  std::optional<double> deviation() const;
};

/// Compares a number of the ensemble with every published value of it, in the order of the cases; a
/// case without one has a row too. Sensitivity cases are left out unless there is one.
std::vector<PublishedComparison> compare_with_published(
    const Ensemble& ensemble, const std::vector<PublishedValue>& published,
    const std::string& quantity);

/// Says over which heights a solid fraction of that name is averaged; empty for other quantities.
std::string averaging_of(const std::string& quantity);

/// Writes the paper's Table 2: `stem`.csv, a row per case, averaging height and published value,
/// and `stem`.md, a row per case. The published values, which name no distance from the surface,
/// stand beside either average.
/// @return false when no case has a solid fraction. @throws DataError when a file cannot be
/// written.
bool write_solid_fraction_table(const Ensemble& ensemble,
                                const std::vector<PublishedValue>& published,
                                const std::string& stem);

}  // namespace rodpack

#endif
