// SPDX-License-Identifier: GPL-2.0-or-later
#include "stop_run.h"

#include <mpi.h>
#include <cstdio>
#include <cstdlib>

#include "compute.h"
#include "dump.h"
#include "error.h"
#include "fix.h"
#include "lammps.h"
#include "universe.h"

namespace LAMMPS_NS {

namespace {

std::string name_of(const char* kind, const char* style, const char* id) {
  return std::string(kind) + " " + style + " (id " + id + ")";
}

}  // namespace

std::string name_of(const Fix& fix) { return name_of("Fix", fix.style, fix.id); }

std::string name_of(const Compute& compute) {
  return name_of("Compute", compute.style, compute.id);
}

std::string name_of(const Dump& dump) { return name_of("Dump", dump.style, dump.id); }

void stop_run(LAMMPS* lmp, const std::string& message) {
  lmp->error->all(FLERR, message.c_str());
  std::abort();  // not reached: Error::all ends the run, but does not say so to the compiler
}

void stop_run_from_one_rank(LAMMPS* lmp, const std::string& message) {
  // As Error::one, whose line stays in a buffer that MPI_Abort throws away unless the screen is a
  // terminal; and the log file has it too here.
  int rank = 0;
  MPI_Comm_rank(lmp->world, &rank);
  const std::string line = "ERROR on proc " + std::to_string(rank) + ": " + message + "\n";
  FILE* const of_all_worlds = lmp->universe->nworlds > 1 ? lmp->universe->uscreen : NULL;
  for (FILE* out : {lmp->screen, lmp->logfile, of_all_worlds}) {
    if (!out) continue;
    std::fputs(line.c_str(), out);
    std::fflush(out);
  }
  MPI_Abort(lmp->world, 1);
  std::abort();  // not reached
}

}  // namespace LAMMPS_NS
