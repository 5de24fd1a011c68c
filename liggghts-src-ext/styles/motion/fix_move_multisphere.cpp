// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_move_multisphere.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "fix_multisphere_ab.h"
#include "force.h"
#include "gather.h"
#include "group.h"
#include "multisphere_fix.h"
#include "pair_gran.h"
#include "rodpack/geometry/vector3.h"
#include "stop_run.h"
#include "style_arguments.h"
#include "update.h"

namespace LAMMPS_NS {

namespace {

struct PairGranAccess : PairGran {
  /// Groups whose spheres count as infinitely heavy in a contact, as those of fix freeze do.
  static int& frozen_groups(PairGran& pair) { return pair.*(&PairGranAccess::freeze_group_bit_); }
};

}  // namespace

FixMoveMultisphere::FixMoveMultisphere(LAMMPS* lmp, int narg, char** arg)
    : Fix(lmp, narg, arg), time_before_(0.0), dt_(0.0), step_(0) {
  StyleArguments arguments(lmp, narg, arg);
  while (arguments.more()) {
    const std::string keyword = arguments.new_keyword();
    if (keyword == "velocity")
      arguments.vector(keyword, "velocities (m/s) in [-1e15, 1e15]", motion_.velocity);
    else if (keyword == "omega")
      arguments.vector(keyword, "angular velocities (rad/s) in [-1e15, 1e15]",
                       motion_.angular_velocity);
    else if (keyword == "origin")
      arguments.vector(keyword, "positions (m) in [-1e15, 1e15]", motion_.origin);
    else if (keyword == "amplitude")
      arguments.vector(keyword, "lengths (m) in [-1e15, 1e15]", motion_.amplitude);
    else if (keyword == "period")
      motion_.period = arguments.number(keyword, "a time (s) in (0, 1e15]");
    else
      arguments.reject_keyword(keyword, "velocity, omega, origin, amplitude or period");
  }
  motion_.about_origin = arguments.given("origin");
  if (arguments.given("amplitude")) arguments.require({"period"});
  if (arguments.given("period")) arguments.require({"amplitude"});

  vector_flag = 1;
  size_vector = 6;
  global_freq = 1;
  extvector = 1;
  restart_global = 1;
  time_depend = 1;
  step_ = update->ntimestep;
  dt_ = update->dt;
}

FixMoveMultisphere::~FixMoveMultisphere() {
  FixMultisphereAB* const multisphere = dynamic_cast<FixMultisphereAB*>(multisphere_fix(modify));
  if (multisphere) multisphere->set_free(this);
}

void FixMoveMultisphere::init() {
  if (!dynamic_cast<FixMultisphereAB*>(multisphere_fix(modify)))
    stop_run(lmp, *this, "moves bodies of fix multisphere/ab, expected one");
  PairGran* const pair = dynamic_cast<PairGran*>(force->pair_match("gran", 0));
  if (pair) PairGranAccess::frozen_groups(*pair) |= groupbit;
}

double FixMoveMultisphere::time() const {
  return time_before_ + static_cast<double>(update->ntimestep - step_) * dt_;
}

void FixMoveMultisphere::follow_timestep() {
  if (update->dt == dt_) return;
  time_before_ = time();
  step_ = update->ntimestep;
  dt_ = update->dt;
}

void FixMoveMultisphere::reset_dt() { follow_timestep(); }

void FixMoveMultisphere::take_bodies() {
  follow_timestep();
  std::map<int, Start> present = bodies_of_group();
  for (auto& body : present) {
    const auto known = bodies_.find(body.first);
    if (known != bodies_.end()) body.second = known->second;
  }
  bodies_.swap(present);
}

/// The bodies whose spheres are in the group, as they are now; collective.
std::map<int, FixMoveMultisphere::Start> FixMoveMultisphere::bodies_of_group() const {
  FixMultisphere& multisphere = *multisphere_fix(modify);
  const std::string name = std::string("group ") + group->names[igroup];
  std::vector<int> tags;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!(atom->mask[i] & groupbit)) continue;
    tags.push_back(multisphere.belongs_to(i));
    if (tags.back() < 0)
      stop_run_from_one_rank(lmp, *this,
                             name + " has sphere " + std::to_string(atom->tag[i]) +
                                 " of no body, expected spheres of bodies alone");
  }
  std::map<int, int> spheres;
  for (int tag : gather_on_all(world, tags)) ++spheres[tag];
  if (spheres.empty())
    stop_run(lmp, *this,
             name +
                 " has no spheres, expected those of bodies that are there ('run 1' inserts "
                 "bodies without moving them)");

  struct Present {
    int tag, spheres;
    Start start;
  };
  Multisphere& bodies = multisphere.data();
  ScalarContainer<int>& images =
      *bodies.prop().getElementProperty<ScalarContainer<int> >("imagebody");
  std::vector<Present> own;
  for (int body = 0; body < bodies.n_body(); ++body) {
    if (spheres.count(bodies.tag(body)) == 0) continue;
    Present present = {bodies.tag(body), bodies.nrigid(body), {{}, time(), images(body)}};
    bodies.xcm(present.start.pose.position, body);
    bodies.quat(present.start.pose.quaternion, body);
    own.push_back(present);
  }
  std::map<int, Start> result;
  for (const Present& body : gather_on_all(world, own)) {
    if (spheres[body.tag] != body.spheres)
      stop_run(lmp, *this,
               name + " has " + std::to_string(spheres[body.tag]) + " of the " +
                   std::to_string(body.spheres) + " spheres of body " + std::to_string(body.tag) +
                   ", expected all of them or none");
    result[body.tag] = body.start;
  }
  return result;
}

