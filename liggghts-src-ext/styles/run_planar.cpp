// SPDX-License-Identifier: GPL-2.0-or-later
#include "run_planar.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "fix_gravity.h"
#include "fix_multisphere_ab.h"
#include "multisphere.h"
#include "force.h"
#include "modify.h"
#include "neighbor.h"
#include "output.h"
#include "rodpack/planar_scene.h"
#include "signal_handling.h"
#include "timer.h"
#include "update.h"

namespace LAMMPS_NS {

namespace {

// Fewer quiet steps than these are not worth the way there and back.
const bigint fewest_steps = 8;

// Fixes that act in every step, by what the engine does itself.
const char* const known_fixes[] = {"multisphere/ab", "enforce2d/multisphere",
                                   "wall/gran",      "wall/gran/solid",
                                   "gravity",        "contacthistory"};

bool is_known(const char* style) {
  for (const char* known : known_fixes)
    if (std::strcmp(style, known) == 0) return true;
  return false;
}

/// Steps in which a fix acts that are not announced.
int every_step() {
  return FixConst::PRE_INITIAL_INTEGRATE | FixConst::INITIAL_INTEGRATE | FixConst::POST_INTEGRATE |
         FixConst::PRE_FORCE | FixConst::POST_FORCE | FixConst::PRE_FINAL_INTEGRATE |
         FixConst::FINAL_INTEGRATE | FixConst::ITERATE_IMPLICITLY;
}

struct GravityAccess : FixGravity {
  static bool varies(FixGravity* gravity) { return gravity->*(&GravityAccess::varflag) != 0; }
};

}  // namespace

RunPlanar::RunPlanar(LAMMPS* lmp, int narg, char** arg)
    : Verlet(lmp, narg, arg), min_skin_(0.0), max_skin_(0.0), contacts_(lmp) {
  read_options(narg, arg);
  if (comm->me != 0) return;
  const std::string line = std::string("run_style verlet/planar: processor instructions ") +
                           rodpack::name_of(rodpack::chosen(instructions_)) + "\n";
  for (FILE* out : {screen, logfile})
    if (out) std::fputs(line.c_str(), out);
}

void RunPlanar::read_options(int narg, char** arg) {
  for (int k = 0; k < narg;) {
    if (std::strcmp(arg[k], "skin") == 0 && k + 2 < narg) {
      min_skin_ = force->numeric(FLERR, arg[k + 1]);
      max_skin_ = force->numeric(FLERR, arg[k + 2]);
      if (!(min_skin_ > 0.0) || max_skin_ < min_skin_)
        refuse(std::string("skin is ") + arg[k + 1] + " " + arg[k + 2] +
               ", expected 0 < least <= largest (m)");
      k += 3;
    } else if (std::strcmp(arg[k], "instructions") == 0 && k + 1 < narg) {
      try {
        instructions_ = rodpack::planar_instructions(arg[k + 1]);
      } catch (const std::invalid_argument& reason) {
        refuse(reason.what());
      }
      k += 2;
    } else {
      refuse(std::string("unknown keyword or missing value at '") + arg[k] +
             "', expected skin and two lengths, or instructions and their name");
    }
  }
}

RunPlanar::~RunPlanar() = default;

void RunPlanar::refuse(const std::string& what) const {
  error->all(FLERR, ("run_style verlet/planar: " + what).c_str());
}

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
}

void RunPlanar::check_scene() {
  if (comm->nprocs > 1)
    refuse("it runs on one rank so far, but there are " + std::to_string(comm->nprocs));
  if (domain->xperiodic || domain->yperiodic || domain->zperiodic)
    refuse("periodic boundaries are not supported, expected 'boundary f f f'");
  if (domain->triclinic) refuse("a triclinic box is not supported");
  if (atom->molecular || force->kspace) refuse("bonds and long-range forces are not supported");
  bodies_ = NULL;
  if (modify->n_fixes_style("multisphere") == 1)
    bodies_ = dynamic_cast<FixMultisphereAB*>(modify->find_fix_style("multisphere", 0));
  if (!bodies_) refuse("the bodies have to be those of one fix multisphere/ab");
  gravity_ = NULL;
  if (modify->n_fixes_style("gravity") > 0)
    gravity_ = static_cast<FixGravity*>(modify->find_fix_style("gravity", 0));
  if (gravity_ && GravityAccess::varies(gravity_))
    refuse(std::string("fix gravity (id ") + gravity_->id + ") varies, expected constants");
}

void RunPlanar::check_fixes() const {
  for (int k = 0; k < modify->nfix; ++k) {
    const Fix& fix = *modify->fix[k];
    if (is_known(fix.style)) continue;
    if ((modify->fmask[k] & every_step()) || fix.time_integrate)
      refuse(std::string("fix ") + fix.style + " (id " + fix.id +
             ") acts in every step, which the engine cannot honour");
  }
}

