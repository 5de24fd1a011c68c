// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIELD_IMAGE_H
#define RODPACK_FIELD_IMAGE_H

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLImageDataWriter.h>

#include <string>
#include <vector>

#include "rodpack/averaging/coarse_graining.h"

namespace rodpack {

/// Writes fields on a grid as VTK image data (.vti); header-only, so that what does without VTK
/// need not link it. An array per field, named `name_unit`; vectors have three components, as
/// ParaView's filters want them. `time` goes into the file as TimeValue. False when it cannot be
/// written.
inline bool write_field_image(const Grid& grid, const std::vector<Field>& fields, double time,
                              const std::string& file) {
  vtkNew<vtkImageData> image;
  image->SetDimensions(grid.count[0], grid.count[1], grid.count[2]);
  image->SetOrigin(grid.origin[0], grid.origin[1], grid.origin[2]);
  image->SetSpacing(grid.spacing[0], grid.spacing[1], grid.spacing[2]);
  for (const Field& field : fields) {
    const bool vector = field.components.size() > 1 && field.components.front().size() == 1;
    vtkNew<vtkDoubleArray> array;
    array->SetName((field.unit.empty() ? field.name : field.name + "_" + field.unit).c_str());
    array->SetNumberOfComponents(vector ? 3 : static_cast<int>(field.components.size()));
    for (std::size_t c = 0; c < field.components.size(); ++c)
      if (!field.components[c].empty())
        array->SetComponentName(static_cast<vtkIdType>(c), field.components[c].c_str());
    array->SetNumberOfTuples(static_cast<vtkIdType>(grid.size()));
    array->Fill(0);
    for (std::size_t c = 0; c < field.values.size(); ++c)
      for (std::size_t i = 0; i < grid.size(); ++i)
        array->SetComponent(static_cast<vtkIdType>(i), static_cast<int>(c), field.values[c][i]);
    image->GetPointData()->AddArray(array);
  }
  vtkNew<vtkDoubleArray> moment;
  moment->SetName("TimeValue");
  moment->InsertNextValue(time);
  image->GetFieldData()->AddArray(moment);
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(image);
  return writer->Write() == 1;
}

}  // namespace rodpack

#endif
