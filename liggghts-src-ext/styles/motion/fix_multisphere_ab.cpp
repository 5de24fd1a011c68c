// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_multisphere_ab.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "math_extra.h"
#include "modify.h"
#include "neighbor.h"
#include "planar_owners.h"
#include "rodpack/motion/rigid_motion.h"
#include "stop_run.h"
#include "style_arguments.h"
#include "update.h"

using namespace LAMMPS_NS;
using rodpack::PlanarMotion;
using rodpack::PlanarRates;
using rodpack::SpatialMotion;
using rodpack::SpatialRates;

namespace {

static_assert(sizeof(PlanarRates) == 6 * sizeof(double), "size of FixMultisphereAB::PlanarRecord");
static_assert(sizeof(SpatialRates) == 13 * sizeof(double),
              "size of FixMultisphereAB::SpatialRecord");

template <class Container>
Container& property(Multisphere& bodies, const char* name) {
  return *bodies.prop().getElementProperty<Container>(name);
}

}  // namespace

FixMultisphereAB::FixMultisphereAB(LAMMPS* lmp, int narg, char** arg)
    : FixMultisphere(lmp, 3, arg),  // whose own keywords parse() reads, with clear errors
      options_(lmp, true),
      mass_(property<ScalarContainer<double> >(multisphere_, "masstotal")),
      xcm_(property<Vectors>(multisphere_, "xcm")),
      vcm_(property<Vectors>(multisphere_, "vcm")),
      fcm_(property<Vectors>(multisphere_, "fcm")),
      torque_(property<Vectors>(multisphere_, "torque")),
      angmom_(property<Vectors>(multisphere_, "angmom")),
      omega_(property<Vectors>(multisphere_, "omega")),
      inertia_(property<Vectors>(multisphere_, "inertia")),
      ex_(property<Vectors>(multisphere_, "ex_space")),
      ey_(property<Vectors>(multisphere_, "ey_space")),
      ez_(property<Vectors>(multisphere_, "ez_space")),
      quat_(property<VectorContainer<double, 4> >(multisphere_, "quat")),
      fflag_(property<VectorContainer<bool, 3> >(multisphere_, "fflag")),
      tflag_(property<VectorContainer<bool, 3> >(multisphere_, "tflag")),
      image_(property<ScalarContainer<int> >(multisphere_, "imagebody")) {
  if (modify->n_fixes_style("multisphere") > 0)
    stop_run(lmp, *this, "only one fix multisphere can hold the bodies, and there is one already");
  parse(narg, arg);
  order_ = options_.order();
  planar_ = options_.planar();

  // Bodies of the built-in fix can be taken over from its restart files.
  delete[] accepts_restart_data_from_style;
  accepts_restart_data_from_style = new char[sizeof("multisphere")];
  strcpy(accepts_restart_data_from_style, "multisphere");

  add_history();
}

void FixMultisphereAB::parse(int narg, char** arg) {
  StyleArguments arguments(lmp, narg, arg);
  // Of the spheres of another group the base class makes no bodies: it deletes them without a word.
  arguments.require_group_all("moves every body");
  bool events = true;
  while (arguments.more()) {
    const std::string keyword = arguments.new_keyword();
    if (keyword == "allow_group_and_set")
      allow_group_and_set_ = arguments.yes_or_no(keyword);
    else if (keyword == "allow_heatsource")
      allow_heatsource_ = arguments.yes_or_no(keyword);
    else if (keyword == "events")
      events = arguments.yes_or_no(keyword);
    else if (keyword == "mass_scaling")
      mass_scaling_ = arguments.number(keyword, "a ratio of frequencies in [1, 1000]");
    else if (!options_.read(keyword, arguments))
      arguments.reject_keyword(
          keyword, "order, planar, events, mass_scaling, allow_group_and_set or allow_heatsource");
  }
  // Leapfrog shows no velocities of the time of its forces, first order has nothing to lose.
  if (events && options_.order() > 1) events_.reset(new ContactEvents(lmp, this));
  if (mass_scaling_ > 0.0) counts_.reset(new ContactCounts(lmp));
}

void FixMultisphereAB::post_create() {
  FixMultisphere::post_create();
  PlanarOwners::create_property(lmp, style);
  if (counts_) counts_->create_property(style);
  if (!events_) return;
  events_->create_properties(style);
  // The models are told of a pair that parts only while it is closer than this times the sum of the
  // radii: far enough for a step. The pair style asks for it before init.
  neighbor->register_contact_dist_factor(1.02);
}

