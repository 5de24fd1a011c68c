// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_GRID_H
#define RODPACK_PLANAR_GRID_H

#include <vector>

namespace rodpack {

/// Cell grid with a linked list of the bodies in each cell. Bodies beyond its edge go into the
/// cells of the edge, which keeps neighbours neighbours. Cells without bodies stand around it.
class PlanarGrid {
 public:
  /// Places bodies at (x, y), m, in cells that are at least `cell` wide, m.
  void build(const std::vector<double>& x, const std::vector<double>& y, double cell);
  /// Follows a body that has moved to (x, y).
  void move(int body, double x, double y);
  /// Adds a body that was not in the grid; its index may be higher than those of build().
  void add(int body, double x, double y);
  void remove(int body);
  /// The number of cells, those around the grid too, and that of the cells of a row.
  int cells() const { return stride() * (ny_ + 2); }
  int stride() const { return nx_ + 2; }
  /// The cell of a body: its row times the stride, plus its column.
  int cell(int body) const { return cell_[body]; }
  /// Whether a line across an axis (0: x, 1: y) at `position`, m, may be less than half a cell away
  /// from a body of a column (of a row). The outermost ones have what is beyond the grid too.
  bool reaches(int axis, int column, double position) const;
  /// Calls visit(other) for all bodies that are no farther than `reach` from (x, y) along x and
  /// along y, m, and for others near by.
  template <class Visit>
  void around(double x, double y, double reach, Visit visit) const {
    const int first = column(x - reach), last = column(x + reach), top = row(y + reach);
    for (int line = row(y - reach); line <= top; ++line)
      for (int cell = line * stride() + first; cell <= line * stride() + last; ++cell)
        for (int body = head_[cell]; body >= 0; body = next_[body]) visit(body);
  }

 private:
  static int clamped(double cell, int count) {
    return cell > 0.0 ? (cell < count ? static_cast<int>(cell) : count - 1) : 0;
  }
  int column(double x) const { return 1 + clamped((x - x0_) * inverse_, nx_); }
  int row(double y) const { return 1 + clamped((y - y0_) * inverse_, ny_); }
  int cell_of(double x, double y) const { return row(y) * stride() + column(x); }
  void link(int body, int cell);

  double x0_ = 0.0, y0_ = 0.0, inverse_ = 1.0;  // corner (m), 1 / width of a cell (1/m)
  int nx_ = 1, ny_ = 1;
  std::vector<int> head_;                    // the first body of each cell, -1: none
  std::vector<int> next_, previous_, cell_;  // of each body
};

}  // namespace rodpack

#endif
