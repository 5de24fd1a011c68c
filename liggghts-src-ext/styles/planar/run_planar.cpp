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
#include <utility>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "fix.h"
#include "fix_gravity.h"
#include "fix_multisphere_ab.h"
#include "multisphere.h"
#include "force.h"
#include "modify.h"
#include "neighbor.h"
#include "output.h"
#include "rodpack/geometry/order_by_place.h"
#include "rodpack/planar/scene.h"
#include "signal_handling.h"
#include "stop_run.h"
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
  const std::string line = std::string("run_style verlet/planar: processor instructions ") +
                           rodpack::name_of(rodpack::chosen(instructions_)) + "\n";
  for (FILE* out : {screen, logfile})
    if (out) std::fputs(line.c_str(), out);
}

void RunPlanar::read_options(int narg, char** arg) {
  StyleArguments arguments(lmp, "run_style verlet/planar", narg, arg, 0);
  while (arguments.more()) {
    const std::string keyword = arguments.word("", "a keyword");
    if (keyword == "skin" && arguments.left() >= 2) {
      const std::string expected = "0 < least <= largest (m)";
      const std::string both = arguments.peek() + " " + arguments.peek(1);
      min_skin_ = arguments.number(keyword, expected);
      max_skin_ = arguments.number(keyword, expected);
      if (!(min_skin_ > 0.0) || max_skin_ < min_skin_) arguments.reject(keyword, expected, both);
    } else if (keyword == "instructions" && arguments.more()) {
      try {
        instructions_ = rodpack::planar_instructions(arguments.word(keyword, "their name"));
      } catch (const std::invalid_argument& reason) {
        arguments.fail(reason.what());
      }
    } else {
      arguments.fail("unknown keyword or missing value at '" + keyword +
                     "', expected skin and two lengths, or instructions and their name");
    }
  }
}

RunPlanar::~RunPlanar() = default;

void RunPlanar::refuse(const std::string& what) const {
  stop_run(lmp, "run_style verlet/planar: " + what);
}

void RunPlanar::setup() {
  check();
  Verlet::setup();
}

void RunPlanar::setup_minimal(int flag) {
  check();
  Verlet::setup_minimal(flag);
}

/// As refuse(), where the other ranks do not know of it.
void RunPlanar::refuse_one(const std::string& what) const {
  stop_run_from_one_rank(lmp, "run_style verlet/planar: " + what);
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
    refuse("periodic boundaries are not supported, expected 'boundary f f f'");
  if (domain->triclinic) refuse("a triclinic box is not supported");
  if (atom->molecular || force->kspace) refuse("bonds and long-range forces are not supported");
  if (NeighborAccess::leaves_out(neighbor))
    refuse("neigh_modify exclude or include leaves pairs out, expected neither");
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

bigint RunPlanar::next_observed_step() const {
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
  if (!ranks_) refuse("'run ... pre no' before a run with 'pre yes'");
  if (!bodies_->planar())
    refuse("fix multisphere/ab moves in space, expected 'planar yes' or a fix enforce2d");
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
      run_engine(unobserved);
      if (anywhere(quits())) return;
      of_liggghts = 1;  // the observed step, or that in which bodies change their rank
    }
    Verlet::run(static_cast<int>(of_liggghts));
    if (anywhere(quits())) return;
  }
}

void RunPlanar::run_engine(bigint steps) {
  timer->stamp();
  take_over();
  const bigint chunk = 1000;  // steps between two checks for an interrupt
  bigint done = 0;
  try {
    while (done < steps &&
           !anywhere(SignalHandler::request_quit || SignalHandler::request_write_restart)) {
      const bigint wanted = std::min(chunk, steps - done);
      const bigint made = scene_->run(static_cast<long>(wanted));
      done += made;
      if (made < wanted) break;
    }
  } catch (const std::runtime_error& reason) {
    refuse_one(reason.what());
  }
  update->ntimestep += done;
  const rodpack::PlanarScene::Statistics made = scene_->statistics();
  done_.steps += made.steps;
  done_.listings += made.listings;
  done_.ghosts += made.ghosts;
  done_.sent += made.sent;
  timer->stamp(TIME_PAIR);
  give_back();
  timer->stamp(TIME_COMM);
}

