// SPDX-License-Identifier: GPL-2.0-or-later
#include "stop_run.h"

#include <mpi.h>
#include <cstdio>
#include <cstdlib>
#include <regex>

#include "compute.h"
#include "dump.h"
#include "error.h"
#include "fix.h"
#include "lammps.h"
#include "universe.h"
#include "update.h"

namespace LAMMPS_NS {

namespace {

std::string name_of(const char* kind, const char* style, const char* id) {
  return std::string(kind) + " " + style + " (id " + id + ")";
}

/// A message, whose units are those of SI, in the units of the deck.
std::string in_units_of_deck(const LAMMPS* lmp, const std::string& message) {
  const std::string units = lmp->update ? lmp->update->unit_style : "si";
  if (units == "si") return message;
  const bool cgs = units == "cgs";
  const auto replaced = [](const std::string& text, const char* what, const char* by) {
    return std::regex_replace(text, std::regex(what), by);
  };
  std::string text = replaced(message, "\\(N/m\\)", cgs ? "(dyn/cm)" : "(units of the deck)");
  text = replaced(text, "([0-9] |\\bin |\\()m\\b", cgs ? "$1cm" : "$1units of length");
  return cgs ? text : replaced(text, "([0-9] )s\\b", "$1units of time");
}

}  // namespace

std::string name_of(const Fix& fix) { return name_of("Fix", fix.style, fix.id); }

std::string name_of(const Compute& compute) {
  return name_of("Compute", compute.style, compute.id);
}

std::string name_of(const Dump& dump) { return name_of("Dump", dump.style, dump.id); }

void stop_run(LAMMPS* lmp, const std::string& message) {
  lmp->error->all(FLERR, in_units_of_deck(lmp, message).c_str());
  std::abort();  // not reached: Error::all ends the run, but does not say so to the compiler
}

void stop_run_by_rank_0(LAMMPS* lmp, std::string message) {
  int size = static_cast<int>(message.size());
  MPI_Bcast(&size, 1, MPI_INT, 0, lmp->world);
  message.resize(size);
  MPI_Bcast(&message[0], size, MPI_CHAR, 0, lmp->world);
  if (size > 0) stop_run(lmp, message);
}

void stop_run_from_one_rank(LAMMPS* lmp, const std::string& message) {
#ifdef RODPACK_STAGED
  lmp->error->one(FLERR, in_units_of_deck(lmp, message).c_str());
#else
  // As stock Error::one, whose line stays in a buffer that MPI_Abort throws away unless the screen
  // is a terminal; and the log file has it too here.
  int rank = 0;
  MPI_Comm_rank(lmp->world, &rank);
  const std::string line =
      "ERROR on proc " + std::to_string(rank) + ": " + in_units_of_deck(lmp, message) + "\n";
  FILE* const of_all_worlds = lmp->universe->nworlds > 1 ? lmp->universe->uscreen : NULL;
  for (FILE* out : {lmp->screen, lmp->logfile, of_all_worlds}) {
    if (!out) continue;
    std::fputs(line.c_str(), out);
    std::fflush(out);
  }
  MPI_Abort(lmp->world, 1);
#endif
  std::abort();  // not reached
}

}  // namespace LAMMPS_NS
