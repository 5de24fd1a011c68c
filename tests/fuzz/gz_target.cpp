// SPDX-License-Identifier: GPL-2.0-or-later
// The bytes of a .gz dump, damaged anywhere: the frames and the first timestep.
#include "input_file.h"
#include "reading/dump.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const rodpack::test::InputFile file(data, size);
  try {
    rodpack::DumpReader::first_timestep(file.name());
  } catch (const rodpack::DataError&) {
  }
  try {
    rodpack::last_frame({file.name()});
  } catch (const rodpack::DataError&) {
  }
  return 0;
}
