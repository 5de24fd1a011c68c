// SPDX-License-Identifier: GPL-2.0-or-later
#include "ensemble/case_curves.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "analysis/fields.h"
#include "ensemble/interpolation.h"
#include "reading/data_error.h"
#include "reading/number_text.h"
#include "reading/table.h"

namespace rodpack {
namespace {
namespace fs = std::filesystem;

/// One table in all runs, by run; none where a run does not have it.
struct TablesOfRuns {
  std::string name;
  std::vector<std::string> files;
  std::vector<std::optional<Table>> tables;
  std::string abscissa;

  const std::vector<double>& x(std::size_t run) const { return tables[run]->column(abscissa); }
};

TablesOfRuns read_tables(const CaseRuns& one, const std::string& name) {
  TablesOfRuns read;
  read.name = name;
  for (const auto& run : one.runs) {
    read.files.push_back((fs::path(run.folder) / "analysis" / (name + ".csv")).string());
    read.tables.emplace_back();
    if (fs::exists(read.files.back())) read.tables.back() = read_table(read.files.back());
    if (read.tables.back() && read.abscissa.empty())
      read.abscissa = read.tables.back()->names().front();
  }
  return read;
}

/// Number of the run whose abscissa reaches furthest, the first of equals; none without a table.
std::optional<std::size_t> furthest(const TablesOfRuns& read) {
  std::optional<std::size_t> best;
  for (std::size_t run = 0; run < read.tables.size(); ++run)
    if (read.tables[run] && read.tables[run]->rows() > 0 &&
        (!best || read.x(run).back() > read.x(*best).back()))
      best = run;
  return best;
}

std::vector<std::string> measured_columns(const TablesOfRuns& read, std::size_t run) {
  std::vector<std::string> columns;
  for (const auto& name : read.tables[run]->names())
    if (name != read.abscissa && name.find("standard_error") == std::string::npos)
      columns.push_back(name);
  return columns;
}

CurveOfRuns empty_curve(const TablesOfRuns& read, const std::vector<double>& x) {
  return {read.abscissa, x, std::vector<ValuesOfRuns>(x.size(), ValuesOfRuns(read.tables.size()))};
}

// Bins of a run that starts with the first of `x`; all of them unless it may be shorter.
void refuse_other_bins(const TablesOfRuns& read, std::size_t run, std::size_t reference,
                       bool may_be_shorter) {
  const auto &own = read.x(run), &x = read.x(reference);
  bool same = may_be_shorter || own.size() == x.size();
  for (std::size_t k = 0; same && k < own.size(); ++k)
    same = std::fabs(own[k] - x[k]) <= 1e-6 * std::fabs(x.back());
  if (same) return;
  throw DataError(read.files[run] + ": " + std::to_string(own.size()) + " bins of " +
                  read.abscissa + " up to " + number_text(own.empty() ? 0 : own.back(), 6) +
                  ", expected the " + std::to_string(x.size()) + " bins up to " +
                  number_text(x.back(), 6) + " of " + read.files[reference] +
                  ", another run of the same case");
}

void add_binned(const CaseRuns& one, const std::string& name, bool padded, CurvesOfRuns& curves) {
  const auto read = read_tables(one, name);
  const auto reference = furthest(read);
  if (!reference) return;
  const auto& x = read.x(*reference);
  for (std::size_t run = 0; run < read.tables.size(); ++run)
    if (read.tables[run]) refuse_other_bins(read, run, *reference, padded);
  for (const auto& column : measured_columns(read, *reference)) {
    CurveOfRuns curve = empty_curve(read, x);
    for (std::size_t run = 0; run < read.tables.size(); ++run) {
      if (!read.tables[run]) continue;
      const auto& values = read.tables[run]->column(column);
      for (std::size_t k = 0; k < x.size(); ++k)
        curve.y[k][run] = k < values.size() ? values[k] : 0;
    }
    curves[name + "." + column] = std::move(curve);
  }
}

void add_over_height(const CaseRuns& one, CurvesOfRuns& curves) {
  const auto read = read_tables(one, "solid_fraction");
  const auto highest = furthest(read);
  if (!highest) return;
  for (const auto& column : measured_columns(read, *highest)) {
    CurveOfRuns curve = empty_curve(read, read.x(*highest));
    for (std::size_t run = 0; run < read.tables.size(); ++run)
      for (std::size_t k = 0; read.tables[run] && k < curve.x.size(); ++k)
        curve.y[k][run] = interpolated(read.x(run), read.tables[run]->column(column), curve.x[k]);
    curves["solid_fraction." + column] = std::move(curve);
  }
}

const std::vector<std::string> principal_columns = {"sigma_1_N_m", "sigma_2_N_m",
                                                    "sigma_1_direction_deg", "anisotropy"};

// What the profile's table derives from the stress, from its four components.
void add_principal(CurvesOfRuns& curves) {
  const auto& xx = curves.at("profile.stress_xx_N_m");
  const auto& xy = curves.at("profile.stress_xy_N_m");
  const auto& yx = curves.at("profile.stress_yx_N_m");
  const auto& yy = curves.at("profile.stress_yy_N_m");
  std::vector<CurveOfRuns> derived(
      principal_columns.size(),
      {xx.abscissa, xx.x,
       std::vector<ValuesOfRuns>(xx.x.size(), ValuesOfRuns(xx.y.front().size()))});
  for (std::size_t k = 0; k < xx.x.size(); ++k)
    for (std::size_t run = 0; run < xx.y[k].size(); ++run) {
      if (!xx.y[k][run]) continue;
      const auto stress =
          principal_stress(*xx.y[k][run], *xy.y[k][run], *yx.y[k][run], *yy.y[k][run]);
      derived[0].y[k][run] = stress.larger;
      derived[1].y[k][run] = stress.smaller;
      derived[2].y[k][run] = stress.direction;
      derived[3].y[k][run] = anisotropy(stress);
    }
  for (std::size_t c = 0; c < derived.size(); ++c)
    curves["profile." + principal_columns[c]] = std::move(derived[c]);
}

// The table ends at the floor, so that its last depth is the height of the bed.
void add_profile(const CaseRuns& one, CurvesOfRuns& curves) {
  const auto read = read_tables(one, "profile");
  const auto highest = furthest(read);
  if (!highest) return;
  auto x = read.x(*highest);
  // The surface itself, but for a rounding error.
  if (std::fabs(x.front()) < 1e-9 * x.back()) x.front() = 0;
  for (const auto& column : measured_columns(read, *highest)) {
    if (std::count(principal_columns.begin(), principal_columns.end(), column)) continue;
    CurveOfRuns curve = empty_curve(read, x);
    for (std::size_t run = 0; run < read.tables.size(); ++run) {
      if (!read.tables[run]) continue;
      auto depth = read.x(run);
      for (double& h : depth) h += x.back() - read.x(run).back();
      for (std::size_t k = 0; k < x.size(); ++k)
        curve.y[k][run] = interpolated(depth, read.tables[run]->column(column), x[k]);
    }
    curves["profile." + column] = std::move(curve);
  }
  add_principal(curves);
}

}  // namespace

CurvesOfRuns read_curves(const CaseRuns& one) {
  CurvesOfRuns curves;
  for (const char* table : {"orientation", "rdf", "forces_friction"})
    add_binned(one, table, false, curves);
  for (const char* table : {"forces", "forces_coordination"}) add_binned(one, table, true, curves);
  add_over_height(one, curves);
  add_profile(one, curves);
  return curves;
}

}  // namespace rodpack
