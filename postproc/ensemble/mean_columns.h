// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ENSEMBLE_MEAN_COLUMNS_H
#define RODPACK_ENSEMBLE_MEAN_COLUMNS_H

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "ensemble/ensemble.h"

namespace rodpack {

using CsvColumns = std::vector<std::pair<std::string, std::vector<double>>>;

/// Adds the columns NAME, NAME_sem (NaN for none) and NAME_n to a table for write_csv().
inline void add_mean_columns(const std::string& name, const std::vector<EnsembleMean>& means,
                             CsvColumns& table) {
  std::vector<double> mean, sem, n;
  for (const auto& each : means) {
    mean.push_back(each.mean);
    sem.push_back(each.sem.value_or(std::numeric_limits<double>::quiet_NaN()));
    n.push_back(each.n);
  }
  table.emplace_back(name, std::move(mean));
  table.emplace_back(name + "_sem", std::move(sem));
  table.emplace_back(name + "_n", std::move(n));
}

}  // namespace rodpack

#endif
