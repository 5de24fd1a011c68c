// SPDX-License-Identifier: GPL-2.0-or-later
#include "run_planar.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "fix.h"
#include "fix_gravity.h"
#include "fix_move_multisphere.h"
#include "fix_multisphere_ab.h"
#include "force.h"
#include "modify.h"
#include "neighbor.h"
#include "output.h"
#include "planar_stop.h"
#include "rodpack/planar/scene.h"
#include "signal_handling.h"
#include "style_arguments.h"
#include "timer.h"
#include "update.h"

namespace LAMMPS_NS {

namespace {

// Fewer steps in a row than these are not worth the transfer to the engine and back.
const bigint fewest_steps = 8;

// Fixes that act in every step, whose action the engine takes over.
const char* const known_fixes[] = {"multisphere/ab", "enforce2d/multisphere",
                                   "wall/gran",      "wall/gran/solid",
                                   "gravity",        "contacthistory"};

bool quits() { return SignalHandler::request_quit && !SignalHandler::request_write_restart; }

bool is_interrupted() {
  return SignalHandler::request_quit || SignalHandler::request_write_restart;
}

bool is_known(const char* style) {
  for (const char* known : known_fixes)
    if (std::strcmp(style, known) == 0) return true;
  return false;
}

/// The mask of the ways in which a fix acts in every step, unannounced.
int every_step() {
  return FixConst::PRE_INITIAL_INTEGRATE | FixConst::INITIAL_INTEGRATE | FixConst::POST_INTEGRATE |
         FixConst::PRE_FORCE | FixConst::POST_FORCE | FixConst::PRE_FINAL_INTEGRATE |
         FixConst::FINAL_INTEGRATE | FixConst::ITERATE_IMPLICITLY;
}

/// Keeps freed memory in this process: the engine frees its memory before each observed step and
/// wants it again after it, and to return it to the system would cost more than all else there.
void keep_memory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
#endif
}

struct GravityAccess : FixGravity {
  static bool varies(FixGravity* gravity) { return gravity->*(&GravityAccess::varflag) != 0; }
};

struct NeighborAccess : Neighbor {
  /// Whether pairs of different bodies are left out.
  static bool leaves_out(Neighbor* neighbor) {
    return neighbor->*(&NeighborAccess::nex_type) > 0 ||
           neighbor->*(&NeighborAccess::nex_group) > 0 || neighbor->includegroup > 0;
  }
};

}  // namespace

RunPlanar::RunPlanar(LAMMPS* lmp, int narg, char** arg)
    : Verlet(lmp, narg, arg), min_skin_(0.0), max_skin_(0.0), contacts_(lmp), owners_(lmp) {
  read_options(narg, arg);
  keep_memory();
  if (comm->me != 0) return;
  const std::string line = planar_run_style + std::string(": processor instructions ") +
                           rodpack::name_of(rodpack::chosen(instructions_)) + "\n";
  for (FILE* out : {screen, logfile})
    if (out) std::fputs(line.c_str(), out);
}

void RunPlanar::read_options(int narg, char** arg) {
  StyleArguments arguments(lmp, planar_run_style, narg, arg, 0);
  while (arguments.more()) {
    const std::string keyword = arguments.new_keyword();
    if (keyword == "skin") {
      arguments.pair(keyword, a_length, min_skin_, max_skin_);
    } else if (keyword == "instructions") {
      try {
        instructions_ =
            rodpack::planar_instructions(arguments.word(keyword, "auto, baseline, avx2 or avx512"));
      } catch (const std::invalid_argument& reason) {
        arguments.fail(reason.what());
      }
    } else {
      arguments.reject_keyword(keyword, "skin or instructions");
    }
  }
}

RunPlanar::~RunPlanar() = default;

void RunPlanar::setup() {
  check();
  Verlet::setup();
}

void RunPlanar::setup_minimal(int flag) {
  check();
  Verlet::setup_minimal(flag);
}

void RunPlanar::check() {
  check_scene();
  check_fixes();
  contacts_.connect();
  owners_.connect();
  ranks_.reset(new MpiRanks(world));
}

void RunPlanar::check_scene() {
  if (domain->xperiodic || domain->yperiodic || domain->zperiodic)
    refuse(lmp, "periodic boundaries are not supported, expected 'boundary f f f'");
  if (domain->triclinic) refuse(lmp, "a triclinic box is not supported");
  if (atom->molecular || force->kspace)
    refuse(lmp, "bonds and long-range forces are not supported");
  if (NeighborAccess::leaves_out(neighbor))
    refuse(lmp, "neigh_modify exclude or include leaves pairs out, expected neither");
  bodies_ = NULL;
  if (modify->n_fixes_style("multisphere") == 1)
    bodies_ = dynamic_cast<FixMultisphereAB*>(modify->find_fix_style("multisphere", 0));
  if (!bodies_) refuse(lmp, "the bodies have to be those of one fix multisphere/ab");
  gravity_ = NULL;
  if (modify->n_fixes_style("gravity") > 0)
    gravity_ = static_cast<FixGravity*>(modify->find_fix_style("gravity", 0));
  if (gravity_ && GravityAccess::varies(gravity_))
    refuse(lmp, std::string("fix gravity (id ") + gravity_->id + ") varies, expected constants");
}

