// SPDX-License-Identifier: GPL-2.0-or-later
#include "running_dashpots.h"

#include <algorithm>
#include <cstdio>
#include <string>

#include "fix_property_global.h"
#include "modify.h"
#include "rodpack/contact/dashpot_relaxation.h"
#include "stop_run.h"

namespace LAMMPS_NS {

std::vector<int> running_orders(LAMMPS* lmp) {
  std::vector<int> orders;
  for (int i = 0; i < lmp->modify->nfix; ++i) {
    int dimension = 0;
    const void* const order = lmp->modify->fix[i]->extract("multistep_order", dimension);
    if (order) orders.push_back(*static_cast<const int*>(order));
  }
  return orders;
}

int highest_running_order(LAMMPS* lmp) {
  int highest = 0;
  for (const int order : running_orders(lmp)) highest = std::max(highest, order);
  return highest;
}

double dashpot_relaxation(LAMMPS* lmp) {
  const char* const name = "dashpotRelaxation";
  for (int i = 0; i < lmp->modify->nfix; ++i) {
    auto* const property = dynamic_cast<FixPropertyGlobal*>(lmp->modify->fix[i]);
    // One of another kind than a scalar ends the run.
    if (!property || !property->check_fix(name, "scalar", 0, 0, "model spring_dashpot", true))
      continue;
    const double time = property->compute_scalar();
    if (time >= 0.0 && time <= 1e15) return time;
    char text[160];
    std::snprintf(text, sizeof text,
                  "property/global %s is '%.15g', expected a relaxation time (s) in [0, 1e15], "
                  "0 for none",
                  name, time);
    stop_run(lmp, text);
  }
  return 0.0;
}

void RunningDashpots::connect(LAMMPS* lmp) {
  relaxation_ = dashpot_relaxation(lmp);
  of_dt_ = 0.0;
  const int order = highest_running_order(lmp);
  if (relaxation_ > 0.0 && order > 0)
    stop_run(lmp,
             "property/global dashpotRelaxation: the integrator that runs is of order " +
                 std::to_string(order) +
                 ", expected velocity Verlet: 'fix multisphere/ab order 0', or LIGGGHTS's own");
}

void RunningDashpots::set_kept(double dt) const {
  of_dt_ = dt;
  kept_ = rodpack::kept_in_step(relaxation_, dt);
}

}  // namespace LAMMPS_NS
