// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef FIX_CLASS

// clang-format off
FixStyle(nve/sphere/ab,FixNVESphereAB)
// clang-format on

#else

#ifndef RODPACK_FIX_NVE_SPHERE_AB_H
#define RODPACK_FIX_NVE_SPHERE_AB_H

#include <vector>

#include "fix.h"
#include "multistep_options.h"

namespace LAMMPS_NS {

/// fix nve/sphere/ab: advances single spheres by Adams-Bashforth steps of order 1 to 4, as
/// multisphere/ab does with bodies. The rates of the past live in fix property/atom, so that they
/// follow the sphere through sorting, exchange between ranks and restarts.
class FixNVESphereAB : public Fix {
 public:
  FixNVESphereAB(class LAMMPS*, int, char**);

  void post_create() override;
  void pre_delete(bool unfixflag) override;
  int setmask() override;
  void init() override;
  void initial_integrate(int) override;
  void reset_dt() override;
  /// Tells the tangential contact models the "multistep_order", an int*.
  void* extract(const char*, int&) override;

 private:
  class FixPropertyAtom* add_property(const char* name, int values);
  void restart_history_after_change();
  void advance(int i);

  MultistepOptions options_;
  int order_;
  bool planar_;
  double inertia_factor_;  // moment of inertia / (mass radius^2)
  class FixMultisphere* bodies_;

  class FixPropertyAtom* state_;  // force evaluations since birth (capped), time step, order
  std::vector<class FixPropertyAtom*> past_;  // rates, newest first
};

}  // namespace LAMMPS_NS

#endif
#endif