void RunPlanar::check_fixes() const {
  for (int k = 0; k < modify->nfix; ++k) {
    const Fix& fix = *modify->fix[k];
    if (is_known(fix.style)) continue;
    const auto* const mover = dynamic_cast<const FixMoveMultisphere*>(&fix);
    if (mover && !mover->motion().is_steady())
      refuse(lmp, std::string("fix ") + fix.style + " (id " + fix.id +
                      ") swings bodies or turns them about one point, expected a constant "
                      "velocity, and turning of each about its own centre");
    if ((modify->fmask[k] & every_step()) || fix.time_integrate)
      refuse(lmp, std::string("fix ") + fix.style + " (id " + fix.id +
                      ") acts in every step, which the engine cannot honour");
  }
}

/// The next step in which fix number k has to see the scene, or has particles to insert.
bigint RunPlanar::next_step_of(int k) const {
  const Fix& fix = *modify->fix[k];
  const bigint now = update->ntimestep;
  bigint next = update->laststep;
  if ((modify->fmask[k] & FixConst::END_OF_STEP) && fix.nevery > 0)
    next = std::min(next, (now / fix.nevery + 1) * static_cast<bigint>(fix.nevery));
  if (fix.force_reneighbor && fix.next_reneighbor > now) next = std::min(next, fix.next_reneighbor);
  return next;
}

bigint RunPlanar::next_observed_step() const {
  bigint next = update->laststep;
  if (output->next > update->ntimestep) next = std::min(next, output->next);
  for (int k = 0; k < modify->nfix; ++k) next = std::min(next, next_step_of(k));
  bigint next_of_all = next;
  MPI_Allreduce(&next, &next_of_all, 1, MPI_LMP_BIGINT, MPI_MIN, world);
  return next_of_all;
}

/// Whether something holds on any rank: signals, for one, reach some of them only. Collective.
bool RunPlanar::anywhere(bool here) const {
  const int mine = here;
  int any = mine;
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world);
  return any != 0;
}

void RunPlanar::run(int steps) {
  if (!ranks_) refuse(lmp, "'run ... pre no' before a run with 'pre yes'");
  if (!bodies_->planar())
    refuse(lmp, "fix multisphere/ab moves in space, expected 'planar yes' or a fix enforce2d");
  const bigint first = update->ntimestep;
  done_ = rodpack::PlanarScene::Statistics();
  run_until(first + steps);
  report(update->ntimestep - first);
}

/// Writes what the engine did, for whoever wonders about skins, observed steps or ranks.
void RunPlanar::report(bigint steps) const {
  const double mine[] = {static_cast<double>(done_.steps), static_cast<double>(done_.listings),
                         static_cast<double>(done_.ghosts), static_cast<double>(done_.sent)};
  double all[4];
  MPI_Reduce(mine, all, 4, MPI_DOUBLE, MPI_SUM, 0, world);
  if (comm->me != 0 || steps == 0) return;
  const double made = all[0] / comm->nprocs, each = std::max(all[0], 1.0);
  char line[256];
  int length = std::snprintf(line, sizeof line,
                             "Planar engine: %.4g %% of the steps; in each %.3g bodies listed anew",
                             100.0 * made / static_cast<double>(steps), all[1] / each);
  if (comm->nprocs > 1)
    std::snprintf(line + length, sizeof line - length, ", %.4g ghosts and %.4g bytes sent per rank",
                  all[2] / each, all[3] / each);
  for (FILE* out : {screen, logfile})
    if (out) std::fprintf(out, "%s\n", line);
}

void RunPlanar::run_until(bigint last) {
  while (update->ntimestep < last) {
    const bigint observed = std::min(last, next_observed_step());
    const bigint unobserved = observed - update->ntimestep - 1;
    bigint of_liggghts = observed - update->ntimestep;
    if (unobserved >= fewest_steps && bodies_->n_body_all() > 0) {
      run_engine(observed, last);
      if (anywhere(quits())) return;
      of_liggghts = 1;  // the observed step, or that in which bodies change their rank
    }
    Verlet::run(static_cast<int>(of_liggghts));
    if (anywhere(quits())) return;
  }
}

/// Runs the engine up to the step before the next observed one; lines that it takes in do not
/// count.
void RunPlanar::run_engine(bigint observed, bigint last) {
  timer->stamp();
  take_over();
  while (FixInsertLine* const line = line_alone_in(observed)) {
    run_scene(observed - update->ntimestep);
    if (update->ntimestep < observed) break;
    take_in_line(*line);
    observed = std::min(last, next_observed_step());
  }
  run_scene(observed - 1 - update->ntimestep);
  count_steps();
  timer->stamp(TIME_PAIR);
  give_back();
  timer->stamp(TIME_COMM);
}

/// Makes so many steps of the engine, fewer after an interrupt, or when bodies have to change their
/// rank.
void RunPlanar::run_scene(bigint steps) {
  const bigint chunk = 1000;  // steps between two checks for an interrupt
  try {
    while (steps > 0 && !anywhere(is_interrupted())) {
      const bigint wanted = std::min(chunk, steps);
      const bigint made = scene_->run(static_cast<long>(wanted));
      update->ntimestep += made;
      steps -= made;
      if (made < wanted) break;
    }
  } catch (const std::runtime_error& reason) {
    refuse_from_one_rank(lmp, reason.what());
  }
}

void RunPlanar::count_steps() {
  const rodpack::PlanarScene::Statistics made = scene_->statistics();
  done_.steps += made.steps;
  done_.listings += made.listings;
  done_.ghosts += made.ghosts;
  done_.sent += made.sent;
}

}  // namespace LAMMPS_NS
