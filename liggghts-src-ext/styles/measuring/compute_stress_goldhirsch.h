// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef COMPUTE_CLASS
// clang-format off
ComputeStyle(stress/goldhirsch,ComputeStressGoldhirsch)
// clang-format on
#else
#ifndef LMP_COMPUTE_STRESS_GOLDHIRSCH_H
#define LMP_COMPUTE_STRESS_GOLDHIRSCH_H

#include <vector>
#include "averaging_options.h"
#include "compute.h"
#include "contact_recorder.h"

namespace LAMMPS_NS {

/// compute stress/goldhirsch: coarse-grained fields of the particles as rigid bodies
/// (rodpack::CoarseGraining) at the places of a grid or at given points. Its global array has a row
/// per place, with its coordinates and then the components of all fields; see
/// doc/compute_stress_goldhirsch.md.
class ComputeStressGoldhirsch : public Compute {
 public:
  ComputeStressGoldhirsch(class LAMMPS* lmp, int& iarg, int narg, char** arg);
  ~ComputeStressGoldhirsch();
  void init();
  void compute_array();
  double memory_usage();

  /// The fields of this step, evaluated if they are not yet; collective.
  const std::vector<rodpack::Field>& current_fields();
  /// The places; sums are those of this rank.
  const rodpack::CoarseGraining& places() const { return averages_; }

 private:
  void evaluate();
  void add_particles(const class ParticleIdentity& particles,
                     const std::vector<rodpack::Touching>& touching);

  AveragingOptions options_;
  rodpack::CoarseGraining averages_;
  std::vector<rodpack::Field> fields_;
  ContactRecorder recorder_;
};

}  // namespace LAMMPS_NS

#endif
#endif
