// SPDX-License-Identifier: GPL-2.0-or-later
#include "frames.h"

#include <algorithm>
#include <cmath>

#include "../planar/bodies.h"
#include "grid.h"

namespace rodpack {

namespace {

/// Weights the numbers of neighbouring cells, so many places apart, 1 : 2 : 1.
void weigh(const std::vector<double>& from, int stride, std::vector<double>& to) {
  const int end = static_cast<int>(from.size()) - stride;
  for (int cell = stride; cell < end; ++cell)
    to[cell] = 2.0 * from[cell] + from[cell - stride] + from[cell + stride];
}

}  // namespace

void PlanarFrames::renew(const PlanarGrid& grid, const PlanarBodyStates& bodies) {
  sum_up(grid, bodies);
  // A bed at rest has the least skins anyway.
  steps_within_way_ = most_steps_in_pass;
  if (!any_moves_) return;
  for (Sums* sums : {&slow_, &fast_}) sums->smooth(grid.stride(), work_);
  set_steps(grid.cells());
  stop_at_walls(grid);
  copy_to_edge(grid.cells(), grid.stride());
  set_strains(grid.cells(), grid.stride());
}

void PlanarFrames::Sums::clear(int cells) {
  for (std::vector<double>* sums : {&x, &y, &count}) sums->assign(cells, 0.0);
}

void PlanarFrames::Sums::smooth(int stride, std::vector<double>& work) {
  work.resize(count.size());
  for (std::vector<double>* sums : {&x, &y, &count}) {
    weigh(*sums, 1, work);
    weigh(work, stride, *sums);
  }
}

/// Slow is what the largest skin covers for as many steps as it should.
void PlanarFrames::sum_up(const PlanarGrid& grid, const PlanarBodyStates& bodies) {
  const double slow = settings_.max_skin / (settings_.skin_steps * settings_.dt);
  const double at_rest = 0.2 * settings_.min_skin / (settings_.skin_steps * settings_.dt);
  for (Sums* sums : {&slow_, &fast_}) sums->clear(grid.cells());
  any_moves_ = false;
  for (int body = 0; body < bodies.owned(); ++body) {
    const double* const v = bodies.kinematics(body).velocity;
    const double square = v[0] * v[0] + v[1] * v[1];
    Sums& sums = square < slow * slow ? slow_ : fast_;
    const int cell = grid.cell(body);
    sums.x[cell] += v[0];
    sums.y[cell] += v[1];
    sums.count[cell] += 1.0;
    any_moves_ = any_moves_ || square > at_rest * at_rest;
  }
}

void PlanarFrames::set_steps(int cells) {
  const double dt = settings_.dt, largest = 0.25 * way_;
  double longest = way_ / most_steps_in_pass;  // step of a frame, m, but for shorter ones
  step_x_.resize(cells);
  step_y_.resize(cells);
  const auto step = [&](double slow, double slow_count, double fast, double fast_count) {
    const double sum = slow_count > 0.0 ? slow : fast;
    const double count = slow_count > 0.0 ? slow_count : std::max(fast_count, 1.0);
    return std::min(largest, std::max(-largest, dt * sum / count));
  };
  for (int cell = 0; cell < cells; ++cell) {
    const double slow = slow_.count[cell], fast = fast_.count[cell];
    step_x_[cell] = step(slow_.x[cell], slow, fast_.x[cell], fast);
    step_y_[cell] = step(slow_.y[cell], slow, fast_.y[cell], fast);
    longest = std::max(longest, std::max(std::fabs(step_x_[cell]), std::fabs(step_y_[cell])));
  }
  steps_within_way_ = static_cast<int>(1.000001 * way_ / longest);  // whole numbers to rounding
}

/// Lists of contacts with walls hold still in space: no frame from which a body could reach a wall
/// moves towards it or away.
void PlanarFrames::stop_at_walls(const PlanarGrid& grid) {
  const int stride = grid.stride(), rows = grid.cells() / stride;
  for (const PlanarWall& wall : settings_.walls) {
    if (wall.axis == 0) {
      for (int column = 0; column < stride; ++column)
        if (grid.reaches(0, column, wall.position))
          for (int row = 0; row < rows; ++row) step_x_[row * stride + column] = 0.0;
    } else {
      for (int row = 0; row < rows; ++row)
        if (grid.reaches(1, row, wall.position))
          std::fill_n(step_y_.begin() + row * stride, stride, 0.0);
    }
  }
}

/// Lets the cells around the grid, which have no bodies, move as those next to them.
void PlanarFrames::copy_to_edge(int cells, int stride) {
  const int last_row = cells - stride;
  for (std::vector<double>* step : {&step_x_, &step_y_}) {
    const auto first = step->begin();
    for (int row = 0; row < cells; row += stride) {
      first[row] = first[row + 1];
      first[row + stride - 1] = first[row + stride - 2];
    }
    std::copy_n(first + stride, stride, first);
    std::copy_n(first + last_row - stride, stride, first + last_row);
  }
}

void PlanarFrames::set_strains(int cells, int stride) {
  strain_.assign(cells, 0.0);
  // Squares of twice the strains first.
  for (const int away : {1, stride - 1, stride, stride + 1})
    for (const int other : {-away, away})
      for (int cell = stride + 1; cell < cells - stride - 1; ++cell) {
        const double dx = step_x_[cell] - step_x_[cell + other],
                     dy = step_y_[cell] - step_y_[cell + other];
        strain_[cell] = std::max(strain_[cell], dx * dx + dy * dy);
      }
  for (double& strain : strain_) strain = 0.5 * std::sqrt(strain);
}

}  // namespace rodpack
