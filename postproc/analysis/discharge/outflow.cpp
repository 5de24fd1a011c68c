// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/discharge/outflow.h"

#include <algorithm>
#include <cmath>

#include "reading/checks/line_end.h"
#include "reading/data_error.h"
#include "reading/number_text.h"
#include "reading/table.h"

namespace rodpack {
namespace {

// Linear between rows; `x` increases.
double between(const std::vector<double>& x, const std::vector<double>& y, double at) {
  const auto next = std::upper_bound(x.begin(), x.end(), at) - x.begin();
  if (next == 0) return y.front();
  const auto i = static_cast<std::size_t>(next);
  if (i == x.size()) return y.back();
  return y[i - 1] + (y[i] - y[i - 1]) * (at - x[i - 1]) / (x[i] - x[i - 1]);
}

// First time at which so many have come through, linear between rows.
double time_of(const OutflowHistory& history, double discharged) {
  const auto& n = history.discharged;
  std::size_t i = 0;
  while (i + 1 < n.size() && n[i] < discharged) ++i;
  if (i == 0) return history.time.front();
  return history.time[i - 1] +
         (history.time[i] - history.time[i - 1]) * (discharged - n[i - 1]) / (n[i] - n[i - 1]);
}

void measure_rate(const OutflowHistory& history, Outflow& outflow) {
  constexpr int intervals = 10;
  constexpr double fewest_particles = 50;
  constexpr auto fewest_rows = 20;
  const auto& t = history.time;
  const auto rows = std::upper_bound(t.begin(), t.end(), outflow.to) -
                    std::lower_bound(t.begin(), t.end(), outflow.from);
  const auto count = [&](double time) { return between(t, history.discharged, time); };
  const double through = count(outflow.to) - count(outflow.from);
  constexpr double shortest = 1e-9;  // s; less is no time to fall through
  if (rows < fewest_rows || through < fewest_particles || outflow.to - outflow.from < shortest)
    return;
  const double length = (outflow.to - outflow.from) / intervals;
  const double mean = through / (outflow.to - outflow.from);
  double squares = 0;
  for (int i = 0; i < intervals; ++i) {
    const double begin = outflow.from + i * length;
    const double deviation = (count(begin + length) - count(begin)) / length - mean;
    squares += deviation * deviation;
  }
  outflow.rate = mean;
  outflow.rate_error = std::sqrt(squares / (intervals * (intervals - 1)));
}

// Takes away what was counted after that time.
void cut_at(double time, OutflowHistory& history) {
  const auto kept = std::upper_bound(history.time.begin(), history.time.end(), time);
  const auto rows = static_cast<std::size_t>(kept - history.time.begin());
  for (auto* column : {&history.time, &history.inside, &history.discharged, &history.throat})
    column->resize(rows);
  if (rows == 0 || history.time.back() <= 0)
    throw DataError(
        history.file +
        ": no row between the opening of the orifice and its closing at close_after_s = " +
        number_text(time) + " s");
}

}  // namespace

OutflowHistory read_outflow(const std::string& discharge_csv) {
  const Table table = read_table(discharge_csv);
  require_line_end(discharge_csv);
  const auto& times = table.finite("since_opening_s");
  OutflowHistory history;
  history.file = discharge_csv;
  const struct {
    const char* name;
    std::vector<double>& to;
  } counts[] = {
      {"inside", history.inside}, {"discharged", history.discharged}, {"throat", history.throat}};
  constexpr double longest_time = 1e9, most_particles = 1e15;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!(std::fabs(times[i]) <= longest_time))
      table.refuse(i, "since_opening_s", "a time of -1e9 to 1e9 s");
    while (!history.time.empty() && history.time.back() >= times[i]) {
      history.time.pop_back();
      for (const auto& each : counts) each.to.pop_back();
    }
    history.time.push_back(times[i]);
    for (const auto& each : counts) {
      const double value = table.finite(each.name)[i];
      if (value < 0 || value > most_particles)
        table.refuse(i, each.name, "a number of particles of 0 to 1e15");
      each.to.push_back(value);
    }
  }
  if (history.time.empty() || history.time.back() <= 0)
    throw DataError(discharge_csv + ": no rows after the opening of the orifice");
  return history;
}

Outflow measure_outflow(OutflowHistory history, const OutflowOptions& options) {
  if (options.closed_at) cut_at(*options.closed_at, history);
  const auto opened =
      std::upper_bound(history.time.begin(), history.time.end(), 0.0) - history.time.begin();
  if (opened == 0) throw DataError(history.file + ": no row before the opening of the orifice");
  const double throat = history.throat[static_cast<std::size_t>(opened) - 1];
  Outflow outflow;
  outflow.discharged = history.discharged.back();
  outflow.inside = history.inside.back();
  if (outflow.discharged > 0) {
    outflow.last = std::max(0.0, time_of(history, outflow.discharged));
    outflow.from = std::max(0.0, time_of(history, options.from * outflow.discharged));
    outflow.to = time_of(history, options.to * outflow.discharged);
    measure_rate(history, outflow);
  }
  constexpr double arch_share = 0.25;
  if (history.throat.back() < arch_share * throat || history.throat.back() <= 0)
    outflow.end = OutflowEnd::drained;
  else if (history.time.back() - outflow.last >= options.stopped_after)
    outflow.end = OutflowEnd::clogged;
  else if (options.closed_at)
    outflow.end = OutflowEnd::closed;
  return outflow;
}

std::string describe(OutflowEnd end) {
  switch (end) {
    case OutflowEnd::clogged:
      return "clogged";
    case OutflowEnd::drained:
      return "drained";
    case OutflowEnd::closed:
      return "closed";
    default:
      return "flowing";
  }
}

}  // namespace rodpack
