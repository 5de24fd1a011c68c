// SPDX-License-Identifier: GPL-2.0-or-later
#include "body_frames.h"

#include <cmath>
#include <set>

#include "atom.h"
#include "domain.h"
#include "fix_multisphere.h"
#include "math_extra.h"
#include "particle_identity.h"
#include "vector_liggghts.h"

namespace LAMMPS_NS {

namespace {

typedef std::array<std::array<double, 3>, 3> Matrix;

/// Eigenvector of the largest eigenvalue of a symmetric matrix; false where that is not alone.
bool principal_direction(const Matrix& spread, double (&direction)[3]) {
  double matrix[3][3], values[3], vectors[3][3];
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) matrix[a][b] = spread[a][b];
  if (MathExtra::jacobi(matrix, values, vectors)) return false;
  int first = 0;
  for (int k = 1; k < 3; ++k)
    if (values[k] > values[first]) first = k;
  for (int k = 0; k < 3; ++k)
    if (k != first && values[k] > (1.0 - 1e-6) * values[first]) return false;
  for (int d = 0; d < 3; ++d) direction[d] = vectors[d][first];
  return true;
}

/// Turns the frame ex, ey, ez so that its x axis is the line along `line`; sense and roll depend on
/// the line's components in the frame alone, and so stay as the body turns.
void align(const double (&line)[3], double (&ex)[3], double (&ey)[3], double (&ez)[3]) {
  const double* const axes[3] = {ex, ey, ez};
  double components[3], sense = 0.0;
  int other = 0;
  for (int k = 0; k < 3; ++k) {
    components[k] = vectorDot3D(line, axes[k]);
    if (sense == 0.0 && std::fabs(components[k]) > 0.1) sense = components[k] > 0.0 ? 1.0 : -1.0;
    if (std::fabs(components[k]) < std::fabs(components[other]) - 1e-3) other = k;
  }
  double x[3], y[3];
  for (int d = 0; d < 3; ++d) {
    x[d] = sense * line[d];
    y[d] = axes[other][d] - components[other] * line[d];
  }
  vectorNormalize3D(y);
  for (int d = 0; d < 3; ++d) {
    ex[d] = x[d];
    ey[d] = y[d];
  }
  vectorCross3D(ex, ey, ez);
}

}  // namespace

std::vector<BodyFrame> body_frames(LAMMPS* lmp, const ParticleIdentity& particles) {
  if (!particles.bodies() || particles.bodies()->n_body() == 0) return {};
  const Atom* const atom = lmp->atom;
  Multisphere& data = particles.bodies()->data();
  const int bodies = data.n_body();
  const double* const radius = data.extract_double_scalar("rod_radius");
  // The spread is that of the spheres' centres about their mean; the rank that owns a body has all
  // of its spheres, owned or as ghosts.
  std::vector<Matrix> spread(bodies, Matrix{});
  std::vector<std::array<double, 4>> sums(bodies, std::array<double, 4>{});
  std::set<int> seen;  // across a periodic boundary a sphere is there twice
  for (int i = 0; i < atom->nlocal + atom->nghost; ++i) {
    const int body = particles.body_of(i);
    const int k = body >= 0 ? data.map(body) : -1;
    if (k < 0 || (radius && radius[k] > 0.0) || !seen.insert(atom->tag[i]).second) continue;
    double centre[3], place[3];
    data.xcm(centre, k);
    vectorSubtract3D(atom->x[i], centre, place);
    lmp->domain->minimum_image(place);
    sums[k][3] += 1.0;
    for (int a = 0; a < 3; ++a) {
      sums[k][a] += place[a];
      for (int b = 0; b < 3; ++b) spread[k][a][b] += place[a] * place[b];
    }
  }
  for (int k = 0; k < bodies; ++k)
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3 && sums[k][3] > 0.0; ++b)
        spread[k][a][b] -= sums[k][a] * sums[k][b] / sums[k][3];
  double** const axes[3] = {data.extract_double_vector("ex_space"),
                            data.extract_double_vector("ey_space"),
                            data.extract_double_vector("ez_space")};
  std::vector<BodyFrame> frames(bodies);
  for (int k = 0; k < bodies; ++k) {
    double ex[3], ey[3], ez[3], quaternion[4], line[3];
    vectorCopy3D(axes[0][k], ex);
    data.quat(quaternion, k);
    if (!(radius && radius[k] > 0.0) && principal_direction(spread[k], line)) {
      vectorCopy3D(axes[1][k], ey);
      vectorCopy3D(axes[2][k], ez);
      align(line, ex, ey, ez);
      MathExtra::exyz_to_q(ex, ey, ez, quaternion);
    }
    for (int d = 0; d < 3; ++d) frames[k].axis[d] = ex[d];
    for (int d = 0; d < 4; ++d) frames[k].quaternion[d] = quaternion[d];
  }
  return frames;
}

}  // namespace LAMMPS_NS
