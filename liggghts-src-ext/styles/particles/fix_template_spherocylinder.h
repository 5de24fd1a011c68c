// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef FIX_CLASS

// clang-format off
FixStyle(particletemplate/multisphere/spherocylinder,FixTemplateSpherocylinder)
// clang-format on

#else

#ifndef RODPACK_FIX_TEMPLATE_SPHEROCYLINDER_H
#define RODPACK_FIX_TEMPLATE_SPHEROCYLINDER_H

#include <memory>

#include "fix_template_multisphere.h"

namespace LAMMPS_NS {

class ParticleToInsertSpherocylinder;
struct Spherocylinder;
struct SpherocylinderOptions;

/// fix particletemplate/multisphere/spherocylinder: a template of straight or curved
/// spherocylinders for fix insert/*, with exact mass properties where fix
/// particletemplate/multisphere samples them, and a diameter drawn for each particle.
class FixTemplateSpherocylinder : public FixTemplateMultisphere {
 public:
  FixTemplateSpherocylinder(LAMMPS* lmp, int narg, char** arg);
  ~FixTemplateSpherocylinder();

  void post_create();
  void init();
  void setup(int);

  double min_rad();
  double max_rad();

  void randomize_single();
  void init_ptilist(int n, const bool enforce_single = false,
                    FixPropertyAtom* const release = NULL);
  void randomize_ptilist(int n, int distribution_groupbit, int distorder);

  /// Makes `pti` the particle that a draw from [0, 1) stands for, at the origin in its body frame.
  void prepare_single(double draw);

 private:
  class StockArguments;
  FixTemplateSpherocylinder(LAMMPS* lmp, const SpherocylinderOptions& options,
                            StockArguments&& stock);

  const Spherocylinder& particle(double draw);
  void prepare(ParticleToInsertSpherocylinder& insertion, double draw);

  const std::unique_ptr<const SpherocylinderOptions> options_;
  std::unique_ptr<Spherocylinder> drawn_;
};

}  // namespace LAMMPS_NS

#endif
#endif
