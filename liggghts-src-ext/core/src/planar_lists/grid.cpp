// SPDX-License-Identifier: GPL-2.0-or-later
#include "grid.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rodpack {

namespace {

struct Interval {
  double low = 0.0, high = 0.0;
  explicit Interval(const std::vector<double>& values) {
    if (values.empty()) return;
    const auto ends = std::minmax_element(values.begin(), values.end());
    low = *ends.first;
    high = *ends.second;
  }
  double length() const { return high - low; }
};

}  // namespace

void PlanarGrid::build(const std::vector<double>& x, const std::vector<double>& y, double cell) {
  const std::size_t count = x.size();
  const Interval along_x(x), along_y(y);
  // Not more cells than a few per body, however far one has flown.
  const double most = 4.0 * static_cast<double>(count) + 16.0;
  while ((std::floor(along_x.length() / cell) + 1.0) * (std::floor(along_y.length() / cell) + 1.0) >
         most)
    cell *= 1.5;
  x0_ = along_x.low;
  y0_ = along_y.low;
  inverse_ = 1.0 / cell;
  nx_ = static_cast<int>(along_x.length() * inverse_) + 1;
  ny_ = static_cast<int>(along_y.length() * inverse_) + 1;
  head_.assign(cells(), -1);
  for (std::vector<int>* of_bodies : {&next_, &previous_, &cell_}) of_bodies->assign(count, -1);
  for (std::size_t k = 0; k < count; ++k) link(static_cast<int>(k), cell_of(x[k], y[k]));
}

bool PlanarGrid::reaches(int axis, int column, double position) const {
  const int last = axis == 0 ? nx_ : ny_;
  const double along = (position - (axis == 0 ? x0_ : y0_)) * inverse_ + 1.0;
  return (column <= 1 || along > column - 0.5) && (column >= last || along < column + 1.5);
}

void PlanarGrid::link(int body, int cell) {
  cell_[body] = cell;
  previous_[body] = -1;
  next_[body] = head_[cell];
  if (head_[cell] >= 0) previous_[head_[cell]] = body;
  head_[cell] = body;
}

void PlanarGrid::move(int body, double x, double y) {
  const int cell = cell_of(x, y);
  if (cell == cell_[body]) return;
  remove(body);
  link(body, cell);
}

void PlanarGrid::add(int body, double x, double y) {
  if (body >= static_cast<int>(cell_.size()))
    for (std::vector<int>* of_bodies : {&next_, &previous_, &cell_})
      of_bodies->resize(body + 1, -1);
  link(body, cell_of(x, y));
}

void PlanarGrid::remove(int body) {
  if (previous_[body] >= 0)
    next_[previous_[body]] = next_[body];
  else
    head_[cell_[body]] = next_[body];
  if (next_[body] >= 0) previous_[next_[body]] = previous_[body];
}

}  // namespace rodpack