/// Finds the bodies of this rank, in an order that follows from their positions and tags, so that a
/// restart keeps it, and the atoms of each.
void RunPlanar::find_bodies() {
  owners_.renew(*bodies_);
  const int bodies = bodies_->n_body();
  const auto tag_of = [&](int body) { return bodies_->data().tag(body); };
  std::vector<rodpack::TaggedPlace> places;
  double reach = 0.0;
  for (int body = 0; body < bodies; ++body) {
    double x[3];
    bodies_->data().xcm(x, body);
    places.push_back({x[0], x[1], tag_of(body)});
    reach = std::max(reach, bodies_->data().r_bound(body));
  }
  // Bodies next to other ranks come last, since they wait for messages.
  order_ = rodpack::order_by_place(places, 2.0 * reach, comm->nprocs > 1);
  std::vector<int> place(bodies);
  for (int k = 0; k < bodies; ++k) place[order_[k]] = k;
  atoms_.assign(bodies, std::vector<int>());
  for (int i = 0; i < atom->nlocal + atom->nghost; ++i) {
    const int tag = bodies_->belongs_to(i), body = tag < 0 ? -1 : bodies_->data().map(tag);
    if (body >= 0)
      atoms_[place[body]].push_back(i);
    else if (i < atom->nlocal && (tag < 0 || owners_.of_body(i) < 0 || comm->nprocs == 1))
      refuse_one("atom " + std::to_string(atom->tag[i]) +
                 " belongs to no body of fix multisphere/ab");
  }
  for (int k = 0; k < bodies; ++k) {
    std::sort(atoms_[k].begin(), atoms_[k].end(),
              [&](int i, int j) { return atom->tag[i] < atom->tag[j]; });
    const int expected = bodies_->data().nrigid(order_[k]);
    if (static_cast<int>(atoms_[k].size()) != expected)
      refuse_one("body " + std::to_string(tag_of(order_[k])) + " has " +
                 std::to_string(atoms_[k].size()) + " spheres on its rank, expected " +
                 std::to_string(expected));
  }
}

std::vector<rodpack::PlanarBody> RunPlanar::take_bodies() {
  std::vector<rodpack::PlanarBody> bodies;
  double z[2] = {-1e300, -1e300};  // of the highest sphere, and the lowest times -1
  for (size_t k = 0; k < order_.size(); ++k) {
    const int first = atoms_[k][0];
    bodies.push_back(bodies_->to_planar(order_[k], atoms_[k]));
    bodies.back().type = atom->type[first] - 1;
    z[0] = std::max(z[0], atom->x[first][2]);
    z[1] = std::max(z[1], -atom->x[first][2]);
  }
  ranks_->largest(z, 2);
  for (size_t k = 0; k < order_.size(); ++k) {
    if (z[0] + z[1] <= 1e-9 * bodies[k].radius) continue;
    char planes[128];
    std::snprintf(planes, sizeof planes, "spheres lie in planes from z = %g to %g m", -z[1], z[0]);
    refuse_one(std::string(planes) + ", expected one plane z = const");
  }
  return bodies;
}

rodpack::PlanarSettings RunPlanar::settings(const std::vector<rodpack::PlanarBody>& bodies) const {
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
  // The smallest radius and the narrowest sub-box, times -1, and the largest radius.
  double largest[4] = {-1e300, -(domain->subhi[0] - domain->sublo[0]),
                       -(domain->subhi[1] - domain->sublo[1]), 0.0};
  for (const rodpack::PlanarBody& body : bodies) {
    largest[0] = std::max(largest[0], -body.radius);
    largest[3] = std::max(largest[3], body.radius);
  }
  ranks_->largest(largest, 4);
  settings.instructions = instructions_;
  // So that a pair that parts is listed for as long as LIGGGHTS's models are told of it.
  const double least = (settings.close_factor - 1.0) * largest[3];
  if (min_skin_ > 0.0 && min_skin_ < least) {
    char text[160];
    std::snprintf(
        text, sizeof text,
        "skin is at least %g m, expected %g m or more: the contact distance factor less 1 "
        "times the largest radius",
        min_skin_, least);
    refuse(text);
  }
  settings.min_skin = min_skin_ > 0.0 ? min_skin_ : std::max(-0.06 * largest[0], least);
  settings.max_skin = max_skin_ > 0.0 ? max_skin_ : std::max(-0.6 * largest[0], settings.min_skin);
  // LIGGGHTS passes atoms and bodies on to the next rank, not beyond it; they may have gone half
  // its skin before.
  for (int axis = 0; axis < 2; ++axis)
    if (comm->procgrid[axis] > 1) settings.farthest[axis] = -largest[1 + axis] - neighbor->skin;
  return settings;
}

