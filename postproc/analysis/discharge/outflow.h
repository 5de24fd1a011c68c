// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_DISCHARGE_OUTFLOW_H
#define RODPACK_ANALYSIS_DISCHARGE_OUTFLOW_H

#include <optional>
#include <string>
#include <vector>

namespace rodpack {

/// What inputs/discharge/ has counted over time, one entry per row of its discharge.csv.
struct OutflowHistory {
  std::vector<double> time;        // since the shutter was let go, s, increasing
  std::vector<double> inside;      // particles above the orifice
  std::vector<double> discharged;  // particles that have come through
  std::vector<double> throat;      // particles in the space above the orifice
  std::string file = "discharge";  // that holds them, for messages
};

/// Reads a discharge.csv (columns since_opening_s, inside, discharged, throat), without the rows
/// that a run resumed from a restart has computed anew. @throws DataError when a column is missing,
/// a field is no time or count, the file is cut short, or there are no rows after the opening.
OutflowHistory read_outflow(const std::string& discharge_csv);

/// How a discharge ended.
enum class OutflowEnd { flowing, clogged, drained, closed };

struct OutflowOptions {
  // The steady part of the flow: from this share of all that comes through to that one.
  double from = 0.2, to = 0.7;
  double stopped_after = 0.2;  // without outflow for so long, s, it has stopped
  // When the orifice was closed, s after its opening: nothing later counts.
  std::optional<double> closed_at = {};
};

/// The steady flow through an orifice.
struct Outflow {
  std::optional<double> rate, rate_error;  // particles/s and its standard error; none with too few
  double from = 0, to = 0;                 // times since the opening that it is the mean over, s
  double discharged = 0, inside = 0;       // particles, at the end
  double last = 0;                         // when the last particle came through, s
  OutflowEnd end = OutflowEnd::flowing;
};

/// Measures the mean rate between the times when the shares `from` and `to` of all that comes
/// through have done so, which leaves out the start and the emptying. Its standard error is that
/// of the mean over ten intervals of equal length, taken for independent. No rate where fewer than
/// 50 particles come through in that time, or it has fewer than 20 rows.
/// With less than a quarter of what was in the throat at the opening there the silo has drained, to
/// the wedges beside the orifice of which single particles may still come. With more it has clogged
/// if nothing came through during the last `stopped_after` seconds, else it is flowing, or has been
/// closed.
/// @throws DataError when nothing has been counted before the opening.
Outflow measure_outflow(OutflowHistory history, const OutflowOptions& options);

/// Says "flowing", "clogged", "drained" or "closed".
std::string describe(OutflowEnd end);

}  // namespace rodpack

#endif
