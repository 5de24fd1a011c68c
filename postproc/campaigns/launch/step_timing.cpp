// SPDX-License-Identifier: GPL-2.0-or-later
#include "campaigns/launch/step_timing.h"

#include <sched.h>

#include <algorithm>
#include <cstdio>

#include "reading/data_error.h"

namespace rodpack {
namespace {

void bind_to(const std::vector<int>& processors) {
  cpu_set_t set;
  CPU_ZERO(&set);
  for (const int each : processors) CPU_SET(static_cast<std::size_t>(each), &set);
  sched_setaffinity(0, sizeof set, &set);
}

}  // namespace

double time_per_step(const std::string& output) {
  const auto at = output.rfind("Loop time of ");
  double seconds = 0;
  int ranks = 0;
  long steps = 0;
  if (at == std::string::npos ||
      std::sscanf(output.c_str() + at, "Loop time of %lf on %d procs for %ld steps", &seconds,
                  &ranks, &steps) != 3 ||
      steps <= 0)
    throw DataError("LIGGGHTS's output: expected a line 'Loop time of ... for ... steps'");
  return seconds / static_cast<double>(steps);
}

ProcessorPin::ProcessorPin(int count) {
  cpu_set_t set;
  CPU_ZERO(&set);
  sched_getaffinity(0, sizeof set, &set);
  for (int each = 0; each < CPU_SETSIZE; ++each)
    if (CPU_ISSET(static_cast<std::size_t>(each), &set)) before_.push_back(each);
  if (count > static_cast<int>(before_.size()))
    throw DataError("timing: expected a processor for each of " + std::to_string(count) +
                    " ranks, found " + std::to_string(before_.size()));
  const std::vector<int> chosen(before_.end() - count, before_.end());
  for (const int each : chosen)
    processors_ += (processors_.empty() ? "" : ",") + std::to_string(each);
  bind_to(chosen);
}

ProcessorPin::~ProcessorPin() { bind_to(before_); }

std::vector<std::vector<double>> measure_in_turns(int contestants, int rounds,
                                                  const std::function<double(int, int)>& measure) {
  std::vector<std::vector<double>> values(static_cast<std::size_t>(contestants));
  for (int round = 0; round < rounds; ++round)
    for (int turn = 0; turn < contestants; ++turn) {
      const int who = round % 2 == 0 ? turn : contestants - 1 - turn;
      values[static_cast<std::size_t>(who)].push_back(measure(who, round));
    }
  return values;
}

double median(std::vector<double> values) {
  if (values.empty()) throw DataError("median: expected at least one value, found none");
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

}  // namespace rodpack
