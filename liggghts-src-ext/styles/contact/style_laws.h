// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_STYLE_LAWS_H
#define RODPACK_STYLE_LAWS_H

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

}  // namespace LAMMPS_NS

#endif
