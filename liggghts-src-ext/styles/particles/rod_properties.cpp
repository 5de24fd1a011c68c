// SPDX-License-Identifier: GPL-2.0-or-later
#include "rod_properties.h"

#include "multisphere.h"

namespace LAMMPS_NS {

namespace {

ScalarContainer<double>* find_or_add(Multisphere& bodies, const char* name) {
  auto* property = bodies.prop().getElementProperty<ScalarContainer<double>>(name);
  if (property) return property;
  const int scale_power = 1;
  property = bodies.prop().addElementProperty<ScalarContainer<double>>(
      name, "comm_exchange_borders", "frame_invariant", "restart_no", scale_power, bodies.n_body());
  property->setDefaultValue(0.);
  return property;
}

}  // namespace

RodProperties rod_properties(Multisphere& bodies) {
  return {find_or_add(bodies, "rod_half_length"), find_or_add(bodies, "rod_radius"),
          find_or_add(bodies, "rod_curvature"), find_or_add(bodies, "rod_area")};
}

}  // namespace LAMMPS_NS
