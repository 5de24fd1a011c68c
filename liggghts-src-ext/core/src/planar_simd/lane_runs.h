// SPDX-License-Identifier: GPL-2.0-or-later
// Where the blocks of Lanes lie: in lane_runs registers, each of which takes a run of neighbours.
// Included by the headers of lanes after lane_blocks and lane_runs.

constexpr int run_blocks = lane_blocks / lane_runs;  // blocks of a run, which are neighbours
constexpr int run_lanes = run_blocks * planar_lanes, all_of_run = (1 << run_lanes) - 1;

/// The first block of each run.
struct LanePlaces {
  unsigned first[lane_runs];
  explicit LanePlaces(const int* of_runs) {
    for (int r = 0; r < lane_runs; ++r) first[r] = of_runs[r];
  }
  int block(int b) const { return static_cast<int>(first[b / run_blocks]) + b % run_blocks; }
  /// Where run r begins in its group.
  int in_group(int r) const { return run_blocks == planar_group ? 0 : first[r] % planar_group; }
};

/// Values of the blocks of each run, or those of a row.
struct LaneValues {
  double* of[lane_runs];
  LaneValues operator+(int offset) const {
    LaneValues values = *this;
    for (double*& first : values.of) first += offset;
    return values;
  }
  double* block(int b) const { return of[b / run_blocks] + b % run_blocks * planar_lanes; }
};
