// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_STYLE_LAWS_H
#define RODPACK_STYLE_LAWS_H

#include <initializer_list>

#include "rodpack/contact/rolling_spring.h"

namespace LAMMPS_NS {

/// Whether the models of pair_style gran, or of a fix wall/gran, report their contacts to a
/// ContactRecorder themselves, with the whole force.
template <class Style>
bool reports_itself(Style* style) {
  if (!style->contact_match("normal", "spring_dashpot")) return false;
  // The tangential model reports after the cohesion, the normal one before.
  return style->contact_match("tangential", "spring_dashpot") ||
         (style->contact_match("tangential", "off") && style->contact_match("cohesion", "off"));
}

/// With which power of the overlap the elastic normal force grows; 0 if it is no function of the
/// overlap: it depends on what the contact has been through, or there is no normal model.
template <class Style>
double exponent_of(Style* style) {
  for (const char* linear : {"spring_dashpot", "hooke", "hooke/stiffness"})
    if (style->contact_match("normal", linear)) return 1.0;
  for (const char* hertzian : {"hertz", "hertz/stiffness"})
    if (style->contact_match("normal", hertzian)) return 1.5;
  return 0.0;
}

template <class Style>
rodpack::RollingLaw rolling_law_of(Style* style) {
  if (style->contact_match("rolling_friction", "epsd")) return rodpack::RollingLaw::epsd;
  if (style->contact_match("rolling_friction", "epsd2")) return rodpack::RollingLaw::epsd2;
  if (style->contact_match("rolling_friction", "epsd3")) return rodpack::RollingLaw::epsd3;
  return rodpack::RollingLaw::none;
}

/// Whether all forces of a contact are those of springs and dashpots against small motions; every
/// dashpot beside a spring, or none.
template <class Style>
bool has_springs_alone(Style* style) {
  const auto is_one_of = [style](const char* kind, std::initializer_list<const char*> names) {
    for (const char* name : names)
      if (style->contact_match(kind, name)) return true;
    return false;
  };
  return exponent_of(style) > 0.0 &&
         is_one_of("tangential", {"off", "spring_dashpot", "history"}) &&
         is_one_of("rolling_friction", {"off", "cdt", "epsd", "epsd2", "epsd3"});
}

}  // namespace LAMMPS_NS

#endif
