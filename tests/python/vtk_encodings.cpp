// SPDX-License-Identifier: GPL-2.0-or-later
// Usage: vtk_encodings FOLDER
// Writes one image in each encoding that VTK's writer has, NAME.vti, for fields_test.py to read: 3
// x 2 places at (10 + i, 20 + 2 j), the scalar 1 + x / y, the tensor x y -x y^2, an integer field,
// the time 0.1 s.
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLImageDataWriter.h>

#include <iostream>
#include <string>

int main(int count, char** words) {
  if (count != 2) {
    std::cerr << "Usage: vtk_encodings FOLDER\n";
    return 2;
  }
  vtkNew<vtkImageData> image;
  image->SetExtent(1, 3, 2, 3, 0,
                   0);  // that does not begin at 0: the origin is not the first place
  image->SetOrigin(9, 16, 0);
  image->SetSpacing(1, 2, 1);
  vtkNew<vtkDoubleArray> ratio;
  ratio->SetName("ratio");
  vtkNew<vtkDoubleArray> tensor;
  tensor->SetName("tensor_N_m");
  tensor->SetNumberOfComponents(4);
  const char* const names[] = {"xx", "xy", "yx", "yy"};
  for (int c = 0; c < 4; ++c) tensor->SetComponentName(c, names[c]);
  vtkNew<vtkIntArray> number;
  number->SetName("number");
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 3; ++i) {
      const double x = 10 + i;
      const double y = 20 + 2 * j;
      ratio->InsertNextValue(1 + x / y);
      tensor->InsertNextTuple4(x, y, -x, y * y);
      number->InsertNextValue(3 * j + i);
    }
  image->GetPointData()->AddArray(ratio);
  image->GetPointData()->AddArray(tensor);
  image->GetPointData()->AddArray(number);
  vtkNew<vtkDoubleArray> time;
  time->SetName("TimeValue");
  time->InsertNextValue(0.1);
  image->GetFieldData()->AddArray(time);

  const auto write = [&](const std::string& name, auto set) {
    vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetFileName((std::string(words[1]) + "/" + name + ".vti").c_str());
    writer->SetInputData(image);
    set(*writer);
    if (writer->Write() == 1) return true;
    std::cerr << name << ".vti cannot be written\n";
    return false;
  };
  const bool written = write("default", [](auto&) {}) &&
                       write("ascii", [](auto& w) { w.SetDataModeToAscii(); }) &&
                       write("binary_zlib", [](auto& w) { w.SetDataModeToBinary(); }) &&
                       write("binary",
                             [](auto& w) {
                               w.SetDataModeToBinary();
                               w.SetCompressorTypeToNone();
                             }) &&
                       write("appended", [](auto& w) { w.SetCompressorTypeToNone(); }) &&
                       write("raw",
                             [](auto& w) {
                               w.EncodeAppendedDataOff();
                               w.SetCompressorTypeToNone();
                             }) &&
                       write("raw_zlib_big_64",
                             [](auto& w) {
                               w.EncodeAppendedDataOff();
                               w.SetByteOrderToBigEndian();
                               w.SetHeaderTypeToUInt64();
                             }) &&
                       write("small_blocks", [](auto& w) { w.SetBlockSize(64); }) &&
                       write("unknown_lz4", [](auto& w) { w.SetCompressorTypeToLZ4(); });
  return written ? 0 : 1;
}
