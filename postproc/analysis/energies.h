// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_ENERGIES_H
#define RODPACK_ANALYSIS_ENERGIES_H

#include <string>
#include <vector>

namespace rodpack {

/// Energies of a run over time, one entry per row of its energies.csv.
struct EnergyHistory {
  std::vector<double> time;     // s, increasing
  std::vector<double> kinetic;  // of translation and rotation, J
  std::vector<double> elastic;  // of normal and tangential springs, J
};

/// Reads an energies.csv (columns time_s, kinetic_translational_J, kinetic_rotational_J,
/// elastic_normal_J, elastic_tangential_J), without the rows that a run resumed from a restart has
/// computed anew. @throws DataError when a column is missing, a field is not a number, or there are
/// no rows.
EnergyHistory read_energies(const std::string& energies_csv);

}  // namespace rodpack

#endif
