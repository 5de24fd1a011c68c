// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CAMPAIGNS_LAUNCH_STEP_TIMING_H
#define RODPACK_CAMPAIGNS_LAUNCH_STEP_TIMING_H

#include <functional>
#include <string>
#include <vector>

namespace rodpack {

/// Reads the wall-clock time per step, s, of the last run command that `output` of LIGGGHTS tells
/// of ("Loop time of ... for ... steps"). @throws DataError when there is none, or of no steps.
double time_per_step(const std::string& output);

/// Binds this process, and the programs that it starts, to the last `count` processors it may use,
/// as `taskset` does, until the end of its life.
class ProcessorPin {
 public:
  /// @throws DataError when there are not so many processors.
  explicit ProcessorPin(int count);
  ~ProcessorPin();
  ProcessorPin(const ProcessorPin&) = delete;
  ProcessorPin& operator=(const ProcessorPin&) = delete;
  /// Returns the numbers of the processors that this process is bound to, as in "0,1".
  const std::string& processors() const { return processors_; }

 private:
  std::vector<int> before_;
  std::string processors_;
};

/// Calls `measure`(contestant, round) once per round for each of `contestants`, in turns: the order
/// is reversed every other round, so that a slow change of the machine's speed meets all alike.
/// Returns the measured values, [contestant][round].
std::vector<std::vector<double>> measure_in_turns(int contestants, int rounds,
                                                  const std::function<double(int, int)>& measure);

/// Returns the median; of an even number of values the mean of the middle two. @throws DataError if
/// empty.
double median(std::vector<double> values);

}  // namespace rodpack

#endif
