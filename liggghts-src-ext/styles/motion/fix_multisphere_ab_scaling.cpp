// SPDX-License-Identifier: GPL-2.0-or-later
// Mass scaling: the inertia of a body grows with its contacts (rodpack/motion/mass_scaling.h).
#include "rodpack/motion/mass_scaling.h"

#include "atom.h"
#include "domain.h"
#include "fix_multisphere_ab.h"

using namespace LAMMPS_NS;

double FixMultisphereAB::inertia_factor(int body) const {
  if (!contact_weight_) return 1.0;
  return rodpack::inertia_factor(contact_weight_->get(body), mass_scaling_);
}

/// Sums up the weights of the contacts of each body of this rank, as calc_force does the forces.
void FixMultisphereAB::sum_contact_weights() {
  counts_->complete();
  for (int body = 0; body < n_body(); ++body) contact_weight_->set(body, 0.0);
  for (int i = 0; i < atom->nlocal + atom->nghost; ++i) {
    const int body = body_[i] < 0 ? -1 : map(body_[i]);
    if (body < 0 || !domain->is_owned_or_first_ghost(i)) continue;
    const double count = counts_->of(i), radius = atom->radius[i];
    if (count == 0.0) continue;
    const double arm[3] = {displace_[i][0], displace_[i][1], displace_[i][2]};
    double weight;
    if (planar_) {
      const double height = ex_(body)[2] * arm[0] + ey_(body)[2] * arm[1] + ez_(body)[2] * arm[2];
      const double square = arm[0] * arm[0] + arm[1] * arm[1] + arm[2] * arm[2] - height * height;
      weight = rodpack::contact_weight(
          rodpack::planar_contact_weight(mass_(body), moment_about_z(body), radius), square);
    } else {
      const double inertia[3] = {inertia_(body)[0], inertia_(body)[1], inertia_(body)[2]};
      weight = rodpack::spatial_contact_weight(mass_(body), inertia, radius, arm);
    }
    contact_weight_->set(body, contact_weight_->get(body) + count * weight);
  }
}
