// SPDX-License-Identifier: GPL-2.0-or-later
#include "dump_files.h"

#include <cstdio>
#include "dump.h"
#include "output_file.h"
#include "stop_run.h"

namespace LAMMPS_NS {

std::string name_at_step(std::string name, long long step, int width) {
  const std::size_t star = name.find('*');
  if (star == std::string::npos) return name;
  char digits[64];
  std::snprintf(digits, sizeof(digits), "%0*lld", width, step);
  return name.replace(star, 1, digits);
}

void require_folder(LAMMPS* lmp, const Dump& dump, const std::string& file) {
  int rank = 0;
  MPI_Comm_rank(lmp->world, &rank);
  std::string fault = rank == 0 ? fault_of_folder(file) : "";
  if (!fault.empty()) fault = name_of(dump) + ": Cannot write dump file " + file + ": " + fault;
  stop_run_by_rank_0(lmp, fault);
}

}  // namespace LAMMPS_NS
