// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_FRAMES_H
#define RODPACK_PLANAR_FRAMES_H

#include <vector>

#include "../planar/pipeline.h"
#include "rodpack/planar/scene.h"

namespace rodpack {

class PlanarBodyStates;
class PlanarGrid;

/// How a frame moves in a step, m.
struct PlanarFrameStep {
  double x = 0.0, y = 0.0;
  /// Half of what the frames next to it move relative to it at most, so that two bodies share it.
  double strain = 0.0;
};

/// Frames that move with the bodies, one for each cell of the grid. A bed that is hit bounces as a
/// whole, and particles that fall fall together: they move little relative to the frame of their
/// cell, a good deal less than they do in space, and skins have to cover that alone. Any motion of
/// the frames is right as long as its strain is counted as motion of the bodies; it is chosen to be
/// that of the bodies around.
class PlanarFrames {
 public:
  explicit PlanarFrames(const PlanarSettings& settings)
      : settings_(settings), way_(settings.max_skin) {}

  /// Sets how far a frame may go along an axis until it is renewed, m.
  void set_way(double way) { way_ = way; }
  double way() const { return way_; }
  /// Lets the frames move as the bodies of their cells and of those next to them do on average:
  /// where some are slow, as these do.
  void renew(const PlanarGrid& grid, const PlanarBodyStates& bodies);
  /// The number of steps, 4 or more, in which no frame goes farther than it may.
  int steps_within_way() const { return steps_within_way_; }
  /// Whether there is a frame that moves.
  bool any_moves() const { return any_moves_; }
  PlanarFrameStep step(int cell) const {
    if (!any_moves_) return PlanarFrameStep();
    return {step_x_[cell], step_y_[cell], strain_[cell]};
  }

 private:
  /// Sums over bodies of each cell: velocities, m/s, and how many there are.
  struct Sums {
    std::vector<double> x, y, count;
    void clear(int cells);
    void smooth(int stride, std::vector<double>& work);
  };
  void sum_up(const PlanarGrid& grid, const PlanarBodyStates& bodies);
  void set_steps(int cells);
  void stop_at_walls(const PlanarGrid& grid);
  void copy_to_edge(int cells, int stride);
  void set_strains(int cells, int stride);

  const PlanarSettings& settings_;
  bool any_moves_ = false;
  double way_;
  int steps_within_way_ = most_steps_in_pass;
  Sums slow_, fast_;
  std::vector<double> step_x_, step_y_, strain_;
  std::vector<double> work_;
};

}  // namespace rodpack

#endif
