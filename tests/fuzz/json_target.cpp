// SPDX-License-Identifier: GPL-2.0-or-later
// A parameters.json: read, asked for every number that is used, written again.
#include "input_file.h"
#include "reading/data_error.h"
#include "reading/json_file.h"
#include "reading/parameters.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const rodpack::test::InputFile file(data, size);
  try {
    const auto parameters = rodpack::read_parameters(file.name());
    for (const auto& [key, value] : parameters.values.items()) try {
        parameters.number(key);
      } catch (const rodpack::DataError&) {
      }
    rodpack::write_json("/dev/null", rodpack::read_json_object(file.name()));
  } catch (const rodpack::DataError&) {
  }
  return 0;
}
