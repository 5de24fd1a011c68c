// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_halt.h"

#include <cstdio>
#include <cstring>
#include "comm.h"
#include "error.h"
#include "force.h"
#include "input.h"
#include "modify.h"
#include "output.h"
#include "signal_handling.h"
#include "update.h"
#include "variable.h"

namespace LAMMPS_NS {

FixHalt::FixHalt(LAMMPS* lmp, int narg, char** arg)
    : Fix(lmp, narg, arg),
      index_(-1),
      operator_(LESS),
      start_(0),
      hold_(0),
      since_(-1),
      message_(true),
      halted_(false),
      quit_set_here_(false) {
  if (narg < 7) error->fix_error(FLERR, this, "expected: N v_name operator value");
  nevery = force->inumeric(FLERR, arg[3]);
  if (nevery <= 0)
    error->fix_error(FLERR, this, (std::string("N is ") + arg[3] + ", expected N > 0").c_str());
  if (std::strncmp(arg[4], "v_", 2) != 0)
    error->fix_error(
        FLERR, this,
        (std::string("condition on ") + arg[4] + ", expected v_ and a variable's name").c_str());
  variable_ = arg[4] + 2;
  parse_operator(arg[5]);
  value_ = force->numeric(FLERR, arg[6]);

  for (int iarg = 7; iarg < narg; iarg += 2) {
    const std::string keyword = arg[iarg];
    if (iarg + 1 >= narg) error->fix_error(FLERR, this, (keyword + " needs a value").c_str());
    const std::string value = arg[iarg + 1];
    if (keyword == "start") {
      start_ = ATOBIGINT(arg[iarg + 1]);
      if (start_ < 0)
        error->fix_error(FLERR, this, ("start is " + value + ", expected a step >= 0").c_str());
    } else if (keyword == "hold") {
      hold_ = ATOBIGINT(arg[iarg + 1]);
      if (hold_ < 0)
        error->fix_error(FLERR, this,
                         ("hold is " + value + ", expected a number of steps >= 0").c_str());
    } else if (keyword == "message") {
      if (value != "yes" && value != "no")
        error->fix_error(FLERR, this, ("message is " + value + ", expected yes or no").c_str());
      message_ = value == "yes";
    } else {
      error->fix_error(FLERR, this, ("unknown keyword " + keyword).c_str());
    }
  }

  scalar_flag = 1;
  restart_global = 1;
  global_freq = 1;
  extscalar = 0;
  // Computes that keep a list of steps need to be asked for in advance; which ones the variable
  // uses is not known yet.
  modify->addstep_compute_all((update->ntimestep / nevery) * nevery + nevery);
}

void FixHalt::parse_operator(const char* text) {
  static const char* const names[] = {"<", "<=", ">", ">=", "==", "!="};
  for (int k = 0; k < 6; ++k) {
    if (std::strcmp(text, names[k]) != 0) continue;
    operator_ = static_cast<Operator>(k);
    operator_text_ = text;
    return;
  }
  error->fix_error(
      FLERR, this,
      (std::string("operator is ") + text + ", expected <, <=, >, >=, == or !=").c_str());
}

bool FixHalt::holds(double left) const {
  switch (operator_) {
    case LESS:
      return left < value_;
    case LESS_EQUAL:
      return left <= value_;
    case GREATER:
      return left > value_;
    case GREATER_EQUAL:
      return left >= value_;
    case EQUAL:
      return left == value_;
    default:
      return left != value_;
  }
}

int FixHalt::setmask() { return FixConst::END_OF_STEP | FixConst::POST_RUN; }

void FixHalt::init() {
  index_ = input->variable->find(const_cast<char*>(variable_.c_str()));
  if (index_ < 0) error->fix_error(FLERR, this, ("there is no variable " + variable_).c_str());
  if (!input->variable->equalstyle(index_))
    error->fix_error(FLERR, this, ("variable " + variable_ + " is not of style equal").c_str());
}

void FixHalt::setup(int) { halted_ = false; }

void FixHalt::end_of_step() {
  modify->clearstep_compute();
  double left = input->variable->compute_equal(index_);
  modify->addstep_compute(update->ntimestep + nevery);
  if (update->ntimestep < start_) return;
  // Rounding may differ between ranks; all of them have to leave the loop in the same step.
  MPI_Bcast(&left, 1, MPI_DOUBLE, 0, world);
  if (!holds(left)) {
    since_ = -1;
    return;
  }
  if (since_ < 0) since_ = update->ntimestep;
  if (update->ntimestep - since_ < hold_) return;

  halted_ = true;
  if (message_ && comm->me == 0) {
    char text[512];
    std::snprintf(text, sizeof(text),
                  "fix halt %s: variable %s = %g %s %g at step " BIGINT_FORMAT "\n", id,
                  variable_.c_str(), left, operator_text_.c_str(), value_, update->ntimestep);
    if (screen) std::fputs(text, screen);
    if (logfile) std::fputs(text, logfile);
  }

  // This is the last step now: thermodynamic output belongs to it, and the averages over the run
  // count the steps that were done.
  update->nsteps = static_cast<int>(update->ntimestep - update->firststep);
  update->laststep = update->ntimestep;
  output->next_thermo = update->ntimestep;
  output->next = update->ntimestep;
  // The loop of the run has one way out, the flag of an interrupt; post_run takes it back, so that
  // the input script goes on. A true interrupt stays.
  quit_set_here_ = !SignalHandler::request_quit;
  SignalHandler::request_quit = true;
}

void FixHalt::write_restart(FILE* file) {
  if (comm->me != 0) return;
  const double since = static_cast<double>(since_);
  const int size = sizeof(since);
  std::fwrite(&size, sizeof(size), 1, file);
  std::fwrite(&since, sizeof(since), 1, file);
}

void FixHalt::restart(char* buffer) {
  double since;
  std::memcpy(&since, buffer, sizeof(since));
  since_ = static_cast<bigint>(since);
}

void FixHalt::post_run() {
  if (quit_set_here_) SignalHandler::request_quit = false;
  quit_set_here_ = false;
}

}  // namespace LAMMPS_NS
