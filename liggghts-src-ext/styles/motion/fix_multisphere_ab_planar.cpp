// SPDX-License-Identifier: GPL-2.0-or-later
// Bodies of planar motion, to the planar engine and back.
#include <algorithm>
#include <cmath>

#include "atom.h"
#include "fix_multisphere_ab.h"
#include "math_extra.h"
#include "rodpack/planar/scene.h"
#include "update.h"

using namespace LAMMPS_NS;
using rodpack::PlanarBody;

/// The body as the engine takes it; `atoms` are its spheres. Its frame is that of space, turned by
/// no angle yet.
PlanarBody FixMultisphereAB::to_planar(int body, const std::vector<int>& atoms) {
  const bool prescribed = is_prescribed(body);
  if (evaluations_->get(body) == 0 && !prescribed) require_planar(body);
  if (!prescribed && (!fflag_(body)[0] || !fflag_(body)[1] || !tflag_(body)[2]))
    body_error(body, "run_style verlet/planar cannot switch off components of its force or torque");
  PlanarBody planar;
  planar.tag = data().tag(body);
  planar.mass = mass_(body);
  planar.moment = moment_about_z(body);
  planar.prescribed = prescribed;
  planar.radius = atom->radius[atoms[0]];
  for (int i : atoms) {
    double arm[3];
    MathExtra::matvec(ex_(body), ey_(body), ez_(body), displace_[i], arm);
    if (std::fabs(arm[2]) > 1e-9 * planar.radius)
      body_error(body, "run_style verlet/planar needs its spheres in one plane z = const");
    if (atom->radius[i] != planar.radius)
      body_error(body, "run_style verlet/planar needs spheres of one radius in a body");
    if (atom->type[i] != atom->type[atoms[0]])
      body_error(body, "run_style verlet/planar needs spheres of one type in a body");
    planar.spheres.push_back({arm[0], arm[1], atom->tag[i]});
  }
  const double *x = xcm_(body), *v = vcm_(body);
  const MissedMotion& missed = missed_motion(body);
  for (int d = 0; d < 2; ++d) {
    planar.position[d] = x[d];
    planar.velocity[d] = v[d];
    planar.load[d] = fcm_(body)[d];
    planar.missed_displacement[d] = missed.displacement[d];
    planar.missed_velocity[d] = missed.velocity[d];
  }
  planar.velocity[2] = omega_(body)[2];
  planar.load[2] = torque_(body)[2];
  planar.missed_displacement[2] = missed.rotation[2];
  planar.missed_velocity[2] = missed.angular_momentum[2] / planar.moment;
  if (contact_weight_) planar.contact_weight = contact_weight_->get(body);
  planar.evaluations = evaluations_->get(body);
  for (int k = 1; k < order_; ++k) planar.past[k - 1] = *planar_record(body, k);
  if (events_) read_jump(atoms, planar);
  return planar;
}

/// The planar rates `age` steps back.
rodpack::PlanarRates* FixMultisphereAB::planar_record(int body, int age) {
  double* record = options_.always_planar() ? (*past_planar_[order_ - 1 - age])(body)
                                            : (*past_spatial_[order_ - 1 - age])(body);
  return reinterpret_cast<rodpack::PlanarRates*>(record);
}

/// Finds what contacts will be told about the body in the next step, if its acceleration has
/// jumped.
void FixMultisphereAB::read_jump(const std::vector<int>& atoms, PlanarBody& planar) {
  const rodpack::SpatialJump* of_sphere = events_->jump_for_next_step(atoms[0]);
  planar.jumped = of_sphere != NULL;
  if (!of_sphere) return;
  const rodpack::PlanarSphere& sphere = planar.spheres[0];
  const double to_centre[3] = {-sphere.x, -sphere.y, 0.0};
  planar.jump = rodpack::to_plane(rodpack::jump_at(*of_sphere, to_centre));
  planar.jump.cosine = planar.cosine;
  planar.jump.sine = planar.sine;
}

/// To be called before from_planar() is for the bodies of this rank.
void FixMultisphereAB::begin_planar() {
  if (events_) events_->begin_publishing();
}

void FixMultisphereAB::from_planar(int body, const std::vector<int>& atoms,
                                   const PlanarBody& planar) {
  double *x = xcm_(body), *v = vcm_(body);
  MissedMotion& missed = missed_motion(body);
  for (int d = 0; d < 2; ++d) {
    x[d] = planar.position[d];
    v[d] = planar.velocity[d];
    fcm_(body)[d] = planar.load[d];
    missed.displacement[d] = planar.missed_displacement[d];
    missed.velocity[d] = planar.missed_velocity[d];
  }
  omega_(body)[2] = planar.velocity[2];
  angmom_(body)[2] = planar.moment * planar.velocity[2];
  torque_(body)[2] = planar.load[2];
  if (contact_weight_) contact_weight_->set(body, planar.contact_weight);
  missed.rotation[2] = planar.missed_displacement[2];
  missed.angular_momentum[2] = planar.moment * planar.missed_velocity[2];
  evaluations_->set(body, is_prescribed(body) ? 0 : planar.evaluations);
  if (planar.evaluations > 0) timestep_->set(body, update->dt);
  for (int k = 1; k < order_; ++k) *planar_record(body, k) = planar.past[k - 1];

  double q[4];
  std::copy(quat_(body), quat_(body) + 4, q);
  rodpack::rotate_about_z(std::atan2(planar.sine, planar.cosine), q);
  std::copy(q, q + 4, quat_(body));
  set_axes_planar(body);
  if (events_ && planar.jumped) publish_jump(body, atoms, planar);
}

void FixMultisphereAB::publish_jump(int body, const std::vector<int>& atoms,
                                    const PlanarBody& planar) {
  const rodpack::SpatialJump jump = rodpack::to_space(planar.jump);
  for (int i : atoms) {
    double arm[3];
    MathExtra::matvec(ex_(body), ey_(body), ez_(body), displace_[i], arm);
    events_->publish(i, rodpack::jump_at(jump, arm));
  }
}

/// Positions and velocities of the spheres from those of the bodies, and what was published.
void FixMultisphereAB::finish_planar() {
  evflag = 0;
  set_xv();
  rev_comm_flag_ = MS_COMM_REV_X_V_OMEGA;
  reverse_comm();
  if (events_) events_->end_publishing();
}

void FixMultisphereAB::keep_loads() {
  for (int body = 0; body < n_body(); ++body) {
    const double load[3] = {fcm_(body)[0], fcm_(body)[1], torque_(body)[2]};
    std::copy(load, load + 3, (*planar_load_)(body));
  }
}

/// To be called after bodies, atoms and ghosts were made anew.
void FixMultisphereAB::restore_loads() {
  for (int body = 0; body < n_body(); ++body) {
    const double* load = (*planar_load_)(body);
    std::copy(load, load + 2, fcm_(body));
    torque_(body)[2] = load[2];
  }
  if (events_) events_->renew_ghosts();
}
