// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/space/capsules.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/pairs/pair_configuration.h"
#include "figures/vtk_export.h"
#include "reading/angles.h"
#include "reading/checks/body_axes.h"

namespace rodpack {
namespace {

constexpr int corners_around = 16;  // of a ring
constexpr int rings_of_a_cap = 4;   // from its pole to where the tube begins

// A circle about a straight line in the plane of the centreline, in the body's frame, m; a point
// where its radius is 0.
struct SurfaceRing {
  double x, y;    // of its middle
  double turned;  // of its normal from the x axis towards -y, rad
  double radius;
};

struct Centreline {
  std::vector<std::array<double, 2>> points;
  std::vector<double> turned;  // of its direction at these points, as SurfaceRing
};

// One point for a sphere; of an arc points some 10 degrees apart.
Centreline centreline_of(int spheres, double half_length, double radius, double curvature) {
  if (spheres < 2 || half_length <= radius) return {{{{0, 0}}}, {0}};
  const auto shape =
      shape_of_body(spheres, half_length / radius, 2 * radius, 2 * radius, curvature);
  const int count = 2 + static_cast<int>(std::ceil(curvature / (10 * degree) - 1e-9));
  Centreline line{centreline_points(shape, count), {}};
  // How far the centre of mass lies above the middle of the centreline.
  const double sunk =
      sphere_centres(shape).front()[1] - centreline_points(shape, sphere_count(shape)).front()[1];
  for (int k = 0; k < count; ++k) {
    line.points[static_cast<std::size_t>(k)][1] += sunk;
    line.turned.push_back(curvature * (k / (count - 1.0) - 0.5));
  }
  return line;
}

// The rings lie from one pole to the other.
std::vector<SurfaceRing> rings_of(const Centreline& line, double radius) {
  std::vector<SurfaceRing> rings;
  const auto add_cap_ring = [&](std::size_t at, int step, double side) {
    const double angle = 90 * degree * step / rings_of_a_cap;
    const double out = step == rings_of_a_cap ? 0 : side * radius * std::cos(angle);
    rings.push_back({line.points[at][0] + out * std::cos(line.turned[at]),
                     line.points[at][1] - out * std::sin(line.turned[at]), line.turned[at],
                     radius * std::sin(angle)});
  };
  const std::size_t last = line.points.size() - 1;
  for (int step = 0; step <= rings_of_a_cap; ++step) add_cap_ring(0, step, -1);
  for (std::size_t k = 1; k <= last; ++k) add_cap_ring(k, rings_of_a_cap, 0);
  for (int step = rings_of_a_cap - 1; step >= 0; --step) add_cap_ring(last, step, 1);
  return rings;
}

// Collects the surfaces of all bodies.
class CapsuleMesh {
 public:
  /// `axes`: of the body; `centre`: of mass, m.
  void add(const std::vector<SurfaceRing>& rings, const std::array<Vector3, 3>& axes,
           const Vector3& centre, vtkIdType row) {
    vtkIdType earlier = -1;
    for (std::size_t k = 0; k < rings.size(); ++k) {
      const bool pole = k == 0 || k + 1 == rings.size();
      const auto first = add_ring(rings[k], pole ? 1 : corners_around, axes, centre);
      if (k > 0) join(earlier, k == 1, first, pole, row);
      earlier = first;
    }
  }
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  std::vector<vtkIdType> row_of_cell;

 private:
  vtkIdType add_ring(const SurfaceRing& ring, int corners, const std::array<Vector3, 3>& axes,
                     const Vector3& centre) {
    const vtkIdType first = points->GetNumberOfPoints();
    for (int k = 0; k < corners; ++k) {
      const double around = 2 * pi * k / corners_around;
      const double in_plane = corners > 1 ? ring.radius * std::cos(around) : 0;
      const double across = corners > 1 ? ring.radius * std::sin(around) : 0;
      const double x = ring.x + in_plane * std::sin(ring.turned);
      const double y = ring.y + in_plane * std::cos(ring.turned);
      double place[3];
      for (std::size_t c = 0; c < 3; ++c)
        place[c] = centre[c] + x * axes[0][c] + y * axes[1][c] + across * axes[2][c];
      points->InsertNextPoint(place);
    }
    return first;
  }
  // Cells between two rings, seen counter-clockwise from outside.
  void join(vtkIdType a, bool a_is_pole, vtkIdType b, bool b_is_pole, vtkIdType row) {
    for (int k = 0; k < corners_around; ++k) {
      const vtkIdType next = (k + 1) % corners_around;
      std::vector<vtkIdType> cell;
      if (a_is_pole)
        cell = {a, b + next, b + k};
      else if (b_is_pole)
        cell = {a + k, a + next, b};
      else
        cell = {a + k, a + next, b + next, b + k};
      cells->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
      row_of_cell.push_back(row);
    }
  }
};

}  // namespace

void write_capsules(const Frame& bodies, const std::string& file) {
  const auto place = vector_columns(bodies, {"x", "y", "z"});
  const auto& spheres = bodies.column("nspheres");
  const auto& half_length = bodies.column("half_length");
  const auto& radius = bodies.column("radius");
  const auto& curvature = bodies.column("curvature");
  const BodyAxes axes(bodies);
  CapsuleMesh mesh;
  mesh.points->SetDataTypeToDouble();
  for (std::size_t i = 0; i < bodies.rows; ++i) {
    try {
      const auto line =
          centreline_of(static_cast<int>(spheres[i]), half_length[i], radius[i], curvature[i]);
      mesh.add(rings_of(line, radius[i]), {axes.axis(i, 0), axes.axis(i, 1), axes.axis(i, 2)},
               {(*place[0])[i], (*place[1])[i], (*place[2])[i]}, static_cast<vtkIdType>(i));
    } catch (const std::invalid_argument& reason) {
      throw DataError(at_row(bodies, i) + reason.what());
    }
  }
  vtkNew<vtkPointData> of_bodies;
  add_frame_arrays(bodies, {"x", "y", "z"}, of_bodies);
  vtkNew<vtkPolyData> data;
  data->SetPoints(mesh.points);
  data->SetPolys(mesh.cells);
  auto* const of_cells = data->GetCellData();
  of_cells->CopyAllocate(of_bodies, static_cast<vtkIdType>(mesh.row_of_cell.size()));
  for (std::size_t cell = 0; cell < mesh.row_of_cell.size(); ++cell)
    of_cells->CopyData(of_bodies, mesh.row_of_cell[cell], static_cast<vtkIdType>(cell));
  write_poly_data(data, file);
}

}  // namespace rodpack
