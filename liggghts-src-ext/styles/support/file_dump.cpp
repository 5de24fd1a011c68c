// SPDX-License-Identifier: GPL-2.0-or-later
#include "file_dump.h"

#include <algorithm>
#include <cstring>
#include "dump_files.h"
#include "stop_run.h"
#include "update.h"

namespace LAMMPS_NS {

bool FileDump::ends_in(const std::string& ending) const {
  const std::size_t length = std::strlen(filename);
  return length >= ending.size() && ending == filename + length - ending.size();
}

void FileDump::require_ending(const std::vector<std::string>& endings) {
  const auto is_of_file = [this](const std::string& ending) { return ends_in(ending); };
  if (!multiproc && std::any_of(endings.begin(), endings.end(), is_of_file)) return;
  std::string expected;
  for (const std::string& ending : endings) expected += (expected.empty() ? "" : " or ") + ending;
  stop_run(lmp, *this,
           std::string("file is ") + filename + ", expected a name that ends in " + expected +
               ", without %");
}

void FileDump::require_si_and_folder(const std::string& names) {
  if (std::strcmp(update->unit_style, "si") != 0)
    stop_run(lmp, *this,
             "its " + names + " are named with units of SI: the deck's units are " +
                 update->unit_style + ", expected si");
  require_folder(lmp, *this, filename);
}

std::string FileDump::file_name() const {
  return name_at_step(filename, update->ntimestep, padflag);
}

}  // namespace LAMMPS_NS
