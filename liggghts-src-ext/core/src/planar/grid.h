// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_GRID_H
#define RODPACK_PLANAR_GRID_H

#include <vector>

namespace rodpack {

/// Cell grid with a linked list of the bodies in each cell. Bodies beyond its edge go into the
/// cells of the edge, which keeps neighbours neighbours.
class PlanarGrid {
 public:
  /// Places bodies at (x, y), m, in cells that are at least `cell` wide, m.
  void build(const std::vector<double>& x, const std::vector<double>& y, double cell);
  /// Follows a body that has moved to (x, y).
  void move(int body, double x, double y);
  /// Adds a body that was not in the grid; its index may be higher than those of build().
  void add(int body, double x, double y);
  void remove(int body);
  /// Calls visit(other) for all bodies of the cell of (x, y) and of the eight around it.
  template <class Visit>
  void around(double x, double y, Visit visit) const {
    const int cx = column(x), cy = row(y);
    for (int iy = cy > 0 ? cy - 1 : 0; iy <= cy + 1 && iy < ny_; ++iy)
      for (int ix = cx > 0 ? cx - 1 : 0; ix <= cx + 1 && ix < nx_; ++ix)
        for (int body = head_[iy * nx_ + ix]; body >= 0; body = next_[body]) visit(body);
  }

 private:
  static int clamped(double cell, int count) {
    return cell > 0.0 ? (cell < count ? static_cast<int>(cell) : count - 1) : 0;
  }
  int column(double x) const { return clamped((x - x0_) * inverse_, nx_); }
  int row(double y) const { return clamped((y - y0_) * inverse_, ny_); }
  int cell_of(double x, double y) const { return row(y) * nx_ + column(x); }
  void link(int body, int cell);

  double x0_ = 0.0, y0_ = 0.0, inverse_ = 1.0;  // corner (m), 1 / width of a cell (1/m)
  int nx_ = 1, ny_ = 1;
  std::vector<int> head_;                    // the first body of each cell, -1: none
  std::vector<int> next_, previous_, cell_;  // of each body
};

}  // namespace rodpack

#endif