void FixMultisphereAB::init() {
  FixMultisphere::init();
  if (modify->n_fixes_style("multisphere") > 1)
    stop_run(lmp, *this, "only one fix multisphere can hold the bodies, but there are more");
  if (modify->n_fixes_style("insert/stream") > 0)
    stop_run(lmp, *this,
             "fix insert/stream, which moves bodies by itself at first, is not supported");
  planar_ = options_.planar();
  find_prescribed();
  if (events_) events_->init();
  if (counts_) counts_->check_models(name_of(*this) + ": mass_scaling");
  restart_history_after_change();
}

void FixMultisphereAB::reset_dt() {
  dtv = update->dt;
  restart_history_after_change();
}

void* FixMultisphereAB::extract(const char* name, int& dimension) {
  dimension = 0;
  if (strcmp(name, "multistep_order") == 0) return &order_;
  return strcmp(name, "contact_events") == 0 ? events_.get() : NULL;
}

/// Completes `history`, whose newest entry is set, with the past of the body, and keeps what the
/// next step needs of it. A body at birth has no past: `fill_before_birth` makes one up.
template <class Record, class Rates, class Birth>
void FixMultisphereAB::update_history(const std::vector<Record*>& past, int body, Rates* history,
                                      Birth fill_before_birth) {
  const int known = evaluations_->get(body);
  if (known == 0) {
    fill_before_birth(history);
    timestep_->set(body, update->dt);
  } else {
    for (int k = 0; k < order_ - 1; ++k) memcpy(&history[k], (*past[k])(body), sizeof(Rates));
  }
  for (int k = 0; k < order_ - 1; ++k) memcpy((*past[k])(body), &history[k + 1], sizeof(Rates));
  evaluations_->set(body, std::min(known, records()) + 1);
}

void FixMultisphereAB::initial_integrate(int) {
  for (int body = 0; body < n_body(); ++body) {
    if (is_prescribed(body))
      move_prescribed(body);
    else if (planar_)
      advance_planar(body);
    else
      advance_spatial(body);
  }

  // The constraint virial that set_xv can tally is defined for the half steps of velocity Verlet.
  evflag = 0;
  set_xv();
  rev_comm_flag_ = MS_COMM_REV_X_V_OMEGA;
  reverse_comm();
  if (events_) events_->arm();
}

void FixMultisphereAB::setup(int vflag) {
  FixMultisphere::setup(vflag);
  if (counts_) sum_contact_weights();
}

void FixMultisphereAB::pre_force(int vflag) {
  FixMultisphere::pre_force(vflag);
  if (counts_) counts_->begin();
  if (events_ && neighbor->ago == 0) events_->renew_ghosts();
}

void FixMultisphereAB::final_integrate() {
  // Velocities are those of this time already, on ghosts too: only the forces are missing.
  calc_force(false);
  if (counts_) sum_contact_weights();
  if (events_) apply_events();
}

double FixMultisphereAB::moment_about_z(int body) const {
  const double* inertia = inertia_(body);
  const double cosine[3] = {ex_(body)[2], ey_(body)[2], ez_(body)[2]};
  double moment = 0.0;
  for (int d = 0; d < 3; ++d) moment += inertia[d] * cosine[d] * cosine[d];
  return moment;
}

void FixMultisphereAB::advance_planar(int body) {
  if (evaluations_->get(body) == 0) require_planar(body);
  if (events_) move_planar(body);

  double *x = xcm_(body), *v = vcm_(body), *q = quat_(body);
  const double *force = fcm_(body), mass = mass_(body), moment = moment_about_z(body);
  const double share = 1.0 / inertia_factor(body);
  const bool* force_on = fflag_(body);
  PlanarMotion motion = {{x[0], x[1]}, {v[0], v[1]}, omega_(body)[2], {q[0], q[1], q[2], q[3]}};

  PlanarRates history[rodpack::max_multistep_order];
  PlanarRates& now = history[records() - 1];
  for (int d = 0; d < 2; ++d) {
    now.velocity[d] = v[d];
    now.acceleration[d] = force_on[d] ? share * (force[d] / mass) : 0.0;
  }
  now.angular_velocity = motion.angular_velocity;
  now.angular_acceleration = tflag_(body)[2] ? share * (torque_(body)[2] / moment) : 0.0;

  const auto fill = [&](PlanarRates* h) {
    rodpack::fill_kinematic_history(h, records(), update->dt);
  };
  if (options_.always_planar())
    update_history(past_planar_, body, history, fill);
  else
    update_history(past_spatial_, body, history, fill);
  if (order_ == 0)
    rodpack::leap(motion, now, evaluations_->get(body), update->dt);
  else
    rodpack::advance(motion, history, order_, evaluations_->get(body), update->dt);

  for (int d = 0; d < 2; ++d) {
    x[d] = motion.position[d];
    v[d] = motion.velocity[d];
  }
  std::copy(motion.quaternion, motion.quaternion + 4, q);
  set_axes_planar(body);
  omega_(body)[2] = motion.angular_velocity;
  angmom_(body)[2] = moment * motion.angular_velocity;
}

