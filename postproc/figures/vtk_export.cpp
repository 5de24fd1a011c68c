// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/vtk_export.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt64Array.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

#include "analysis/stock/stock_dumps.h"
#include "figures/space/capsules.h"
#include "reading/checks/frame_pool.h"
#include "reading/number_text.h"
#include "reading/text_file.h"
#include "rodpack/dumps/columns.h"

namespace rodpack {
namespace {

struct VectorArray {
  const char* name;
  std::array<const char*, 3> columns;
};
constexpr VectorArray vectors[] = {
    {"velocity_m_s", {"vx", "vy", "vz"}},
    {"angular_velocity_rad_s", {"omegax", "omegay", "omegaz"}},
    {"contact_force_N", {"fx", "fy", "fz"}},
    {"contact_normal", {"nx", "ny", "nz"}},
};

// The column of this name in our dumps, which has a unit or holds integers; null if it is none.
const DumpColumn* known_column(const std::string& name) {
  static const auto known = [] {
    std::map<std::string, DumpColumn> table;
    const auto add = [&](const auto& columns) {
      for (const DumpColumn& column : columns)
        if (column.is_integer || *column.unit) table.emplace(column.name, column);
    };
    add(body_dump::columns);
    add(sphere_dump::columns);
    add(contact_dump::columns);
    return table;
  }();
  const auto found = known.find(name);
  return found == known.end() ? nullptr : &found->second;
}

// "radius_m", "vx_m_s"; the name itself where there is no unit.
std::string name_with_unit(const DumpColumn& column) {
  std::string unit = column.unit;
  std::replace(unit.begin(), unit.end(), '/', '_');
  return unit.empty() ? column.name : column.name + ("_" + unit);
}

vtkSmartPointer<vtkDataArray> scalar_array(const Frame& frame, const std::string& column) {
  const auto& values = frame.column(column);
  const auto fill = [&](auto array, const std::string& name) -> vtkSmartPointer<vtkDataArray> {
    array->SetName(name.c_str());
    array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
    for (std::size_t i = 0; i < values.size(); ++i)
      array->SetComponent(static_cast<vtkIdType>(i), 0, values[i]);
    return array;
  };
  const DumpColumn* const known = known_column(column);
  if (known && known->is_integer) return fill(vtkSmartPointer<vtkTypeInt64Array>::New(), column);
  return fill(vtkSmartPointer<vtkDoubleArray>::New(), known ? name_with_unit(*known) : column);
}

vtkSmartPointer<vtkDoubleArray> vector_array(const Frame& frame, const std::string& name,
                                             const std::array<const char*, 3>& columns) {
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name.c_str());
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(frame.rows));
  for (int c = 0; c < 3; ++c) {
    const auto& values = frame.column(columns[static_cast<std::size_t>(c)]);
    for (std::size_t i = 0; i < frame.rows; ++i)
      array->SetComponent(static_cast<vtkIdType>(i), c, values[i]);
  }
  return array;
}

}  // namespace

DumpKind kind_of(const Frame& frame) {
  if (frame.has("body_i")) return DumpKind::contacts;
  if (frame.has("body")) return DumpKind::spheres;
  if (frame.has("half_length")) return DumpKind::bodies;
  throw DataError(
      frame.file + ":" + std::to_string(frame.header_line) +
      ": expected a dump of bodies (column 'half_length'), spheres ('body') or contacts "
      "('body_i')");
}

std::string kind_name(DumpKind kind) {
  return kind == DumpKind::bodies ? "bodies" : kind == DumpKind::spheres ? "spheres" : "contacts";
}

void add_frame_arrays(const Frame& frame, std::set<std::string> used,
                      vtkDataSetAttributes* attributes) {
  for (const auto& [name, columns] : vectors)
    if (std::all_of(columns.begin(), columns.end(), [&](auto each) { return frame.has(each); })) {
      attributes->AddArray(vector_array(frame, name, columns));
      used.insert(columns.begin(), columns.end());
    }
  for (std::size_t c = 0; c < frame.names.size(); ++c) {
    const auto& name = frame.names[c];
    // A column of text that we do not know is left out; a bad number in one that we know throws.
    if (!used.count(name) && (known_column(name) || frame.bad_fields[c].line == 0))
      attributes->AddArray(scalar_array(frame, name));
  }
}

void write_poly_data(vtkPolyData* data, const std::string& file) {
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(data);
  if (writer->Write() != 1) throw DataError(file + ": cannot be written");
}

