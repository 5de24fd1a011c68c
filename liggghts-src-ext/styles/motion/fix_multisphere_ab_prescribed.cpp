// SPDX-License-Identifier: GPL-2.0-or-later
// Bodies whose motion a fix move/multisphere prescribes: no force moves them.
#include <algorithm>
#include <cstring>
#include <string>

#include "fix_move_multisphere.h"
#include "fix_multisphere_ab.h"
#include "math_extra.h"
#include "modify.h"
#include "mpi_liggghts.h"
#include "stop_run.h"

using namespace LAMMPS_NS;

/// Finds who moves which body, and sets the velocities of these bodies to what they are now.
void FixMultisphereAB::find_prescribed() {
  int other_velocities = 0;
  movers_.clear();
  for (int k = 0; k < modify->nfix; ++k)
    if (strcmp(modify->fix[k]->style, "move/multisphere") == 0)
      movers_.push_back(static_cast<FixMoveMultisphere*>(modify->fix[k]));
  for (FixMoveMultisphere* mover : movers_) {
    mover->take_bodies();
    if (planar_ && !mover->motion().is_in_plane())
      stop_run(lmp, *mover,
               "moves bodies out of the x-y plane, in which fix multisphere/ab keeps them, "
               "expected z of velocity and amplitude and x and y of omega to be 0");
  }
  for (int body = 0; body < n_body(); ++body) {
    int by = 0;
    for (size_t k = 0; k < movers_.size(); ++k) {
      if (!movers_[k]->moves(data().tag(body))) continue;
      if (by > 0)
        stop_run_from_one_rank(lmp, *movers_[k],
                               "body " + std::to_string(data().tag(body)) + " is moved by fix " +
                                   movers_[by - 1]->id + " already, expected one of the two");
      by = static_cast<int>(k) + 1;
    }
    if (by == 0 && !is_prescribed(body)) continue;
    prescribe(body, by);
    if (by == 0) continue;
    double before[6], now[6];
    const auto velocities = [&](double* to) {
      std::copy(vcm_(body), vcm_(body) + 3, to);
      std::copy(omega_(body), omega_(body) + 3, to + 3);
    };
    velocities(before);
    move_prescribed(body);
    velocities(now);
    if (!std::equal(now, now + 6, before)) other_velocities = 1;
  }
  MPI_Max_Scalar(other_velocities, world);
  spheres_lag_ = other_velocities != 0;
}

/// Lets a mover have the body, or, with 0, none: set free, it starts anew as at birth.
void FixMultisphereAB::prescribe(int body, int by) {
  prescribed_->set(body, by);
  evaluations_->set(body, 0);
  missed_motion(body) = MissedMotion();
}

void FixMultisphereAB::set_free(const FixMoveMultisphere* mover) {
  for (size_t k = 0; k < movers_.size(); ++k) {
    if (movers_[k] != mover) continue;
    for (int body = 0; body < n_body(); ++body)
      if (prescribed_->get(body) == static_cast<int>(k) + 1) prescribe(body, 0);
    movers_[k] = NULL;
  }
}

void FixMultisphereAB::setup_pre_neighbor() {
  FixMultisphere::setup_pre_neighbor();
  // Velocities stay where nothing has changed: set anew they may differ by a rounding error.
  if (!spheres_lag_) return;
  spheres_lag_ = false;
  evflag = 0;
  set_v_communicate();
}

void FixMultisphereAB::pre_neighbor() {
  FixMultisphere::pre_neighbor();
  for (const FixMoveMultisphere* mover : movers_)
    if (mover) mover->refuse_newcomers();
}

/// Sets the body to where its motion has it at the present step.
void FixMultisphereAB::move_prescribed(int body) {
  const FixMoveMultisphere& mover = *movers_[prescribed_->get(body) - 1];
  const rodpack::PrescribedState now = mover.state(data().tag(body), image_(body));
  std::copy(now.pose.position, now.pose.position + 3, xcm_(body));
  std::copy(now.velocity, now.velocity + 3, vcm_(body));
  std::copy(now.pose.quaternion, now.pose.quaternion + 4, quat_(body));
  if (planar_)
    set_axes_planar(body);
  else
    MathExtra::q_to_exyz(quat_(body), ex_(body), ey_(body), ez_(body));
  double omega[3];
  std::copy(mover.motion().angular_velocity, mover.motion().angular_velocity + 3, omega);
  data().set_angmom_via_omega_body(body, omega);
}