bigint RunPlanar::next_look() const {
  const bigint now = update->ntimestep;
  bigint next = update->laststep;
  if (output->next > now) next = std::min(next, output->next);
  for (int k = 0; k < modify->nfix; ++k) {
    const Fix& fix = *modify->fix[k];
    if ((modify->fmask[k] & FixConst::END_OF_STEP) && fix.nevery > 0)
      next = std::min(next, (now / fix.nevery + 1) * static_cast<bigint>(fix.nevery));
    if (fix.force_reneighbor && fix.next_reneighbor > now)
      next = std::min(next, fix.next_reneighbor);
  }
  return next;
}

void RunPlanar::run(int steps) {
  const bigint last = update->ntimestep + steps;
  if (!bodies_->planar())
    refuse("fix multisphere/ab moves in space, expected 'planar yes' or a fix enforce2d");
  while (update->ntimestep < last) {
    const bigint look = std::min(last, next_look());
    const bigint quiet = look - update->ntimestep - 1;
    if (quiet >= fewest_steps && bodies_->n_body() > 0) run_engine(quiet);
    if (SignalHandler::request_quit && !SignalHandler::request_write_restart) return;
    Verlet::run(static_cast<int>(look - update->ntimestep));
    if (SignalHandler::request_quit && !SignalHandler::request_write_restart) return;
  }
}

void RunPlanar::run_engine(bigint steps) {
  timer->stamp();
  take_over();
  const bigint chunk = 1000;  // between two looks for an interrupt
  bigint done = 0;
  while (done < steps && !SignalHandler::request_quit && !SignalHandler::request_write_restart) {
    const bigint next = std::min(chunk, steps - done);
    scene_->run(static_cast<long>(next));
    done += next;
  }
  update->ntimestep += done;
  timer->stamp(TIME_PAIR);
  give_back();
  timer->stamp(TIME_COMM);
}

void RunPlanar::sort_atoms_by_body() {
  atoms_.assign(bodies_->n_body(), std::vector<int>());
  places_.resize(atom->nlocal);
  for (int i = 0; i < atom->nlocal; ++i) {
    const int tag = bodies_->belongs_to(i), body = tag < 0 ? -1 : bodies_->data().map(tag);
    if (body < 0)
      refuse("atom " + std::to_string(atom->tag[i]) + " belongs to no body of fix multisphere/ab");
    places_[i].body = body;
    places_[i].sphere = static_cast<int>(atoms_[body].size());
    atoms_[body].push_back(i);
  }
}

void RunPlanar::take_over() {
  sort_atoms_by_body();
  rodpack::PlanarSettings settings;
  settings.dt = update->dt;
  settings.order = bodies_->order();
  settings.remembered = contacts_.remembered();
  settings.events = bodies_->follows_events();
  settings.types = atom->ntypes;
  settings.laws = contacts_.laws();
  settings.walls = contacts_.walls();
  settings.close_factor = neighbor->contactDistanceFactor;
  if (gravity_) {
    double acceleration[3];
    gravity_->get_gravity(acceleration);
    std::copy(acceleration, acceleration + 2, settings.gravity);
  }
  double least = 1e300, z = atom->nlocal > 0 ? atom->x[0][2] : 0.0;
  std::vector<rodpack::PlanarBody> bodies;
  for (int body = 0; body < bodies_->n_body(); ++body) {
    if (atoms_[body].empty()) refuse("a body without spheres");
    bodies.push_back(bodies_->to_planar(body, atoms_[body]));
    bodies.back().type = atom->type[atoms_[body][0]] - 1;
    least = std::min(least, bodies.back().radius);
    const int first = atoms_[body][0];
    if (std::fabs(atom->x[first][2] - z) > 1e-9 * bodies.back().radius)
      refuse("atom " + std::to_string(atom->tag[first]) + " lies in another plane than atom " +
             std::to_string(atom->tag[0]) + ", expected one plane z = const");
  }
  settings.instructions = instructions_;
  settings.min_skin = min_skin_ > 0.0 ? min_skin_ : 0.06 * least;
  settings.max_skin = max_skin_ > 0.0 ? max_skin_ : 0.6 * least;
  try {
    scene_.reset(new rodpack::PlanarScene(settings, bodies));
    scene_->set_contacts(contacts_.read(places_));
  } catch (const std::invalid_argument& reason) {
    error->one(FLERR, (std::string("run_style verlet/planar: ") + reason.what()).c_str());
  }
}

void RunPlanar::give_back() {
  for (int body = 0; body < bodies_->n_body(); ++body)
    bodies_->from_planar(body, atoms_[body], scene_->body(body));
  bodies_->finish_planar();
  // The next step moves the spheres again, and then decides itself; but contacts of now have to
  // find their pairs in the list.
  const bigint dangerous = neighbor->ndanger;  // the list was not in use meanwhile
  if (!neighbor->dist_check || neighbor->check_distance()) {
    contacts_.renew_wall_lists();
    neighbor->build();
  }
  neighbor->ndanger = dangerous;
  contacts_.write(scene_->contacts(), atoms_);
  scene_.reset();
}

}  // namespace LAMMPS_NS
