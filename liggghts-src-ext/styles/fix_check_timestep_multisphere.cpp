// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_check_timestep_multisphere.h"

#include <mpi.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix_multisphere.h"
#include "fix_property_global.h"
#include "fix_template_sphere.h"
#include "modify.h"
#include "particle_identity.h"
#include "rodpack/body_stiffness.h"
#include "rodpack/contact_law.h"
#include "style_arguments.h"
#include "update.h"

namespace LAMMPS_NS {

using rodpack::BodyInertia;
using rodpack::BodyStiffness;
using rodpack::MotionBounds;

namespace {

std::string text_of(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.4g", value);
  return buffer;
}

/// Sums over the contacts of each particle, by id, in one array that ranks can add up. Stiffness
/// and damping of a contact enter per effective mass: see add_contacts_present().
class ContactSums {
 public:
  explicit ContactSums(int largest_id)
      : values_(static_cast<std::size_t>(largest_id + 1) * stride, 0.0) {}

  void add(int id, const BodyStiffness& contact) {
    double* const sums = &values_[static_cast<std::size_t>(id) * stride];
    for (int k = 0; k < BodyStiffness::size; ++k) {
      sums[k] += contact.stiffness[k];
      sums[BodyStiffness::size + k] += contact.damping[k];
    }
    sums[stride - 1] += 1.0;
  }

  void add_up_over_ranks(MPI_Comm world) {
    MPI_Allreduce(MPI_IN_PLACE, values_.data(), static_cast<int>(values_.size()), MPI_DOUBLE,
                  MPI_SUM, world);
  }

  int contacts(int id) const {
    return static_cast<int>(values_[static_cast<std::size_t>(id + 1) * stride - 1]);
  }

  BodyStiffness of(int id, double mass) const {
    const double* const sums = &values_[static_cast<std::size_t>(id) * stride];
    BodyStiffness result;
    for (int k = 0; k < BodyStiffness::size; ++k) {
      result.stiffness[k] = mass * sums[k];
      result.damping[k] = mass * sums[BodyStiffness::size + k];
    }
    return result;
  }

