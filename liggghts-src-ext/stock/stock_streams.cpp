// SPDX-License-Identifier: GPL-2.0-or-later
#include "stock_streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string>

#include "comm.h"
#include "error.h"
#include "lammps.h"
#include "modify.h"
#include "universe.h"

using LAMMPS_NS::LAMMPS;

namespace rodpack {

namespace {

/// Absolute name of the log file, as ranks that do not have it open need it; empty if there is
/// none.
std::string log_name;

void stop(LAMMPS* lmp, const std::string& what, int reason) {
  const std::string text =
      "Cannot write " + what + ": " + (reason ? std::strerror(reason) : "a write has failed");
  lmp->error->one(FLERR, text.c_str());
}

/// Whether a write to `file` has failed, now or before.
bool has_failed(std::FILE* file) {
  errno = 0;
  return std::fflush(file) != 0 || std::ferror(file);
}

}  // namespace

void keep_log(std::FILE* log, const char* name) {
  log_name.clear();
  if (std::strcmp(name, "none") == 0) return;
  char folder[PATH_MAX];
  const bool relative = name[0] != '/';
  if (relative && getcwd(folder, sizeof folder)) log_name = std::string(folder) + "/";
  log_name += name;
  if (!log) return;
  // Lines of other ranks are added at the end: none must be overwritten.
  const int flags = fcntl(fileno(log), F_GETFL);
  if (flags != -1) fcntl(fileno(log), F_SETFL, flags | O_APPEND);
}

void error_to_log(LAMMPS* lmp, const char* file, int line, const char* text) {
  int rank = 0;
  MPI_Comm_rank(lmp->world, &rank);
  std::FILE* log = lmp->logfile;
  if (!log && rank > 0 && !log_name.empty()) log = std::fopen(log_name.c_str(), "a");
  if (!log) return;
  std::fprintf(log, "ERROR on proc %d: %s (%s:%d)\n", rank, text, file, line);
  std::fflush(log);
}

void abort_run(LAMMPS* lmp, MPI_Comm world) {
  if (lmp->screen && has_failed(lmp->screen))
    std::fprintf(stderr, "ERROR: cannot write to the screen\n");
  std::fflush(NULL);
  MPI_Abort(world, 1);
}

void let_writes_fail() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

void check_streams(LAMMPS* lmp) {
  if (lmp->screen && has_failed(lmp->screen)) {
    const int reason = errno;
    std::fprintf(stderr, "ERROR: Cannot write to the screen: %s\n",
                 reason ? std::strerror(reason) : "a write has failed");
    stop(lmp, "to the screen", reason);
  }
  if (lmp->logfile && has_failed(lmp->logfile)) stop(lmp, "the log file " + log_name, errno);
}

void check_written(LAMMPS* lmp, std::FILE* file, const char* what, const char* which) {
  if (has_failed(file)) stop(lmp, std::string(what) + " " + which, errno);
}

void close_written(LAMMPS* lmp, std::FILE* file, const char* what, const char* which) {
  check_written(lmp, file, what, which);
  errno = 0;
  if (std::fclose(file) != 0) stop(lmp, std::string(what) + " " + which, errno);
}

void warn_of_kinetic_energy(LAMMPS* lmp) {
  static bool said = false;
  if (said || lmp->modify->n_fixes_style("multisphere") == 0) return;
  said = true;
  if (lmp->comm->me == 0)
    lmp->error->warning(FLERR,
                        "Thermo's own kinetic energy ke is not that of multispheres: take compute "
                        "multisphere/ke");
}

}  // namespace rodpack
