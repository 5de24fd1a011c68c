// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef INTEGRATE_CLASS

// clang-format off
IntegrateStyle(verlet/planar,RunPlanar)
// clang-format on

#else

#ifndef LMP_RUN_PLANAR_H
#define LMP_RUN_PLANAR_H

#include <memory>
#include <vector>
#include "planar_contacts.h"
#include "rodpack/planar_instructions.h"
#include "verlet.h"

namespace rodpack {
class PlanarScene;
}

namespace LAMMPS_NS {

/// Runs a planar scene of rigid bodies in an engine of its own (rodpack/planar_scene.h) wherever
/// nobody looks: between two steps of output, insertion or a fix that acts at the end of a step,
/// the bodies and contacts are taken from LIGGGHTS and given back in the step before. The step that
/// somebody sees is LIGGGHTS's own, with everything that belongs to it.
class RunPlanar : public Verlet {
 public:
  RunPlanar(class LAMMPS* lmp, int narg, char** arg);
  ~RunPlanar();

  void setup() override;
  void setup_minimal(int) override;
  void run(int steps) override;

 private:
  void refuse(const std::string& what) const;
  void check();
  void check_scene();
  void check_fixes() const;
  void sort_atoms_by_body();
  bigint next_look() const;
  void run_engine(bigint steps);
  void take_over();
  void give_back();

  void read_options(int narg, char** arg);

  double min_skin_, max_skin_;  // m; 0: from the particles
  rodpack::PlanarInstructions instructions_ = rodpack::PlanarInstructions::automatic;
  class FixMultisphereAB* bodies_ = NULL;
  class FixGravity* gravity_ = NULL;
  PlanarContacts contacts_;
  std::vector<std::vector<int> > atoms_;  // of each body
  std::vector<PlanarPlace> places_;       // of each atom
  std::unique_ptr<rodpack::PlanarScene> scene_;
};

}  // namespace LAMMPS_NS

#endif
#endif