 private:
  static constexpr std::size_t stride = 2 * BodyStiffness::size + 1;
  std::vector<double> values_;
};

}  // namespace

FixCheckTimestepMultisphere::FixCheckTimestepMultisphere(LAMMPS* lmp, int narg, char** arg)
    : Fix(lmp, narg, arg),
      options_(lmp),
      recorder_(lmp),
      warn_(0.8),
      error_(true),
      warned_(0.0),
      order_(0),
      fraction_(0.0),
      steps_per_collision_(0.0),
      contacts_(0) {
  StyleArguments arguments(lmp, narg, arg);
  if (igroup != 0) arguments.fail("looks at all contacts: the group has to be 'all'");
  nevery = arguments.integer("N", "a number of steps > 0", [](long n) { return n > 0; });
  while (arguments.more()) {
    const std::string keyword = arguments.word("", "");
    if (keyword == "warn")
      warn_ =
          arguments.number(keyword, "a fraction of the limit > 0", [](double f) { return f > 0; });
    else if (keyword == "error")
      error_ = arguments.yes_or_no(keyword);
    else if (keyword == "planar")
      options_.read(keyword, arguments);
    else
      arguments.fail("unknown keyword '" + keyword + "', expected warn, error or planar");
  }
  scalar_flag = vector_flag = 1;
  size_vector = 3;
  extscalar = extvector = 0;
  global_freq = nevery;
}

int FixCheckTimestepMultisphere::setmask() { return FixConst::END_OF_STEP; }

void FixCheckTimestepMultisphere::init() {
  recorder_.check_models(std::string("fix ") + style);
  order_ = running_order();
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

int FixCheckTimestepMultisphere::running_order() const {
  int order = 0;
  for (int k = 0; k < modify->nfix; ++k) {
    int dimension = 0;
    const int* found = static_cast<int*>(modify->fix[k]->extract("multistep_order", dimension));
    if (found) order = std::max(order, *found);
  }
  return order;
}

double FixCheckTimestepMultisphere::property(const char* name, int i, int j) const {
  const int types = atom->ntypes;
  Fix* fix = modify->find_fix_property(name, "property/global", "peratomtypepair", types, types,
                                       style, false);
  return fix ? static_cast<FixPropertyGlobal*>(fix)->compute_array(i - 1, j - 1) : 0.0;
}

/// Mass of the lightest particle; before there is any, of the lightest particle template; 0 if
/// there is none either.
double FixCheckTimestepMultisphere::lightest_mass() const {
  const double none = std::numeric_limits<double>::max();
  double lightest = none;
  // Each sphere of a body carries the body's mass.
  for (int i = 0; i < atom->nlocal; ++i) lightest = std::min(lightest, atom->rmass[i]);
  MPI_Allreduce(MPI_IN_PLACE, &lightest, 1, MPI_DOUBLE, MPI_MIN, world);
  if (lightest < none) return lightest;
  for (int k = 0; k < modify->n_fixes_style("particletemplate"); ++k) {
    Fix* fix = modify->find_fix_style("particletemplate", k);
    const double mass = static_cast<FixTemplateSphere*>(fix)->massexpect();
    if (mass > 0.0) lightest = std::min(lightest, mass);
  }
  return lightest < none ? lightest : 0.0;
}

/// A particle of this mass held by one contact through its centre, the stiffest there is among the
/// atom types; also sets the steps that a collision of two such particles takes.
MotionBounds FixCheckTimestepMultisphere::single_contact(double mass) {
  MotionBounds bounds = {0.0, 0.0, std::numeric_limits<double>::max(), 0.0};
  double duration = std::numeric_limits<double>::max();
  for (int i = 1; i <= atom->ntypes; ++i) {
    for (int j = i; j <= atom->ntypes; ++j) {
      const double kn = property("kn", i, j), eta = property("dampingRatioNormal", i, j);
      const double delay = rodpack::damping_coefficient(eta, mass, kn) / kn;
      bounds.stiffness = std::max(bounds.stiffness, kn / mass);
      bounds.damping = std::max(bounds.damping, delay * kn / mass);
      bounds.delay_min = std::min(bounds.delay_min, delay);
      bounds.delay_max = std::max(bounds.delay_max, delay);
      duration = std::min(duration, M_PI * std::sqrt(0.5 * mass / (kn * (1.0 - eta * eta))));
    }
  }
  steps_per_collision_ = duration / update->dt;
  return bounds;
}

/// Widens `bounds` to the motions of all particles with the contacts they have now.
///
/// For a contact between moving particles, (a - b)^2 <= (m_i/m_ij) a^2 + (m_j/m_ij) b^2 with the
/// effective mass m_ij: each side is taken as held by m/m_ij times the contact's stiffness (twice,
/// for equal particles), which bounds the whole network and is exact for two spheres that meet. At
/// a wall m_ij is the particle's mass.
FixCheckTimestepMultisphere::Stiffest FixCheckTimestepMultisphere::add_contacts_present(
    MotionBounds& bounds) {
  const ParticleIdentity particles(lmp);
  const std::vector<rodpack::Vector> centres = particles.all_body_centres();
  ContactSums sums(particles.largest_id());
  double delays[2] = {-bounds.delay_min, bounds.delay_max};  // largest of each
  for (const ContactRecord& record : recorder_.collect(std::string("fix ") + style)) {
    if (!record.primary) continue;
    const bool sticks =
        record.kt > 0.0 && property("coefficientFriction", record.type_i, record.type_j) > 0.0;
    const double share = 1.0 / record.effective_mass;
    const double kt = sticks ? record.kt : 0.0, damping_t = sticks ? record.damping_t : 0.0;
    const rodpack::Contact contact = particles.contact_of(record, centres);
    for (int side = 0; side < (contact.wall ? 1 : 2); ++side) {
      const rodpack::Vector& centre = side == 0 ? contact.centre_i : contact.centre_j;
      double arm[3];
      for (int d = 0; d < 3; ++d) arm[d] = contact.point[d] - centre[d];
      BodyStiffness one;
      one.add_contact(record.normal, arm, share * record.kn, share * kt, share * record.damping_n,
                      share * damping_t);
      sums.add(side == 0 ? contact.i : contact.j, one);
    }
    delays[0] = std::max(delays[0], -record.damping_n / record.kn);
    delays[1] = std::max(delays[1], record.damping_n / record.kn);
    if (!sticks) continue;
    delays[0] = std::max(delays[0], -damping_t / kt);
    delays[1] = std::max(delays[1], damping_t / kt);
  }
  sums.add_up_over_ranks(world);

  // stiffness and particle of the stiffest one here
  struct {
    double stiffness;
    int particle;
  } stiffest = {bounds.stiffness, 0};
  double damping = bounds.damping;
  const bool planar = options_.planar();
  const auto consider = [&](int id, const BodyInertia& inertia) {
    if (sums.contacts(id) == 0) return;
    const rodpack::StiffestMotion motion =
        rodpack::stiffest_motion(sums.of(id, inertia.mass), inertia);
    damping = std::max(damping, motion.damping);
    if (motion.stiffness > stiffest.stiffness) stiffest = {motion.stiffness, id};
  };

  if (FixMultisphere* fix = particles.bodies()) {
    Multisphere& bodies = fix->data();
    typedef VectorContainer<double, 3> Vectors;
    typedef VectorContainer<bool, 3> Flags;
    const auto vectors = [&bodies](const char* name, int body) {
      return (*bodies.prop().getElementProperty<Vectors>(name))(body);
    };
    const Flags& moves = *bodies.prop().getElementProperty<Flags>("fflag");
    const Flags& turns = *bodies.prop().getElementProperty<Flags>("tflag");
    const char* const axis_names[3] = {"ex_space", "ey_space", "ez_space"};
    for (int body = 0; body < fix->n_body(); ++body) {
      BodyInertia inertia = {};
      inertia.mass = bodies.mass(body);
      for (int k = 0; k < 3; ++k) {
        const double moment = vectors("inertia", body)[k];
        const double* const axis = vectors(axis_names[k], body);
        for (int a = 0; a < 3; ++a)
          for (int b = 0; b < 3; ++b) inertia.moments[a][b] += moment * axis[a] * axis[b];
        const bool in_plane = !planar || k < 2, about_normal = !planar || k == 2;
        inertia.is_free[k] = in_plane && moves(body)[k];
        inertia.is_free[3 + k] = about_normal && turns(body)[k];
      }
      consider(bodies.tag(body), inertia);
    }
  }
  int frozen = 0;
  for (int k = 0; k < modify->n_fixes_style("freeze"); ++k)
    frozen |= modify->find_fix_style("freeze", k)->groupbit;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (particles.body_of(i) >= 0 || (atom->mask[i] & frozen)) continue;
    BodyInertia inertia = {};
    inertia.mass = atom->rmass[i];
    for (int k = 0; k < 3; ++k) {
      inertia.moments[k][k] = 0.4 * inertia.mass * atom->radius[i] * atom->radius[i];
      inertia.is_free[k] = !planar || k < 2;
      inertia.is_free[3 + k] = !planar || k == 2;
    }
    consider(particles.id_of(i), inertia);
  }

  MPI_Allreduce(MPI_IN_PLACE, &stiffest, 1, MPI_DOUBLE_INT, MPI_MAXLOC, world);
  MPI_Allreduce(MPI_IN_PLACE, &damping, 1, MPI_DOUBLE, MPI_MAX, world);
  MPI_Allreduce(MPI_IN_PLACE, delays, 2, MPI_DOUBLE, MPI_MAX, world);
  bounds = {stiffest.stiffness, damping, -delays[0], delays[1]};
  return {stiffest.particle, stiffest.particle > 0 ? sums.contacts(stiffest.particle) : 0};
}

void FixCheckTimestepMultisphere::check() {
  const double mass = lightest_mass();
  if (!(mass > 0.0)) return;  // nothing is known yet
  MotionBounds bounds = single_contact(mass);
  Stiffest stiffest = {0, 0};
  std::string failure;
  double limit = 0.0;
  try {
    if (atom->natoms > 0) stiffest = add_contacts_present(bounds);
    limit = rodpack::timestep_limit(order_, bounds);
  } catch (const std::invalid_argument& e) {
    failure = e.what();
  }
  if (!failure.empty()) error->one(FLERR, ("fix " + std::string(style) + ": " + failure).c_str());
  fraction_ = limit > 0.0 ? update->dt / limit : std::numeric_limits<double>::infinity();
  contacts_ = stiffest.contacts;
  report(bounds, limit, stiffest);
}

void FixCheckTimestepMultisphere::report(const MotionBounds& bounds, double limit,
                                         const Stiffest& stiffest) {
  const bool beyond = fraction_ > 1.0;
  // once, and again when it has grown by a tenth
  if (!(beyond && error_) && !(fraction_ > warn_ && fraction_ > 1.1 * warned_)) return;
  const std::string method =
      order_ == 0 ? "velocity Verlet" : "Adams-Bashforth of order " + std::to_string(order_);
  const std::string particle = stiffest.particle == 0
                                   ? "a single contact of the lightest particle"
                                   : "body " + std::to_string(stiffest.particle) + " with its " +
                                         std::to_string(stiffest.contacts) + " contacts";
  std::string text =
      "Fix " + std::string(style) + " (id " + id + "): time step " + text_of(update->dt) + " s is ";
  text += limit > 0.0
              ? text_of(fraction_) + " of the stability limit " + text_of(limit) + " s of " + method
              : "unstable, as any is for " + method + " with undamped contacts (limit 0 s)";
  text += ", set by " + particle + " (angular frequency " + text_of(std::sqrt(bounds.stiffness)) +
          " 1/s)";
  if (beyond && error_) error->all(FLERR, (text + "; expected at most 1").c_str());
  warned_ = fraction_;
  if (comm->me == 0) error->warning(FLERR, text.c_str());
}

}  // namespace LAMMPS_NS