/// The contacts of the bodies of this rank, whichever rank's lists LIGGGHTS has them in.
std::vector<rodpack::PlanarContactState> RunPlanar::take_contacts() {
  std::vector<PlanarContactRecord> records = contacts_.read(owners_);
  struct TaggedSphere {
    int tag, body, sphere;
  };
  const auto before = [](const TaggedSphere& a, const TaggedSphere& b) { return a.tag < b.tag; };
  std::vector<TaggedSphere> first, all;  // the first sphere of each body; all spheres
  for (int body = 0; body < scene_->size_with_ghosts(); ++body)
    if (scene_->spheres(body) > 0) first.push_back({scene_->sphere_tag(body, 0), body, 0});
  std::sort(first.begin(), first.end(), before);
  all.reserve(first.empty() ? 0 : first.size() * scene_->spheres(first[0].body));
  for (const TaggedSphere& at : first)
    for (int sphere = 0; sphere < scene_->spheres(at.body); ++sphere)
      all.push_back({scene_->sphere_tag(at.body, sphere), at.body, sphere});
  if (!std::is_sorted(all.begin(), all.end(), before)) std::sort(all.begin(), all.end(), before);
  const auto sphere_of = [&](int tag) -> const TaggedSphere& {
    const auto found = std::lower_bound(all.begin(), all.end(), TaggedSphere{tag, 0, 0}, before);
    if (found == all.end() || found->tag != tag)
      refuse_one("a contact of atom " + std::to_string(tag) +
                 " is on a rank that does not know it");
    return *found;
  };
  std::vector<rodpack::PlanarContactState> contacts;
  contacts.reserve(records.size());
  for (const PlanarContactRecord& record : records) {
    contacts.push_back(record.state);
    rodpack::PlanarContactState& contact = contacts.back();
    const TaggedSphere& i = sphere_of(record.atom);
    contact.body_i = i.body;
    contact.sphere_i = i.sphere;
    contact.body_j = record.partner;
    contact.sphere_j = 0;
    if (record.partner < 0) continue;
    const TaggedSphere& j = sphere_of(record.partner);
    contact.body_j = j.body;
    contact.sphere_j = j.sphere;
  }
  return contacts;
}

void RunPlanar::take_over() {
  find_bodies();
  try {
    {
      const std::vector<rodpack::PlanarBody> bodies = take_bodies();
      scene_.reset(new rodpack::PlanarScene(settings(bodies), bodies, ranks_.get()));
    }
    scene_->set_contacts(take_contacts());
  } catch (const std::invalid_argument& reason) {
    refuse_one(reason.what());
  }
}

/// The contacts of the atoms of this rank, each as its atom sees it.
std::vector<PlanarContactRecord> RunPlanar::contacts_of_atoms() const {
  std::vector<std::vector<PlanarContactRecord> > records(comm->nprocs);
  const std::vector<rodpack::PlanarContactState> contacts = scene_->contacts();
  records[comm->me].reserve(2 * contacts.size());
  for (const rodpack::PlanarContactState& contact : contacts) {
    const auto send = [&](int body, int sphere, int partner, double sign) {
      if (body >= scene_->size()) return;  // a ghost: its own rank sends it
      const int i = atoms_[body][sphere];
      records[owners_.of_atom(i)].push_back(
          {atom->tag[i], partner, {sign * contact.normal[0], sign * contact.normal[1]}, contact});
    };
    const bool wall = contact.body_j < 0;
    send(contact.body_i, contact.sphere_i,
         wall ? contact.body_j : scene_->sphere_tag(contact.body_j, contact.sphere_j), 1.0);
    if (wall) continue;
    send(contact.body_j, contact.sphere_j, scene_->sphere_tag(contact.body_i, contact.sphere_i),
         -1.0);
  }
  return exchange_records(world, std::move(records));
}

/// Exchanges atoms and builds new lists, as a step of Verlet does between pre_exchange() of the
/// fixes and the forces.
void RunPlanar::exchange_and_list() {
  domain->pbc();
  if (domain->box_change) {
    domain->reset_box();
    comm->setup();
    if (neighbor->style) neighbor->setup_bins();
  }
  comm->exchange();
  comm->borders();
  modify->pre_neighbor();
  neighbor->build();
}

void RunPlanar::give_back() {
  bodies_->begin_planar();
  for (size_t k = 0; k < order_.size(); ++k)
    bodies_->from_planar(order_[k], atoms_[k], scene_->body(static_cast<int>(k)));
  bodies_->finish_planar();
  const std::vector<PlanarContactRecord> contacts = contacts_of_atoms();
  scene_.reset();
  // The next step moves the spheres again, and then decides itself; but contacts of now have to
  // find their pairs in the list.
  const bigint dangerous = neighbor->ndanger;  // the list was not in use meanwhile
  if (!neighbor->dist_check || neighbor->check_distance()) {
    bodies_->keep_loads();
    modify->pre_exchange();
    contacts_.write_to_atoms(contacts);
    exchange_and_list();
    bodies_->restore_loads();
  } else {
    contacts_.write_to_lists(contacts);
  }
  neighbor->ndanger = dangerous;
}

}  // namespace LAMMPS_NS
