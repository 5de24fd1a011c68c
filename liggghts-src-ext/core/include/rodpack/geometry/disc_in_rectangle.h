// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_GEOMETRY_DISC_IN_RECTANGLE_H
#define RODPACK_GEOMETRY_DISC_IN_RECTANGLE_H

namespace rodpack {

/// Returns the area of the part of a disc (radius r, centre at the origin) with 0 <= x <= a and
/// 0 <= y <= b; lengths in one unit, a and b may be infinite, the area in its square.
double quarter_disc_area(double r, double a, double b);

/// Sides of a rectangle; infinite where there is none.
struct Rectangle {
  double left, right, bottom, top;
  bool contains(double x, double y) const {
    return x >= left && x <= right && y >= bottom && y <= top;
  }
  double area() const { return (right - left) * (top - bottom); }
};

/// Returns the area of the part of a disc of radius r around (x, y) that lies in the rectangle; the
/// centre may be outside.
double disc_area_inside(const Rectangle& box, double x, double y, double r);

}  // namespace rodpack

#endif
