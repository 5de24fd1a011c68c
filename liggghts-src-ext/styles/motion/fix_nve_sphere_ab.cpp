// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_nve_sphere_ab.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "atom.h"
#include "atom_property.h"
#include "domain.h"
#include "fix_property_atom.h"
#include "modify.h"
#include "mpi_liggghts.h"
#include "multisphere_fix.h"
#include "rodpack/motion/rigid_motion.h"
#include "stop_run.h"
#include "style_arguments.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace FixConst;

// A record of rates holds velocity, acceleration and angular acceleration in this order.
enum { VELOCITY = 0, ACCELERATION = 3, ANGULAR_ACCELERATION = 6, RATES = 9 };
// The state of a sphere holds these values in this order.
enum { EVALUATIONS = 0, TIMESTEP, ORDER, STATE_VALUES };

FixNVESphereAB::FixNVESphereAB(LAMMPS* lmp, int narg, char** arg)
    : Fix(lmp, narg, arg), options_(lmp), bodies_(NULL), state_(NULL) {
  time_integrate = 1;
  StyleArguments arguments(lmp, narg, arg);
  while (arguments.more()) {
    const std::string keyword = arguments.new_keyword();
    if (!options_.read(keyword, arguments)) arguments.reject_keyword(keyword, "order or planar");
  }
  order_ = options_.order();
  planar_ = options_.planar();
  if (!atom->sphere_flag) arguments.fail("needs atom_style sphere (granular)");
}

FixPropertyAtom* FixNVESphereAB::add_property(const char* name, int values) {
  return add_atom_property(modify, std::string(name) + "_" + id, values, "yes", "no", "no", style);
}

void FixNVESphereAB::post_create() {
  state_ = add_property("ab_state", STATE_VALUES);
  for (int k = 1; k < order_; ++k)
    past_.push_back(add_property(("ab_rates_" + std::to_string(k)).c_str(), RATES));
}

void FixNVESphereAB::pre_delete(bool unfixflag) {
  if (!unfixflag) return;
  for (FixPropertyAtom* record : past_) modify->delete_fix(record->id);
  modify->delete_fix(state_->id);
}

int FixNVESphereAB::setmask() { return INITIAL_INTEGRATE; }

void FixNVESphereAB::init() {
  if (strstr(update->integrate_style, "respa")) stop_run(lmp, *this, "does not work with respa");
  if (modify->n_fixes_style("insert/stream") > 0)
    stop_run(lmp, *this,
             "fix insert/stream, which moves spheres by itself at first, is not supported");
  planar_ = options_.planar();
  // As for fix nve/sphere, particles are discs in a two-dimensional simulation.
  inertia_factor_ = domain->dimension == 2 ? 0.5 : 0.4;
  bodies_ = multisphere_fix(modify);

  int points = 0;
  for (int i = 0; i < atom->nlocal; ++i)
    if ((atom->mask[i] & groupbit) && !(atom->radius[i] > 0.0)) ++points;
  MPI_Sum_Scalar(points, world);
  if (points > 0) stop_run(lmp, *this, "needs spheres with a radius above 0");
  restart_history_after_change();
}

void FixNVESphereAB::reset_dt() { restart_history_after_change(); }

void FixNVESphereAB::restart_history_after_change() {
  int restarted = 0;
  for (int i = 0; i < atom->nlocal; ++i) {
    double* state = state_->array_atom[i];
    if (state[EVALUATIONS] > 0 && (state[TIMESTEP] != update->dt || state[ORDER] != order_)) {
      state[EVALUATIONS] = 0;
      ++restarted;
    }
  }
  MPI_Sum_Scalar(restarted, world);
  if (restarted > 0)
    warn_of_new_histories(*this, lmp, "new time step or order",
                          std::to_string(restarted) + " spheres");
}

void* FixNVESphereAB::extract(const char* name, int& dimension) {
  dimension = 0;
  return strcmp(name, "multistep_order") == 0 ? &order_ : NULL;
}

void FixNVESphereAB::initial_integrate(int) {
  const int* mask = atom->mask;
  for (int i = 0; i < atom->nlocal; ++i)
    if ((mask[i] & groupbit) && !(bodies_ && bodies_->belongs_to(i) >= 0)) advance(i);
}

void FixNVESphereAB::advance(int i) {
  double *x = atom->x[i], *v = atom->v[i], *omega = atom->omega[i];
  const double mass = atom->rmass[i], radius = atom->radius[i], dt = update->dt;
  const double moment = inertia_factor_ * mass * radius * radius;

  double history[rodpack::max_multistep_order][RATES];  // newest first
  for (int d = 0; d < 3; ++d) {
    history[0][VELOCITY + d] = v[d];
    history[0][ACCELERATION + d] = atom->f[i][d] / mass;
    history[0][ANGULAR_ACCELERATION + d] = atom->torque[i][d] / moment;
  }

  double* state = state_->array_atom[i];
  if (state[EVALUATIONS] == 0) {
    // Velocities before birth follow from the force at birth, held constant; forces stay unknown.
    for (int k = 1; k < order_; ++k)
      for (int d = 0; d < RATES; ++d)
        history[k][d] = d < ACCELERATION ? rodpack::velocity_before_birth(
                                               v[d], history[0][ACCELERATION + d], k * dt)
                                         : 0.0;
    state[TIMESTEP] = dt;
    state[ORDER] = order_;
  } else {
    for (int k = 1; k < order_; ++k)
      std::copy(past_[k - 1]->array_atom[i], past_[k - 1]->array_atom[i] + RATES, history[k]);
  }
  for (int k = 1; k < order_; ++k)
    std::copy(history[k - 1], history[k - 1] + RATES, past_[k - 1]->array_atom[i]);
  const int evaluations = std::min(static_cast<int>(state[EVALUATIONS]), order_) + 1;
  state[EVALUATIONS] = evaluations;

  const rodpack::MultistepWeights& of_velocity = rodpack::adams_bashforth_weights(order_);
  const rodpack::MultistepWeights& of_force = rodpack::multistep_weights(order_, evaluations);
  const auto increment = [&](const rodpack::MultistepWeights& weights, int component) {
    return rodpack::multistep_increment(weights, order_, dt,
                                        [&](int k) { return history[k][component]; });
  };
  for (int d = 0; d < (planar_ ? 2 : 3); ++d) {
    x[d] += increment(of_velocity, VELOCITY + d);
    v[d] += increment(of_force, ACCELERATION + d);
  }
  for (int d = planar_ ? 2 : 0; d < 3; ++d)
    omega[d] += increment(of_force, ANGULAR_ACCELERATION + d);
}
