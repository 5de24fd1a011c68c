// SPDX-License-Identifier: GPL-2.0-or-later
#include "body_chains.h"

#include <algorithm>
#include "atom.h"
#include "domain.h"
#include "fix_multisphere.h"
#include "math_const.h"
#include "particle_identity.h"
#include "rodpack/geometry/chain_geometry.h"
#include "vector_liggghts.h"

namespace LAMMPS_NS {

std::vector<BodyChain> body_chains(LAMMPS* lmp, const ParticleIdentity& particles) {
  if (!particles.bodies() || particles.bodies()->n_body() == 0) return {};
  const Atom* const atom = lmp->atom;
  Multisphere& data = particles.bodies()->data();
  const int bodies = data.n_body();
  std::vector<BodyChain> chains(bodies, BodyChain{0.0, 0.0, 0.0, 0.0});
  const double* const half_length = data.extract_double_scalar("rod_half_length");
  const double* const radius = data.extract_double_scalar("rod_radius");
  const double* const curvature = data.extract_double_scalar("rod_curvature");
  const double* const area = data.extract_double_scalar("rod_area");
  const bool known = half_length && radius && curvature && area;
  bool all_known = known;
  for (int k = 0; known && k < bodies; ++k) {
    chains[k] = BodyChain{half_length[k], radius[k], curvature[k], area[k]};
    all_known = all_known && radius[k] > 0.0;
  }
  if (all_known) return chains;

  // Bodies of another template get the straight chain that encloses their spheres. The rank that
  // owns a body has all of its spheres, owned or as ghosts.
  for (int i = 0; i < atom->nlocal + atom->nghost; ++i) {
    const int body = particles.body_of(i);
    const int k = body >= 0 ? data.map(body) : -1;
    if (k < 0 || (known && radius[k] > 0.0)) continue;
    double centre[3], displacement[3];
    data.xcm(centre, k);
    vectorSubtract3D(atom->x[i], centre, displacement);
    lmp->domain->minimum_image(displacement);
    chains[k].radius = std::max(chains[k].radius, atom->radius[i]);
    chains[k].half_length =
        std::max(chains[k].half_length, vectorMag3D(displacement) + atom->radius[i]);
  }
  for (int k = 0; k < bodies; ++k) {
    if (known && radius[k] > 0.0) continue;
    const double r = chains[k].radius;
    chains[k].area = MathConst::MY_PI * r * r + 4.0 * r * (chains[k].half_length - r);
  }
  return chains;
}

double volume(const BodyChain& chain, int spheres) {
  const double r = chain.radius;
  const double sphere = 4.0 / 3.0 * MathConst::MY_PI * r * r * r;
  rodpack::ChainShape shape;
  shape.diameter = shape.nominal_diameter = 2.0 * r;
  shape.aspect_ratio = chain.half_length / r;
  shape.curvature_angle = chain.curvature;
  if (spheres < 2 || shape.aspect_ratio <= 1.0) return sphere;
  // A little more than the spacing, so that rounding does not make one sphere more of it.
  const double spacing = (shape.aspect_ratio - 1.0) / (spheres - 1) * (1.0 + 1e-12);
  if (spacing >= 1.0 && chain.curvature == 0.0) return spheres * sphere;
  shape.overlap = std::max(0.0, 1.0 - spacing);
  return rodpack::union_volume(shape);
}

}  // namespace LAMMPS_NS