void FixMoveMultisphere::refuse_newcomers() const {
  const FixMultisphere& multisphere = *multisphere_fix(modify);
  for (int i = 0; i < atom->nlocal; ++i)
    if ((atom->mask[i] & groupbit) && !moves(multisphere.belongs_to(i)))
      stop_run_from_one_rank(lmp, *this,
                             "sphere " + std::to_string(atom->tag[i]) + " has come into group " +
                                 group->names[igroup] +
                                 " during the run, expected all of its bodies before");
}

rodpack::PrescribedState FixMoveMultisphere::state(int tag, tagint image) const {
  const Start& start = bodies_.find(tag)->second;
  rodpack::PrescribedState now = motion_.at(start.pose, start.time, time());
  // The closed form goes on in the periodic image in which the body began.
  const int shift[3] = {0, IMGBITS, IMG2BITS};
  const double period[3] = {domain->xprd, domain->yprd, domain->zprd};
  for (int d = 0; d < 3; ++d) {
    const tagint passed = ((image >> shift[d]) & IMGMASK) - ((start.image >> shift[d]) & IMGMASK);
    if (passed != 0) now.pose.position[d] -= static_cast<double>(passed) * period[d];
  }
  return now;
}

double FixMoveMultisphere::compute_vector(int n) {
  const double own = own_component(n);
  double all = 0.0;
  MPI_Allreduce(&own, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

/// A component of force or torque on the spheres of this rank.
double FixMoveMultisphere::own_component(int n) const {
  const FixMultisphere& multisphere = *multisphere_fix(modify);
  double sum = 0.0, pivot[3];
  motion_.pivot(time(), pivot);
  for (int i = 0; i < atom->nlocal; ++i) {
    const int tag = atom->mask[i] & groupbit ? multisphere.belongs_to(i) : -1;
    if (!moves(tag)) continue;
    const double* const force = atom->f[i];
    if (n < 3) {
      sum += force[n];
      continue;
    }
    const rodpack::BodyPose body = state(tag, bodies_.find(tag)->second.image).pose;
    double lever[3], moment[3];
    for (int d = 0; d < 3; ++d) lever[d] = atom->x[i][d] - body.position[d];
    domain->minimum_image(lever);
    if (motion_.about_origin)
      for (int d = 0; d < 3; ++d) lever[d] += body.position[d] - pivot[d];
    rodpack::cross(lever, force, moment);
    sum += moment[n - 3] + atom->torque[i][n - 3];
  }
  return sum;
}

/// The motion as restart files have it.
std::vector<double> FixMoveMultisphere::parameters() const {
  std::vector<double> list = {motion_.period, static_cast<double>(motion_.about_origin)};
  for (const double* of :
       {motion_.velocity, motion_.angular_velocity, motion_.amplitude, motion_.origin})
    list.insert(list.end(), of, of + 3);
  return list;
}

void FixMoveMultisphere::write_restart(FILE* file) {
  if (comm->me != 0) return;
  std::vector<double> list = parameters();
  list.insert(list.end(),
              {time_before_, dt_, static_cast<double>(step_),
               static_cast<double>(update->ntimestep), static_cast<double>(bodies_.size())});
  for (const auto& body : bodies_) {
    const Start& start = body.second;
    list.insert(list.end(),
                {static_cast<double>(body.first), start.time, static_cast<double>(start.image)});
    list.insert(list.end(), start.pose.position, start.pose.position + 3);
    list.insert(list.end(), start.pose.quaternion, start.pose.quaternion + 4);
  }
  const int bytes = static_cast<int>(list.size() * sizeof(double));
  std::fwrite(&bytes, sizeof bytes, 1, file);
  std::fwrite(list.data(), sizeof(double), list.size(), file);
}

/// Goes on with the motion of the file. Another motion begins anew, where the bodies are then.
void FixMoveMultisphere::restart(char* buf) {
  const double* from = reinterpret_cast<const double*>(buf);
  const std::vector<double> mine = parameters();
  if (!std::equal(mine.begin(), mine.end(), from)) return;
  from += mine.size();
  time_before_ = *from++;
  dt_ = *from++;
  step_ = static_cast<bigint>(*from++);
  // The steps may have been counted anew (reset_timestep).
  step_ += update->ntimestep - static_cast<bigint>(*from++);
  const int count = static_cast<int>(*from++);
  for (int k = 0; k < count; ++k) {
    const int tag = static_cast<int>(*from++);
    Start& start = bodies_[tag];
    start.time = *from++;
    start.image = static_cast<tagint>(*from++);
    std::copy(from, from + 3, start.pose.position);
    std::copy(from + 3, from + 7, start.pose.quaternion);
    from += 7;
  }
}

}  // namespace LAMMPS_NS
