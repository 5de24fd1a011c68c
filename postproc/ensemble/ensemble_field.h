// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ENSEMBLE_ENSEMBLE_FIELD_H
#define RODPACK_ENSEMBLE_ENSEMBLE_FIELD_H

#include <optional>
#include <string>
#include <vector>

#include "ensemble/cases.h"
#include "ensemble/ensemble.h"

namespace rodpack {

/// Mean map over the repetitions of a case, on a grid of its own: one entry per place, row by row
/// from the floor up.
struct EnsembleField {
  std::vector<double> x, y;                  // of the columns and of the rows, m
  std::vector<EnsembleMean> solid_fraction;  // [row * x.size() + column]
  std::vector<EnsembleMean> pressure;        // P_0 of the contact stress, N/m; empty without stress
};

/// Means of the runs' analysis/fields.csv. The columns of the grid are those of every run; its rows
/// are those of the highest bed, at which the others are interpolated(). A run has no value above
/// its own grid, which ends w above its surface. None when no run has fields.
/// @throws DataError naming the run when columns differ or a table is malformed.
std::optional<EnsembleField> mean_field(const CaseRuns& one);

/// Writes a CSV table with the columns x_m, y_m, then solid_fraction and pressure_N_m, each with
/// its _sem and _n. @throws DataError when it cannot be written.
void write_ensemble_field(const EnsembleField& field, const std::string& file);

/// Reads it. @throws DataError when it is missing or malformed.
EnsembleField read_ensemble_field(const std::string& file);

}  // namespace rodpack

#endif
