// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_check_timestep_multisphere.h"

#include <mpi.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix_multisphere_ab.h"
#include "fix_property_global.h"
#include "fix_template_sphere.h"
#include "force.h"
#include "gather.h"
#include "modify.h"
#include "multisphere_fix.h"
#include "pair_gran.h"
#include "particle_identity.h"
#include "rodpack/contact/contact_law.h"
#include "rodpack/contact/dashpot_relaxation.h"
#include "rodpack/contact/power_law.h"
#include "rodpack/contact/rolling_spring.h"
#include "rodpack/motion/stability_limit.h"
#include "running_dashpots.h"
#include "stop_run.h"
#include "style_arguments.h"
#include "update.h"

namespace LAMMPS_NS {

using rodpack::NetworkBody;
using rodpack::NetworkContact;

namespace {

std::string text_of(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.4g", value);
  return buffer;
}

}  // namespace

FixCheckTimestepMultisphere::FixCheckTimestepMultisphere(LAMMPS* lmp, int narg, char** arg)
    : Fix(lmp, narg, arg),
      options_(lmp),
      recorder_(lmp, std::string("fix ") + style,
                [this](bigint step) { return step % nevery == 0; }),
      warn_(0.8),
      error_(true),
      warned_(0.0),
      order_(0),
      single_contact_(false),
      shortest_(0.0),
      fraction_(0.0),
      steps_per_collision_(0.0),
      contacts_(0) {
  StyleArguments arguments(lmp, narg, arg);
  arguments.require_group_all("looks at all contacts");
  nevery = arguments.integer("N", "a number of steps in [1, 2147483647]");
  while (arguments.more()) {
    const std::string keyword = arguments.new_keyword();
    if (keyword == "warn")
      warn_ = arguments.number(keyword, "a fraction of the limit in (0, 1e15]");
    else if (keyword == "error")
      error_ = arguments.yes_or_no(keyword);
    else if (keyword == "planar")
      options_.read(keyword, arguments);
    else
      arguments.reject_keyword(keyword, "warn, error or planar");
  }
  scalar_flag = vector_flag = 1;
  size_vector = 3;
  extscalar = extvector = 0;
  global_freq = 1;  // those of the last check
}

int FixCheckTimestepMultisphere::setmask() { return FixConst::END_OF_STEP; }

void FixCheckTimestepMultisphere::init() {
  recorder_.check_models();
  recorder_.check_springs();
  single_contact_ = static_cast<PairGran*>(force->pair_match("gran", 0))
                        ->contact_match("normal", "spring_dashpot");
  order_ = highest_running_order(lmp);
  relaxation_ = dashpot_relaxation(lmp);
}

void FixCheckTimestepMultisphere::setup(int) {
  warned_ = 0.0;
  check();
}

void FixCheckTimestepMultisphere::end_of_step() { check(); }

double FixCheckTimestepMultisphere::compute_vector(int n) {
  if (n == 0) return fraction_;
  return n == 1 ? steps_per_collision_ : contacts_;
}

/// The share of a dashpot that decides about stability.
double FixCheckTimestepMultisphere::dashpot_share() const {
  return rodpack::share_in_fastest_motion(relaxation_, update->dt);
}

double FixCheckTimestepMultisphere::property(const char* name, int i, int j) const {
  const int types = atom->ntypes;
  Fix* fix = modify->find_fix_property(name, "property/global", "peratomtypepair", types, types,
                                       style, false);
  return fix ? static_cast<FixPropertyGlobal*>(fix)->compute_array(i - 1, j - 1) : 0.0;
}

double FixCheckTimestepMultisphere::scalar_property(const char* name) const {
  Fix* fix = modify->find_fix_property(name, "property/global", "scalar", 0, 0, style, false);
  return fix ? static_cast<FixPropertyGlobal*>(fix)->compute_scalar() : 0.0;
}

/// The groups of the fixes of a style, as bits.
int FixCheckTimestepMultisphere::groups_of(const char* of_style) const {
  int groups = 0;
  for (int k = 0; k < modify->n_fixes_style(of_style); ++k)
    groups |= modify->find_fix_style(of_style, k)->groupbit;
  return groups;
}

/// Mass of the lightest particle whose motion is not prescribed; before there is any, of the
/// lightest particle template; 0 if there is none either.
double FixCheckTimestepMultisphere::lightest_mass() const {
  const double none = std::numeric_limits<double>::max();
  double lightest = none;
  // Each sphere of a body carries the body's mass.
  const int prescribed = groups_of("move/multisphere");
  for (int i = 0; i < atom->nlocal; ++i)
    if (!(atom->mask[i] & prescribed)) lightest = std::min(lightest, atom->rmass[i]);
  MPI_Allreduce(MPI_IN_PLACE, &lightest, 1, MPI_DOUBLE, MPI_MIN, world);
  if (lightest < none) return lightest;
  for (int k = 0; k < modify->n_fixes_style("particletemplate"); ++k) {
    Fix* fix = modify->find_fix_style("particletemplate", k);
    const double mass = static_cast<FixTemplateSphere*>(fix)->massexpect();
    if (mass > 0.0) lightest = std::min(lightest, mass);
  }
  return lightest < none ? lightest : 0.0;
}

/// A particle of this mass held by one contact through its centre, of the most demanding pair of
/// atom types; also sets the steps that a collision of two such particles takes.
FixCheckTimestepMultisphere::Limit FixCheckTimestepMultisphere::limit_of_single_contact(
    double mass) {
  Limit limit = {std::numeric_limits<double>::infinity(), 0.0, 0, 0};
  double duration = std::numeric_limits<double>::infinity();
  for (int i = 1; i <= atom->ntypes; ++i) {
    for (int j = i; j <= atom->ntypes; ++j) {
      const double kn = property("kn", i, j), eta = property("dampingRatioNormal", i, j);
      const double timestep =
          rodpack::stability_limit(order_, dashpot_share() * eta) / std::sqrt(kn / mass);
      if (timestep < limit.timestep) limit = {timestep, kn / mass, 0, 0};
      const double damping = rodpack::damping_coefficient(eta, 0.5 * mass, kn);
      duration = std::min(duration, rodpack::half_period(kn, damping, 0.5 * mass));
    }
  }
  steps_per_collision_ = duration / update->dt;
  return limit;
}

/// This rank's contacts, with the particles' ids for indices. Without friction there is nothing in
/// the plane of contact.
std::vector<NetworkContact> FixCheckTimestepMultisphere::contacts_here(
    const ParticleIdentity& particles) {
  const std::vector<rodpack::Vector> centres = particles.all_body_centres();
  std::vector<NetworkContact> result;
  for (const ContactRecord& record : recorder_.collect()) {
    if (!record.primary) continue;
    const bool sticks =
        record.kt > 0.0 && property("coefficientFriction", record.type_i, record.type_j) > 0.0;
    const rodpack::SphereContact contact = contact_of(record, particles, centres);
    if (contact.i == contact.j) continue;  // with its own periodic image
    NetworkContact one = {};
    one.i = static_cast<int>(contact.i);
    one.j = contact.wall ? -1 : static_cast<int>(contact.j);
    for (int d = 0; d < 3; ++d) {
      one.normal[d] = record.normal[d];
      one.arm_i[d] = contact.point[d] - contact.centre_i[d];
      one.arm_j[d] = contact.point[d] - contact.centre_j[d];
    }
    one.stiffness_n = rodpack::tangent_stiffness(record.kn, record.exponent);
    // It has only just touched, or is held by a liquid bridge.
    if (!(one.stiffness_n > 0.0)) continue;
    one.damping_n = dashpot_share() * record.damping_n;
    if (sticks) {
      one.stiffness_t = record.kt;
      one.damping_t = dashpot_share() * record.damping_t;
    }
    add_rolling(record, one);
    shortest_ = std::min(
        shortest_, rodpack::half_period(one.stiffness_n, record.damping_n, record.effective_mass));
    result.push_back(one);
  }
  return result;
}

void FixCheckTimestepMultisphere::add_rolling(const ContactRecord& record,
                                              NetworkContact& contact) const {
  if (record.rolling == rodpack::RollingLaw::none) return;
  const double ri = atom->radius[record.i];
  rodpack::RollingContact rolling = {};
  rolling.law = record.rolling;
  rolling.kn = record.kn;
  rolling.kt = record.kt;
  rolling.reduced_radius = ri;
  rolling.inertia = atom->rmass[record.i] * ri * ri;
  if (record.j >= 0) {
    const double rj = atom->radius[record.j];
    rolling.reduced_radius = ri * rj / (ri + rj);
    rolling.inertia = rodpack::effective_mass(rolling.inertia, atom->rmass[record.j] * rj * rj);
  }
  rolling.friction = property("coefficientRollingFriction", record.type_i, record.type_j);
  rolling.damping_ratio =
      property("coefficientRollingViscousDamping", record.type_i, record.type_j);
  rolling.factor = scalar_property("rollingStiffness");
  contact.stiffness_r = rodpack::rolling_stiffness(rolling);
  contact.damping_r = rodpack::rolling_damping(rolling);
}

/// This rank's particles: bodies, and plain spheres that belong to none.
std::vector<FixCheckTimestepMultisphere::IdentifiedBody> FixCheckTimestepMultisphere::bodies_here(
    const ParticleIdentity& particles) const {
  const bool planar = options_.planar();
  std::vector<IdentifiedBody> result;
  if (FixMultisphere* fix = particles.bodies()) {
    Multisphere& bodies = fix->data();
    typedef VectorContainer<double, 3> Vectors;
    typedef VectorContainer<bool, 3> Flags;
    Vectors& inertia = *bodies.prop().getElementProperty<Vectors>("inertia");
    Vectors* const axes[3] = {bodies.prop().getElementProperty<Vectors>("ex_space"),
                              bodies.prop().getElementProperty<Vectors>("ey_space"),
                              bodies.prop().getElementProperty<Vectors>("ez_space")};
    Flags& moves = *bodies.prop().getElementProperty<Flags>("fflag");
    Flags& turns = *bodies.prop().getElementProperty<Flags>("tflag");
    const ScalarContainer<int>* const prescribed = prescribed_motions(bodies);
    const auto* const scaled = dynamic_cast<const FixMultisphereAB*>(fix);
    for (int k = 0; k < fix->n_body(); ++k) {
      const bool is_held = prescribed && (*prescribed)(k) != 0;
      NetworkBody body = {};
      const double factor = scaled ? scaled->inertia_factor(k) : 1.0;
      body.mass = factor * bodies.mass(k);
      for (int d = 0; d < 3; ++d) {
        const double moment = factor * inertia(k)[d];
        const double* const axis = (*axes[d])(k);
        for (int a = 0; a < 3; ++a)
          for (int b = 0; b < 3; ++b) body.moments[a][b] += moment * axis[a] * axis[b];
        body.is_free[d] = !is_held && (!planar || d < 2) && moves(k)[d];
        body.is_free[3 + d] = !is_held && (!planar || d == 2) && turns(k)[d];
      }
      result.push_back({bodies.tag(k), body});
    }
  }
  const int frozen = groups_of("freeze");
  for (int i = 0; i < atom->nlocal; ++i) {
    if (particles.body_of(i) >= 0) continue;
    NetworkBody body = {};
    body.mass = atom->rmass[i];
    const bool is_held = atom->mask[i] & frozen;
    for (int d = 0; d < 3; ++d) {
      body.moments[d][d] = 0.4 * body.mass * atom->radius[i] * atom->radius[i];
      body.is_free[d] = !is_held && (!planar || d < 2);
      body.is_free[3 + d] = !is_held && (!planar || d == 2);
    }
    result.push_back({particles.id_of(i), body});
  }
  return result;
}

/// The limit of the particles with the contacts they have now. The whole network is looked at on
/// rank 0, so that the result is that of one rank.
FixCheckTimestepMultisphere::Limit FixCheckTimestepMultisphere::limit_of_contacts() {
  const ParticleIdentity particles(lmp);
  shortest_ = std::numeric_limits<double>::infinity();
  std::vector<NetworkContact> contacts = gather_on_first(world, contacts_here(particles));
  std::vector<IdentifiedBody> found = gather_on_first(world, bodies_here(particles));
  double result[4] = {0.0, 0.0, 0.0, 0.0};
  if (comm->me == 0) {
    std::sort(found.begin(), found.end(),
              [](const IdentifiedBody& a, const IdentifiedBody& b) { return a.id < b.id; });
    std::vector<NetworkBody> bodies;
    for (const IdentifiedBody& each : found) bodies.push_back(each.body);
    const auto index = [&found](int id) {
      const auto at =
          std::lower_bound(found.begin(), found.end(), id,
                           [](const IdentifiedBody& body, int wanted) { return body.id < wanted; });
      return static_cast<int>(at - found.begin());
    };
    for (NetworkContact& contact : contacts) {
      contact.i = index(contact.i);
      if (contact.j >= 0) contact.j = index(contact.j);
    }
    try {
      const rodpack::NetworkLimit limit = rodpack::network_limit(order_, bodies, contacts);
      result[0] = limit.timestep;
      result[1] = limit.stiffness;
      result[2] = limit.stiffest < 0 ? 0 : found[limit.stiffest].id;
      result[3] = limit.contacts;
    } catch (const std::invalid_argument& e) {
      stop_run_from_one_rank(lmp, *this, e.what());
    }
  }
  MPI_Bcast(result, 4, MPI_DOUBLE, 0, world);
  return {result[0], result[1], static_cast<int>(result[2]), static_cast<int>(result[3])};
}

void FixCheckTimestepMultisphere::check() {
  const double mass = lightest_mass();
  if (!(mass > 0.0)) return;  // nothing is known yet
  Limit limit = {std::numeric_limits<double>::infinity(), 0.0, 0, 0};
  if (single_contact_) limit = limit_of_single_contact(mass);
  if (atom->natoms > 0) {
    const Limit present = limit_of_contacts();
    if (present.timestep <= limit.timestep) limit = present;
    MPI_Allreduce(MPI_IN_PLACE, &shortest_, 1, MPI_DOUBLE, MPI_MIN, world);
    if (!single_contact_)
      steps_per_collision_ = std::isfinite(shortest_) ? shortest_ / update->dt : 0.0;
  }
  const double none = std::numeric_limits<double>::infinity();
  fraction_ = limit.timestep > 0.0 ? update->dt / limit.timestep : none;
  contacts_ = limit.contacts;
  report(limit);
}

void FixCheckTimestepMultisphere::report(const Limit& limit) {
  const bool beyond = fraction_ > 1.0;
  // A warning comes once, and again when the fraction has grown by a tenth.
  if (!(beyond && error_) && !(fraction_ > warn_ && fraction_ > 1.1 * warned_)) return;
  const std::string method =
      order_ == 0 ? "velocity Verlet" : "Adams-Bashforth of order " + std::to_string(order_);
  const std::string particle = limit.particle == 0
                                   ? "a single contact of the lightest particle"
                                   : "body " + std::to_string(limit.particle) + " with its " +
                                         std::to_string(limit.contacts) + " contacts";
  std::string text = name_of(*this) + ": time step " + text_of(update->dt) + " s is ";
  text += limit.timestep > 0.0
              ? text_of(fraction_) + " of the stability limit " + text_of(limit.timestep) +
                    " s of " + method
              : "unstable, as any is for " + method + " with undamped contacts (limit 0 s)";
  text += ", set by " + particle + " (angular frequency " + text_of(std::sqrt(limit.stiffness)) +
          " 1/s)";
  if (beyond && error_) stop_run(lmp, text + "; expected at most 1");
  warned_ = fraction_;
  if (comm->me == 0) error->warning(FLERR, text.c_str());
}

}  // namespace LAMMPS_NS
