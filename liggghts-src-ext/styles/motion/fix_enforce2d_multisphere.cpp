// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_enforce2d_multisphere.h"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>

#include "atom.h"
#include "domain.h"
#include "modify.h"
#include "multisphere_fix.h"
#include "planar_orientation.h"
#include "stop_run.h"
#include "style_arguments.h"

namespace LAMMPS_NS {

using namespace FixConst;

namespace {

// A sphere further than this part of its radius from the plane was not meant to lie in it. A sphere
// that is moved by it changes the gap to a neighbour by at most 0.5 % of the radius.
const double tolerance = 0.1;

VectorContainer<double, 3>& vectors(Multisphere& bodies, const char* name) {
  return *bodies.prop().getElementProperty<VectorContainer<double, 3>>(name);
}

}  // namespace

FixEnforce2DMultisphere::FixEnforce2DMultisphere(LAMMPS* lmp, int narg, char** arg)
    : Fix(lmp, narg, arg), plane_(0), bodies_(NULL), reference_(NULL) {
  StyleArguments arguments(lmp, narg, arg);
  while (arguments.more()) {
    const std::string keyword = arguments.new_keyword();
    if (keyword != "plane") arguments.reject_keyword(keyword, "plane");
    plane_ = arguments.number(keyword, a_position);
  }
  if (domain->dimension != 3)
    arguments.reject("dimension", "3 (particles are spheres and bodies of spheres)",
                     std::to_string(domain->dimension));
  if (!atom->sphere_flag) arguments.fail("needs atom_style sphere (granular)");
}

int FixEnforce2DMultisphere::setmask() {
  return PRE_EXCHANGE | INITIAL_INTEGRATE | PRE_FINAL_INTEGRATE | FINAL_INTEGRATE;
}

void FixEnforce2DMultisphere::init() {
  const int me = modify->my_index(this);
  for (int i = me + 1; i < modify->nfix; ++i) {
    const Fix& other = *modify->fix[i];
    if (other.time_integrate || !std::strncmp(other.style, "multisphere", 11)) {
      const std::string message =
          std::string("must be defined after fix ") + other.style + " (id " + other.id + ")";
      stop_run(lmp, *this, message);
    }
  }
  if (plane_ < domain->boxlo[2] || plane_ > domain->boxhi[2]) {
    char text[128];
    std::snprintf(text, sizeof text, "plane is '%.15g', expected a z in the box, %g to %g m",
                  plane_, domain->boxlo[2], domain->boxhi[2]);
    stop_run(lmp, *this, text);
  }
  double largest, smallest;
  modify->max_min_rad(largest, smallest);
  if (domain->zperiodic && domain->zprd < 2. * largest) {
    const std::string message = "periodic z needs a box thicker than the thickest particle, " +
                                std::to_string(2. * largest) + " m, got '" +
                                std::to_string(domain->zprd) + "'";
    stop_run(lmp, *this, message);
  }

  FixMultisphere* const multisphere = multisphere_fix(modify);
  bodies_ = multisphere ? &multisphere->data() : NULL;
  if (!bodies_) return;
  if (igroup != 0) stop_run(lmp, *this, "group must be all where there is a fix multisphere");
  const char* name = "planar_reference";
  reference_ = bodies_->prop().getElementProperty<VectorContainer<double, 4>>(name);
  if (reference_) return;
  reference_ = bodies_->prop().addElementProperty<VectorContainer<double, 4>>(
      name, "comm_exchange_borders", "frame_invariant", "restart_no", 1, bodies_->n_body());
  reference_->setDefaultValue(0.);
}

void FixEnforce2DMultisphere::setup_pre_exchange() {
  flatten_positions();
  flatten_velocities();
}

void FixEnforce2DMultisphere::setup(int) {
  flatten_forces();
  flatten_body_forces();
}

// Particles that were inserted in this step may lie off the plane.
void FixEnforce2DMultisphere::pre_exchange() {
  flatten_positions();
  flatten_velocities();
}

void FixEnforce2DMultisphere::initial_integrate(int) {
  flatten_positions();
  flatten_velocities();
}

// Here rather than in post_force: walls and fields may be defined after this fix.
void FixEnforce2DMultisphere::pre_final_integrate() { flatten_forces(); }

void FixEnforce2DMultisphere::final_integrate() {
  flatten_velocities();
  flatten_body_forces();
}

void FixEnforce2DMultisphere::check_flat() const {
  for (int i = 0; i < atom->nlocal; ++i) {
    const double off = atom->x[i][2] - plane_;
    if (!(atom->mask[i] & groupbit) || std::abs(off) <= tolerance * atom->radius[i]) continue;
    char text[256];
    std::snprintf(text, sizeof text,
                  "sphere %d lies %g m off the plane z = %g, more than %g of its radius %g m: "
                  "particles must be put into the plane",
                  atom->tag[i], off, plane_, tolerance, atom->radius[i]);
    stop_run_from_one_rank(lmp, *this, text);
  }
}

void FixEnforce2DMultisphere::flatten_positions() {
  check_flat();
  // Not the ghosts: they are copied from here next, and may be images at another z.
  for (int i = 0; i < atom->nlocal; ++i)
    if (atom->mask[i] & groupbit) atom->x[i][2] = plane_;
  if (!bodies_) return;
  auto& xcm = vectors(*bodies_, "xcm");
  auto& ex = vectors(*bodies_, "ex_space");
  auto& ey = vectors(*bodies_, "ey_space");
  auto& ez = vectors(*bodies_, "ez_space");
  auto& quat = *bodies_->prop().getElementProperty<VectorContainer<double, 4>>("quat");
  for (int b = 0; b < bodies_->n_body(); ++b) {
    xcm(b)[2] = plane_;
    double* reference = (*reference_)(b);
    if (reference[0] == 0 && reference[1] == 0 && reference[2] == 0 && reference[3] == 0)
      planar_reference(quat(b), reference);
    flatten_orientation(reference, quat(b), ex(b), ey(b), ez(b));
  }
}

void FixEnforce2DMultisphere::flatten_velocities() {
  for (int i = 0; i < atom->nlocal + atom->nghost; ++i) {
    if (!(atom->mask[i] & groupbit)) continue;
    atom->v[i][2] = 0.;
    atom->omega[i][0] = atom->omega[i][1] = 0.;
  }
  if (!bodies_) return;
  auto& vcm = vectors(*bodies_, "vcm");
  auto& omega = vectors(*bodies_, "omega");
  auto& angmom = vectors(*bodies_, "angmom");
  for (int b = 0; b < bodies_->n_body(); ++b) {
    vcm(b)[2] = 0.;
    omega(b)[0] = omega(b)[1] = 0.;
    angmom(b)[0] = angmom(b)[1] = 0.;
  }
}

void FixEnforce2DMultisphere::flatten_forces() {
  for (int i = 0; i < atom->nlocal + atom->nghost; ++i) {
    if (!(atom->mask[i] & groupbit)) continue;
    atom->f[i][2] = 0.;
    atom->torque[i][0] = atom->torque[i][1] = 0.;
  }
}

void FixEnforce2DMultisphere::flatten_body_forces() {
  if (!bodies_) return;
  auto& force = vectors(*bodies_, "fcm");
  auto& torque = vectors(*bodies_, "torque");
  for (int b = 0; b < bodies_->n_body(); ++b) {
    force(b)[2] = 0.;
    torque(b)[0] = torque(b)[1] = 0.;
  }
}

}  // namespace LAMMPS_NS
