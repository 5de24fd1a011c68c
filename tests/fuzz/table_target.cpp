// SPDX-License-Identifier: GPL-2.0-or-later
// A table, CSV or LIGGGHTS's own: every column as text, numbers, whole numbers; as energies, and as
// what has come through an orifice.
#include "analysis/discharge/outflow.h"
#include "analysis/energies.h"
#include "input_file.h"
#include "reading/data_error.h"
#include "reading/table.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const rodpack::test::InputFile file(data, size);
  const auto attempt = [](auto read) {
    try {
      read();
    } catch (const rodpack::DataError&) {
    }
  };
  attempt([&] {
    const auto table = rodpack::read_table(file.name());
    for (const auto& name : table.names()) {
      attempt([&] { table.words(name); });
      attempt([&] { table.finite(name); });
      attempt([&] { table.whole_numbers(name); });
    }
  });
  attempt([&] { rodpack::read_energies(file.name()); });
  attempt([&] { rodpack::measure_outflow(rodpack::read_outflow(file.name()), {}); });
  return 0;
}
