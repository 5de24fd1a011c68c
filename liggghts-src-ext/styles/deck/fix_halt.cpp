// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_halt.h"

#include <cstdio>
#include <cstring>
#include "comm.h"
#include "input.h"
#include "modify.h"
#include "output.h"
#include "signal_handling.h"
#include "stop_run.h"
#include "style_arguments.h"
#include "update.h"
#include "variable.h"

namespace LAMMPS_NS {

namespace {

const char* const expected_variable = "v_ and the name of an equal-style variable";

}  // namespace

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
  StyleArguments arguments(lmp, narg, arg);
  nevery = arguments.integer("N", a_count);
  const std::string variable = arguments.word("v_NAME", expected_variable);
  if (variable.compare(0, 2, "v_") != 0) arguments.reject("v_NAME", expected_variable, variable);
  variable_ = variable.substr(2);
  operator_text_ = arguments.peek();
  operator_ =
      static_cast<Operator>(arguments.choice("OPERATOR", {"<", "<=", ">", ">=", "==", "!="}));
  value_ = arguments.number("VALUE", "a number");
  read_keywords(arguments);

  scalar_flag = 1;
  restart_global = 1;
  global_freq = 1;
  extscalar = 0;
  // Computes that keep a list of steps need to be asked for in advance; which ones the variable
  // uses is not known yet.
  modify->addstep_compute_all((update->ntimestep / nevery) * nevery + nevery);
}

void FixHalt::read_keywords(StyleArguments& arguments) {
  while (arguments.more()) {
    const std::string keyword = arguments.new_keyword();
    if (keyword == "start")
      start_ = arguments.step(keyword, "a step in [0, 1e15]");
    else if (keyword == "hold")
      hold_ = arguments.step(keyword, "a number of steps in [0, 1e15]");
    else if (keyword == "message")
      message_ = arguments.yes_or_no(keyword);
    else
      arguments.reject_keyword(keyword, "start, hold or message");
  }
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
  if (index_ < 0 || !input->variable->equalstyle(index_))
    stop_run(lmp, *this,
             "v_NAME is 'v_" + variable_ + "', expected " + expected_variable +
                 (index_ < 0 ? ": there is no such variable" : ": that one is of another style"));
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
