// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/energies.h"

#include "reading/checks/line_end.h"
#include "reading/data_error.h"
#include "reading/table.h"

namespace rodpack {

EnergyHistory read_energies(const std::string& energies_csv) {
  const Table table = read_table(energies_csv);
  require_line_end(energies_csv);
  const auto& times = table.finite("time_s");
  const auto& translational = table.finite("kinetic_translational_J");
  const auto& rotational = table.finite("kinetic_rotational_J");
  const auto& normal = table.finite("elastic_normal_J");
  const auto& tangential = table.finite("elastic_tangential_J");
  EnergyHistory energies;
  for (std::size_t i = 0; i < times.size(); ++i) {
    while (!energies.time.empty() && energies.time.back() >= times[i]) {
      energies.time.pop_back();
      energies.kinetic.pop_back();
      energies.elastic.pop_back();
    }
    energies.time.push_back(times[i]);
    energies.kinetic.push_back(translational[i] + rotational[i]);
    energies.elastic.push_back(normal[i] + tangential[i]);
  }
  if (energies.time.empty()) throw DataError(energies_csv + ": no rows below the header");
  return energies;
}

}  // namespace rodpack