void FixMultisphereAB::set_axes_planar(int body) {
  // A rotation about z leaves the z components of the axes alone; recomputed ones would scatter by
  // a rounding error and move spheres out of their plane.
  double* axes[3] = {ex_(body), ey_(body), ez_(body)};
  const double z[3] = {axes[0][2], axes[1][2], axes[2][2]};
  MathExtra::q_to_exyz(quat_(body), axes[0], axes[1], axes[2]);
  for (int d = 0; d < 3; ++d) axes[d][2] = z[d];
}

void FixMultisphereAB::advance_spatial(int body) {
  if (evaluations_->get(body) == 0) require_inertia(body);
  if (events_) move_spatial(body);

  double *x = xcm_(body), *v = vcm_(body), *l = angmom_(body), *q = quat_(body);
  const double *force = fcm_(body), *torque = torque_(body), mass = mass_(body);
  const bool *force_on = fflag_(body), *torque_on = tflag_(body);
  const double share = 1.0 / inertia_factor(body);
  double inertia[3];
  std::copy(inertia_(body), inertia_(body) + 3, inertia);
  SpatialMotion motion = {
      {x[0], x[1], x[2]}, {v[0], v[1], v[2]}, {l[0], l[1], l[2]}, {q[0], q[1], q[2], q[3]}};

  SpatialRates history[rodpack::max_multistep_order];
  SpatialRates& now = history[records() - 1];
  for (int d = 0; d < 3; ++d) {
    now.velocity[d] = v[d];
    now.acceleration[d] = force_on[d] ? share * (force[d] / mass) : 0.0;
    now.torque[d] = torque_on[d] ? share * torque[d] : 0.0;
  }
  rodpack::quaternion_rate(motion.quaternion, motion.angular_momentum, inertia,
                           now.quaternion_rate);

  update_history(past_spatial_, body, history, [&](SpatialRates* h) {
    rodpack::fill_kinematic_history(h, records(), update->dt, motion, inertia);
  });
  if (order_ == 0)
    rodpack::leap(motion, now, inertia, evaluations_->get(body), update->dt);
  else
    rodpack::advance(motion, history, order_, evaluations_->get(body), update->dt);

  double omega[3];
  rodpack::angular_velocity(motion.quaternion, motion.angular_momentum, inertia, omega);
  for (int d = 0; d < 3; ++d) {
    x[d] = motion.position[d];
    v[d] = motion.velocity[d];
    l[d] = motion.angular_momentum[d];
    omega_(body)[d] = omega[d];
  }
  std::copy(motion.quaternion, motion.quaternion + 4, q);
  MathExtra::q_to_exyz(q, ex_(body), ey_(body), ez_(body));
}

void FixMultisphereAB::require_planar(int body) {
  // The z axis has to be a principal one, or the motion about it would tip the body over.
  const double* inertia = inertia_(body);
  const double* axes[3] = {ex_(body), ey_(body), ez_(body)};
  double product[2] = {0.0, 0.0};
  for (int k = 0; k < 3; ++k)
    for (int d = 0; d < 2; ++d) product[d] += inertia[k] * axes[k][d] * axes[k][2];
  const double largest = std::max(inertia[0], std::max(inertia[1], inertia[2]));
  if (std::max(std::fabs(product[0]), std::fabs(product[1])) > 1e-9 * largest)
    body_error(body, "z is not one of its principal axes, so it cannot move in the x-y plane only");
  if (!(moment_about_z(body) > 0.0))
    body_error(body, "its moment of inertia about z is not positive");

  double *v = vcm_(body), *omega = omega_(body);
  if (v[2] == 0.0 && omega[0] == 0.0 && omega[1] == 0.0) return;
  if (modify->n_fixes_style("enforce2d") == 0)
    body_error(body, "it moves out of the x-y plane: v_z, omega_x and omega_y have to be 0");
  v[2] = omega[0] = omega[1] = angmom_(body)[0] = angmom_(body)[1] = 0.0;
}

void FixMultisphereAB::require_inertia(int body) {
  for (int d = 0; d < 3; ++d)
    if (!(inertia_(body)[d] > 0.0)) body_error(body, "its moments of inertia have to be positive");
}

void FixMultisphereAB::body_error(int body, const char* what) {
  stop_run_from_one_rank(lmp, *this, "body " + std::to_string(data().tag(body)) + ": " + what);
}