void write_vtp(const Frame& frame, DumpKind kind, const std::string& file) {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  std::set<std::string> used;
  const bool lines = kind == DumpKind::contacts;
  const auto rows = static_cast<vtkIdType>(frame.rows);
  if (lines) {
    for (const auto& ends :
         {std::array<const char*, 3>{"bix", "biy", "biz"}, {"bjx", "bjy", "bjz"}}) {
      const auto array = vector_array(frame, "", ends);
      for (vtkIdType i = 0; i < rows; ++i) points->InsertNextPoint(array->GetTuple(i));
      used.insert(ends.begin(), ends.end());
    }
    for (vtkIdType i = 0; i < rows; ++i) {
      const vtkIdType ends[2] = {i, rows + i};
      cells->InsertNextCell(2, ends);
    }
    data->SetLines(cells);
  } else {
    const auto array = vector_array(frame, "", {"x", "y", "z"});
    used = {"x", "y", "z"};
    for (vtkIdType i = 0; i < rows; ++i) {
      points->InsertNextPoint(array->GetTuple(i));
      cells->InsertNextCell(1, &i);
    }
    data->SetVerts(cells);
  }
  data->SetPoints(points);

  // One value per row: on the points of bodies and spheres, on the lines of contacts.
  if (lines) data->GetCellData()->AddArray(vector_array(frame, "contact_point_m", {"x", "y", "z"}));
  used.insert({"x", "y", "z"});
  vtkDataSetAttributes* attributes = data->GetPointData();
  if (lines) attributes = data->GetCellData();
  add_frame_arrays(frame, used, attributes);
  write_poly_data(data, file);
}

namespace {

void require_bodies(const std::vector<std::string>& files) {
  for (const auto& file : files) {
    Frame frame;
    if (DumpReader(file).next(frame) &&
        (is_stock_dump(frame) || kind_of(frame) == DumpKind::bodies))
      return;
  }
  throw DataError("--capsules: expected a dump of bodies, found none");
}

// Visits a frame as one of the kinds; not at all where it is a stock dump of contacts whose spheres
// are missing.
void visit_as_some_kind(const Frame& read, const std::function<Frame(const Frame&)>& contacts_of,
                        const std::function<void(const Frame&)>& visit) {
  if (is_stock_dump(read)) return visit(as_bodies(read));
  if (!contacts_of || read.names[0].rfind("c_", 0) != 0) return visit(read);
  std::optional<Frame> contacts;
  try {
    contacts = contacts_of(read);
  } catch (const NoSuchFrame&) {
    return;
  }
  visit(*contacts);
}

// The index of the frames of one kind, by their times.
std::string pvd_text(const std::map<long, std::string>& frames, double timestep_s) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
  for (const auto& [timestep, name] : frames) {
    const double time = static_cast<double>(timestep) * (timestep_s > 0 ? timestep_s : 1);
    text += "<DataSet timestep=\"" + number_text(time) + "\" part=\"0\" file=\"" + name + "\"/>\n";
  }
  return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace

std::vector<std::string> export_vtk(const std::vector<std::string>& files,
                                    const std::string& folder, double timestep_s, bool capsules,
                                    const std::function<Frame(const Frame&)>& contacts_of) {
  if (capsules) require_bodies(files);
  std::vector<std::string> written;
  std::map<std::string, std::map<long, std::string>> index;
  std::map<DumpKind, FramePool> pools;
  const auto add = [&](const std::string& kind, long timestep) {
    const auto name = kind + "." + std::to_string(timestep) + ".vtp";
    index[kind][timestep] = name;
    written.push_back((std::filesystem::path(folder) / name).string());
    return written.back();
  };
  const auto write = [&](const Frame& frame) {
    const auto kind = kind_of(frame);
    // Empty frames are frames of a film; the same frame again is not.
    if (frame.rows > 0 && !pools.try_emplace(kind, false).first->second.take(frame)) return;
    if (index[kind_name(kind)].count(frame.timestep) > 0)
      throw DataError(frame.file + ":" + std::to_string(frame.header_line) +
                      ": expected each timestep once, found a second frame of " + kind_name(kind) +
                      " of timestep " + std::to_string(frame.timestep));
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw DataError(folder + ": cannot be created (" + error.message() + ")");
    write_vtp(frame, kind, add(kind_name(kind), frame.timestep));
    if (capsules && kind == DumpKind::bodies)
      write_capsules(frame, add("capsules", frame.timestep));
  };
  for_each_frame(files, [&](const Frame& read) { visit_as_some_kind(read, contacts_of, write); });
  for (const auto& [kind, frames] : index) {
    const auto path = (std::filesystem::path(folder) / (kind + ".pvd")).string();
    write_text(path, pvd_text(frames, timestep_s));
    written.push_back(path);
  }
  return written;
}

}  // namespace rodpack
