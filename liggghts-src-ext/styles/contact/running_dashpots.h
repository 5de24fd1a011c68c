// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_RUNNING_DASHPOTS_H
#define RODPACK_RUNNING_DASHPOTS_H

#include <vector>

namespace LAMMPS_NS {

class LAMMPS;

/// Orders of the multistep integrators among the fixes; 0 is leapfrog, or velocity Verlet, which
/// LIGGGHTS's own are without a word.
std::vector<int> running_orders(LAMMPS* lmp);
/// The highest of them, 0 without one.
int highest_running_order(LAMMPS* lmp);

/// The relaxation time of the dashpots of models spring_dashpot, s: of fix property/global
/// dashpotRelaxation; 0 without one.
double dashpot_relaxation(LAMMPS* lmp);

/// What the models of a contact have to know of that time in a step.
class RunningDashpots {
 public:
  /// To be called before a run. Stops where the integrator has no use for a relaxation time.
  void connect(LAMMPS* lmp);
  /// The share of what a dashpot felt one step of length `dt` (s) ago that it feels still.
  double kept(double dt) const {
    if (dt != of_dt_) set_kept(dt);
    return kept_;
  }

 private:
  void set_kept(double dt) const;

  double relaxation_ = 0.0;
  mutable double of_dt_ = 0.0, kept_ = 0.0;
};

}  // namespace LAMMPS_NS

#endif
