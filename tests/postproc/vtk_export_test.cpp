// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/vtk_export.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include "liggghts_run.h"
#include "synthetic_packing.h"

namespace {
using namespace rodpack;
using rodpack::test::fresh_folder;
using rodpack::test::put;

vtkSmartPointer<vtkPolyData> read_back(const std::filesystem::path& file) {
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

class VtkExport : public testing::Test {
 protected:
  void SetUp() override {
    packing.width = packing.height = 0.06;
    packing.fill();
    folder = fresh_folder();
    packing.write_run(folder);
    const auto written = export_vtk(find_dumps({(folder / "dumps" / "*.dump").string()}),
                                    (folder / "vtk").string(), 1.1e-5);
    EXPECT_EQ(written.size(), 9U);  // three kinds, two frames and one index each
  }
  rodpack::test::SyntheticPacking packing;
  std::filesystem::path folder;
};

TEST_F(VtkExport, SpheresReadBackWithPositionsRadiiAndForces) {
  const auto data = read_back(folder / "vtk" / "spheres.2000.vtp");
  const Frame frame = last_frame({(folder / "dumps" / "spheres.2000.dump").string()});
  ASSERT_EQ(data->GetNumberOfPoints(), static_cast<vtkIdType>(packing.sphere_count));
  EXPECT_EQ(data->GetNumberOfVerts(), data->GetNumberOfPoints());
  auto* force = data->GetPointData()->GetArray("contact_force_N");
  auto* radius = data->GetPointData()->GetArray("radius_m");
  auto* body = data->GetPointData()->GetArray("body");
  ASSERT_TRUE(force && radius && body && data->GetPointData()->GetArray("fsum_N"));
  EXPECT_EQ(force->GetNumberOfComponents(), 3);
  EXPECT_FALSE(data->GetPointData()->HasArray("fx"));
  for (const vtkIdType i : {vtkIdType{0}, data->GetNumberOfPoints() - 1}) {
    const auto row = static_cast<std::size_t>(i);
    EXPECT_EQ(data->GetPoint(i)[0], frame.column("x")[row]);
    EXPECT_EQ(data->GetPoint(i)[1], frame.column("y")[row]);
    EXPECT_EQ(force->GetComponent(i, 1), frame.column("fy")[row]);
    EXPECT_EQ(radius->GetComponent(i, 0), frame.column("radius")[row]);
    EXPECT_EQ(body->GetComponent(i, 0), frame.column("body")[row]);
  }
}

TEST_F(VtkExport, BodiesCarryVelocityAngleAndShapeWithUnits) {
  const auto data = read_back(folder / "vtk" / "bodies.1000.vtp");
  EXPECT_EQ(data->GetNumberOfPoints(), static_cast<vtkIdType>(packing.body_count));
  for (const char* name :
       {"id", "type", "nspheres", "velocity_m_s", "angular_velocity_rad_s", "angle_rad",
        "half_length_m", "radius_m", "curvature_rad", "area_m2", "mass_kg"})
    EXPECT_TRUE(data->GetPointData()->HasArray(name)) << name;
}

TEST_F(VtkExport, ContactsAreLinesBetweenTheBranchEnds) {
  const auto data = read_back(folder / "vtk" / "contacts.2000.vtp");
  const Frame frame = last_frame({(folder / "dumps" / "contacts.2000.dump").string()});
  ASSERT_EQ(data->GetNumberOfLines(), static_cast<vtkIdType>(packing.contact_count));
  auto* force = data->GetCellData()->GetArray("contact_force_N");
  auto* point = data->GetCellData()->GetArray("contact_point_m");
  auto* normal = data->GetCellData()->GetArray("contact_normal");
  ASSERT_TRUE(force && point && normal && data->GetCellData()->GetArray("overlap_n_m"));
  const vtkIdType last = data->GetNumberOfLines() - 1;
  vtkCell* line = data->GetCell(last);
  EXPECT_EQ(line->GetPoints()->GetPoint(0)[0], frame.column("bix").back());
  EXPECT_EQ(line->GetPoints()->GetPoint(1)[1], frame.column("bjy").back());
  EXPECT_EQ(force->GetComponent(last, 0), frame.column("fx").back());
  EXPECT_EQ(point->GetComponent(last, 1), frame.column("y").back());
  EXPECT_EQ(normal->GetComponent(last, 1), frame.column("ny").back());
}

TEST_F(VtkExport, TimeIndexListsFramesInOrderOfTime) {
  std::ifstream in(folder / "vtk" / "bodies.pvd");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const auto first = text.find("timestep=\"0.011\" part=\"0\" file=\"bodies.1000.vtp\"");
  const auto second = text.find("timestep=\"0.022\" part=\"0\" file=\"bodies.2000.vtp\"");
  EXPECT_NE(first, std::string::npos);
  EXPECT_NE(second, std::string::npos);
  EXPECT_LT(first, second);
}

TEST(VtkExportErrors, UnknownDumpsAreRefused) {
  const auto file = put(fresh_folder() / "a.dump",
                        rodpack::test::frame_head(1, 1, 1, 1, "id x y z") + "1 0 0 0\n");
  try {
    export_vtk({file}, (fresh_folder() / "vtk").string(), 0);
    FAIL();
  } catch (const DataError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("a.dump:9: expected a dump of bodies"));
  }
}

}  // namespace
