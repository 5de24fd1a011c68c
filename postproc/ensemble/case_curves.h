// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ENSEMBLE_CASE_CURVES_H
#define RODPACK_ENSEMBLE_CASE_CURVES_H

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ensemble/cases.h"
#include "ensemble/statistics.h"

namespace rodpack {

/// A curve that was measured in every run, on a common abscissa.
struct CurveOfRuns {
  std::string abscissa;
  std::vector<double> x;
  std::vector<ValuesOfRuns> y;  // [bin][run]
};
using CurvesOfRuns = std::map<std::string, CurveOfRuns>;  // by table and column: rdf.g

/// Reads the tables of the runs' analyses and brings each to a common abscissa:
/// - orientation, rdf, forces_friction: the bins are the same in every run;
/// - forces, forces_coordination: a shorter table goes on with zeros, for it ends where the run has
///   nothing more to count;
/// - solid_fraction: interpolated() at the heights of the highest bed;
/// - profile: depth counts from the surface of the highest bed, interpolated() at its depths; the
///   principal stresses and the anisotropy are those of the interpolated stress.
/// A run has no value where it has no table, and above its own surface. Standard errors within a
/// run are left out: those over runs take their place.
/// @throws DataError naming the run when bins differ, or a table is malformed.
CurvesOfRuns read_curves(const CaseRuns& one);

}  // namespace rodpack

#endif
