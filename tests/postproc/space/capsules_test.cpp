// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/space/capsules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <cmath>
#include <map>

#include "analysis/pairs/pair_configuration.h"
#include "liggghts_run.h"
#include "reading/angles.h"
#include "spatial_scene.h"
#include "../synthetic_packing.h"

namespace {
using namespace rodpack;
using rodpack::test::fresh_folder;
using rodpack::test::put;
using testing::HasSubstr;

vtkSmartPointer<vtkPolyData> written(const Frame& bodies) {
  const auto file = (fresh_folder() / "capsules.vtp").string();
  write_capsules(bodies, file);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

// Six times the volume that the cells enclose: positive where they are seen counter-clockwise from
// outside. Every edge has to be walked once in each direction.
double closed_volume(vtkPolyData* data, vtkIdType first_cell, vtkIdType end_cell) {
  std::map<std::pair<vtkIdType, vtkIdType>, int> edges;
  double volume = 0;
  for (vtkIdType cell = first_cell; cell < end_cell; ++cell) {
    vtkNew<vtkIdList> corners;
    data->GetCellPoints(cell, corners);
    const auto number = corners->GetNumberOfIds();
    for (vtkIdType k = 0; k < number; ++k)
      ++edges[{corners->GetId(k), corners->GetId((k + 1) % number)}];
    double a[3], b[3], c[3];
    data->GetPoint(corners->GetId(0), a);
    for (vtkIdType k = 1; k + 1 < number; ++k) {
      data->GetPoint(corners->GetId(k), b);
      data->GetPoint(corners->GetId(k + 1), c);
      volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                 a[2] * (b[0] * c[1] - b[1] * c[0])) /
                6;
    }
  }
  for (const auto& [edge, times] : edges) {
    EXPECT_EQ(times, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1U);
  }
  return volume;
}

Frame frame_of_text(const std::string& text) {
  return last_frame({put(fresh_folder() / "b.dump", text)});
}

// Rods of AR = 5, d_p = 2 mm: every corner is 1 mm from the line between their end centres, which
// are 4 mm from the middle; the surface is closed, and the sixteen-sided body that it bounds has
// some 96 % of the volume, 4 pi r^3 / 3 + 8 pi r^3.
TEST(Capsules, AreClosedAndLieOnTheRodsOfEveryDirection) {
  const auto axes = rodpack::test::watson_axes(0, 5, 3);
  const auto places = rodpack::test::random_places({0.1, 0.1, 0.1}, 5, 4);
  const auto data =
      written(frame_of_text(rodpack::test::spatial_bodies(places, axes, {0.1, 0.1, 0.1})));
  const vtkIdType points = data->GetNumberOfPoints() / 5, cells = data->GetNumberOfCells() / 5;
  for (vtkIdType body = 0; body < 5; ++body) {
    const auto& u = axes[static_cast<std::size_t>(body)];
    const auto& centre = places[static_cast<std::size_t>(body)];
    for (vtkIdType k = 0; k < points; ++k) {
      double off[3], along = 0, square = 0;
      data->GetPoint(body * points + k, off);
      for (std::size_t c = 0; c < 3; ++c) {
        off[c] -= centre[c];
        along += off[c] * u[c];
        square += off[c] * off[c];
      }
      const double beyond = std::max(0.0, std::abs(along) - 4e-3);
      EXPECT_NEAR(std::sqrt(square - along * along + beyond * beyond), 1e-3, 1e-9);
    }
    const double exact = (4.0 / 3 + 8) * pi * 1e-9;
    const double volume = closed_volume(data, body * cells, (body + 1) * cells);
    EXPECT_LT(volume, exact);
    EXPECT_GT(volume, 0.95 * exact);
    EXPECT_EQ(data->GetCellData()->GetArray("id")->GetComponent(body * cells, 0), body + 1.0);
  }
  EXPECT_TRUE(data->GetCellData()->HasArray("velocity_m_s"));
}

Frame one_body(const std::string& spheres, const std::string& half_length,
               const std::string& curvature) {
  return frame_of_text(
      "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff ff\n-1 1\n-1 1\n-1 "
      "1\nITEM: ATOMS id nspheres x y z qw qx qy qz half_length radius curvature\n1 " +
      spheres + " 0 0 0 1 0 0 0 " + half_length + " 0.1 " + curvature + "\n");
}

// A bent chain of nine spheres, 100 degrees: the circle through its spheres, seen from the centre
// of mass, is the centreline of the surface.
TEST(Capsules, BendWithTheChain) {
  const double theta = 100 * degree;
  const auto data = written(one_body("9", "0.5", std::to_string(theta)));
  const auto shape = shape_of_body(9, 5, 0.2, 0.2, theta);
  const double radius = 0.8 / theta;  // of the arc: end centres 0.8 apart along it
  const double middle_y = sphere_centres(shape)[4][1] - radius;
  for (vtkIdType k = 0; k < data->GetNumberOfPoints(); ++k) {
    double p[3];
    data->GetPoint(k, p);
    const double angle = std::clamp(std::atan2(p[0], p[1] - middle_y), -theta / 2, theta / 2);
    const double x = radius * std::sin(angle), y = middle_y + radius * std::cos(angle);
    EXPECT_NEAR(std::hypot(p[0] - x, p[1] - y, p[2]), 0.1, 1e-6);
  }
  EXPECT_GT(closed_volume(data, 0, data->GetNumberOfCells()),
            0.93 * (4.0 / 3 * 1e-3 + 0.8 * 1e-2) * pi);
}

TEST(Capsules, OfASphereIsABall) {
  const auto data = written(one_body("1", "0.1", "0"));
  for (vtkIdType k = 0; k < data->GetNumberOfPoints(); ++k) {
    double p[3];
    data->GetPoint(k, p);
    EXPECT_NEAR(std::hypot(p[0], p[1], p[2]), 0.1, 1e-12);
  }
  EXPECT_GT(closed_volume(data, 0, data->GetNumberOfCells()), 0.9 * 4.0 / 3 * pi * 1e-3);
}

TEST(Capsules, AreExportedOnRequest) {
  const auto folder = fresh_folder();
  put(folder / "bodies.7.dump",
      rodpack::test::spatial_bodies({{0.05, 0.05, 0.05}}, {{0, 0, 1}}, {0.1, 0.1, 0.1}));
  const auto run = rodpack::test::run_rodpack("export bodies.7.dump --capsules", folder);
  ASSERT_EQ(run.exit_code, 0) << run.output;
  for (const std::string name : {"bodies.7.vtp", "capsules.7.vtp", "bodies.pvd", "capsules.pvd"})
    EXPECT_TRUE(std::filesystem::exists(folder / "vtk" / name)) << name;
  put(folder / "spheres.7.dump",
      "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\n"
      "ITEM: ATOMS id body x y z radius\n1 1 0.5 0.5 0.5 0.1\n");
  const auto refused =
      rodpack::test::run_rodpack("export spheres.7.dump --capsules -o other", folder);
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.output, HasSubstr("--capsules: expected a dump of bodies, found none\n"));
  EXPECT_FALSE(std::filesystem::exists(folder / "other"));
}

}  // namespace
