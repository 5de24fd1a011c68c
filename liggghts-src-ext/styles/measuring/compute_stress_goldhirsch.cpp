// SPDX-License-Identifier: GPL-2.0-or-later
#include "compute_stress_goldhirsch.h"

#include <mpi.h>
#include <algorithm>
#include <climits>
#include <string>
#include "atom.h"
#include "body_chains.h"
#include "fix_multisphere.h"
#include "gather.h"
#include "math_const.h"
#include "memory.h"
#include "particle_identity.h"
#include "stop_run.h"
#include "update.h"
#include "vector_liggghts.h"

namespace LAMMPS_NS {

ComputeStressGoldhirsch::ComputeStressGoldhirsch(LAMMPS* lmp, int& iarg, int narg, char** arg)
    : Compute(lmp, iarg, narg, arg),
      options_(read_averaging_options(lmp, narg, arg, iarg)),
      averages_(options_.start()),
      recorder_(lmp, std::string("compute ") + style,
                [this](bigint step) { return matchstep(step) != 0; }) {
  timeflag = 1;
  iarg = narg;
  if (averages_.sums().size() > INT_MAX)
    stop_run(lmp, *this,
             std::to_string(averages_.places()) + " places are too many to be added up over ranks");
  fields_ = averages_.fields();
  array_flag = 1;
  extarray = 0;
  size_array_rows = static_cast<int>(averages_.places());
  size_array_cols = options_.kernel->dimension();
  for (const rodpack::Field& field : fields_)
    size_array_cols += static_cast<int>(field.components.size());
  memory->create(array, size_array_rows, size_array_cols, "stress/goldhirsch:array");
}

ComputeStressGoldhirsch::~ComputeStressGoldhirsch() { memory->destroy(array); }

void ComputeStressGoldhirsch::init() { recorder_.check_models(); }

double ComputeStressGoldhirsch::memory_usage() {
  const double columns = size_array_cols;
  return 3 * columns * size_array_rows * sizeof(double);  // array, sums, fields
}

const std::vector<rodpack::Field>& ComputeStressGoldhirsch::current_fields() {
  if (invoked_array != update->ntimestep) compute_array();
  return fields_;
}

void ComputeStressGoldhirsch::compute_array() {
  invoked_array = update->ntimestep;
  evaluate();
  const int dimension = options_.kernel->dimension();
  for (int row = 0; row < size_array_rows; ++row) {
    const rodpack::Vector place = averages_.place(row);
    double* next = std::copy_n(place.begin(), dimension, array[row]);
    for (const rodpack::Field& field : fields_)
      for (const std::vector<double>& values : field.values) *next++ = values[row];
  }
}

void ComputeStressGoldhirsch::evaluate() {
  const ParticleIdentity particles(lmp);
  const std::vector<rodpack::Vector> centres = particles.all_body_centres();
  std::vector<rodpack::SphereContact> contacts;
  for (const ContactRecord& record : recorder_.collect())
    if (record.primary) contacts.push_back(contact_of(record, particles, centres));
  rodpack::ContactPairs own = rodpack::sum_pairs(std::move(contacts));

  std::vector<double>& sums = averages_.sums();
  std::fill(sums.begin(), sums.end(), 0.0);
  for (const rodpack::Interaction& interaction : own.interactions) averages_.add(interaction);

  // Two chains may touch on several ranks: which particles a particle touches is known to all.
  std::vector<int> flat;
  for (const rodpack::TouchingPair& pair : own.pairs)
    for (const long value : {pair.i, pair.j, static_cast<long>(pair.contacts)})
      flat.push_back(static_cast<int>(value));
  flat = gather_on_all(world, flat);
  std::vector<rodpack::TouchingPair> pairs;
  for (std::size_t k = 0; k < flat.size(); k += 3)
    pairs.push_back({flat[k], flat[k + 1], flat[k + 2]});
  add_particles(particles, rodpack::count_touching(rodpack::merge_pairs(std::move(pairs)),
                                                   particles.largest_id() + 1));

  MPI_Allreduce(MPI_IN_PLACE, sums.data(), static_cast<int>(sums.size()), MPI_DOUBLE, MPI_SUM,
                world);
  fields_ = averages_.fields();
}

void ComputeStressGoldhirsch::add_particles(const ParticleIdentity& particles,
                                            const std::vector<rodpack::Touching>& touching) {
  const bool planar = options_.kernel->dimension() == 2;
  rodpack::Particle particle;
  const std::vector<BodyChain> chains = body_chains(lmp, particles);
  for (int k = 0; k < static_cast<int>(chains.size()); ++k) {
    Multisphere& data = particles.bodies()->data();
    data.xcm(particle.centre.data(), k);
    data.vcm(particle.velocity.data(), k);
    particle.mass = data.mass(k);
    particle.extent = planar ? chains[k].area : volume(chains[k], data.nrigid(k));
    particle.touching = touching[data.tag(k)];
    averages_.add(particle);
  }
  for (int i = 0; i < atom->nlocal; ++i) {
    if (particles.body_of(i) >= 0) continue;
    const double r = atom->radius[i];
    vectorCopy3D(atom->x[i], particle.centre.data());
    vectorCopy3D(atom->v[i], particle.velocity.data());
    particle.mass = atom->rmass[i];
    particle.extent = MathConst::MY_PI * r * r * (planar ? 1.0 : 4.0 / 3.0 * r);
    particle.touching = touching[particles.id_of(i)];
    averages_.add(particle);
  }
}

}  // namespace LAMMPS_NS
