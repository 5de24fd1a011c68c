// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/order/bond_order.h"

#include <vtkCellArray.h>
#include <vtkDelaunay2D.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/edges/undisturbed.h"
#include "analysis/order/body_points.h"

namespace rodpack {
namespace {

using Triangle = std::array<std::size_t, 3>;

std::vector<Triangle> delaunay_triangles(const std::vector<double>& x,
                                         const std::vector<double>& y) {
  if (x.size() < 3) return {};
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (std::size_t i = 0; i < x.size(); ++i) points->InsertNextPoint(x[i], y[i], 0);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  vtkNew<vtkDelaunay2D> delaunay;
  delaunay->SetInputData(data);
  delaunay->SetTolerance(1e-9);
  delaunay->Update();
  std::vector<Triangle> triangles;
  vtkCellArray* const cells = delaunay->GetOutput()->GetPolys();
  vtkNew<vtkIdList> corners;
  for (cells->InitTraversal(); cells->GetNextCell(corners) != 0;) {
    Triangle triangle{};
    for (std::size_t k = 0; k < 3; ++k)
      triangle[k] = static_cast<std::size_t>(corners->GetId(static_cast<vtkIdType>(k)));
    auto& [a, b, c] = triangle;
    const double area = (x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a]);
    if (area < 0) std::swap(b, c);  // all counter-clockwise
    if (area != 0) triangles.push_back(triangle);
  }
  return triangles;
}

}  // namespace

std::vector<std::complex<double>> sixfold_bond_orders(const std::vector<double>& x,
                                                      const std::vector<double>& y) {
  std::vector<std::complex<double>> sum(x.size());
  std::vector<double> sides(x.size());
  // Around a point whose cell is closed each neighbour is the next corner of one triangle and the
  // last of another, so that its name cancels.
  std::vector<std::ptrdiff_t> open(x.size());
  for (const auto& corner : delaunay_triangles(x, y))
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = corner[k], b = corner[(k + 1) % 3], c = corner[(k + 2) % 3];
      // This triangle's part of the side that the Voronoi cells of a and b share: |ab| / 2 times
      // the cotangent of the angle at c.
      const double ax = x[a] - x[c], ay = y[a] - y[c], bx = x[b] - x[c], by = y[b] - y[c];
      const double area = ax * by - ay * bx;
      const double dx = x[b] - x[a], dy = y[b] - y[a];
      const double part = 0.5 * std::hypot(dx, dy) * (ax * bx + ay * by) / area;
      const auto direction = std::polar(part, 6 * std::atan2(dy, dx));
      for (const auto end : {a, b}) {  // the opposite direction has the same sixth power
        sum[end] += direction;
        sides[end] += part;
      }
      open[a] += static_cast<std::ptrdiff_t>(b);
      open[b] -= static_cast<std::ptrdiff_t>(a);
    }
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < x.size(); ++i)
    sum[i] = open[i] == 0 && sides[i] > 0 ? sum[i] / sides[i] : std::complex<double>(none, none);
  return sum;
}

void BondOrderSample::add(const Frame& bodies, const Packing& packing) {
  const auto chains = body_points(bodies, packing, [](const ChainShape& shape) {
    const int count = std::max(1, static_cast<int>(std::lround(shape.aspect_ratio)));
    auto points = centreline_points(shape, count);
    // From the middle of the centreline to the centre of mass, that of these points.
    double y = 0;
    for (const auto& point : points) y += point[1] / count;
    for (auto& point : points) point[1] -= y;
    return points;
  });
  const auto inner = undisturbed_part(packing, packing.axial_length());
  const auto& walls = packing.walls;
  // Across a periodic side the images of half the bed are neighbours of the others.
  const auto image = [](double at, double low, double high) {
    return at < (low + high) / 2 ? at + (high - low) : at - (high - low);
  };
  std::vector<double> x, y;
  std::vector<bool> counted;
  const auto add_point = [&](double at_x, double at_y, bool counts) {
    x.push_back(at_x);
    y.push_back(at_y);
    counted.push_back(counts);
  };
  for (std::size_t i = 0; i < packing.size(); ++i)
    for (const auto& [dx, dy] : chains[i]) {
      const double at_x = packing.x[i] + dx, at_y = packing.y[i] + dy;
      const bool inside = inner.contains(at_x, at_y);
      near_edges_ += inside ? 0 : 1;
      add_point(at_x, at_y, inside);
      const double image_x = image(at_x, walls.left, walls.right);
      const double image_y = image(at_y, walls.floor, walls.ceiling);
      if (!walls.sides) add_point(image_x, at_y, false);
      if (!walls.bottom) add_point(at_x, image_y, false);
      if (!walls.sides && !walls.bottom) add_point(image_x, image_y, false);
    }
  const auto orders = sixfold_bond_orders(x, y);
  for (std::size_t i = 0; i < orders.size(); ++i) {
    if (!counted[i] || !std::isfinite(orders[i].real())) continue;
    const double modulus = std::abs(orders[i]);
    sum_ += orders[i];
    sum_of_moduli_ += modulus;
    sum_of_squares_ += modulus * modulus;
    ++points_;
  }
}

BondOrder BondOrderSample::result() const {
  if (points_ == 0)
    throw TooFewParticles("sixfold order: no point further than AR d_p from walls and surface, " +
                          std::to_string(near_edges_) + " are closer");
  const double n = static_cast<double>(points_);
  BondOrder order;
  order.local = sum_of_moduli_ / n;
  order.local_error = std::sqrt(std::max(0.0, sum_of_squares_ / n - order.local * order.local) / n);
  order.global = std::abs(sum_) / n;
  order.points = points_;
  order.near_edges = near_edges_;
  return order;
}

}  // namespace rodpack
