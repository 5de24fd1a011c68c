// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_REPORT_OUTPUTS_H
#define RODPACK_REPORT_OUTPUTS_H

#include <string>

#include "analysis/contact_forces.h"
#include "analysis/janssen_fit.h"
#include "analysis/orientation.h"
#include "analysis/pairs/rdf_sums.h"
#include "analysis/pressure_profile.h"
#include "analysis/space/axial_rdf.h"
#include "analysis/space/fabric.h"
#include "analysis/space/fields/spatial_fields.h"
#include "analysis/space/spatial_orientation.h"
#include "analysis/space/vertical_profile.h"

namespace rodpack {

// The tables and figures of a measure, as its subcommand and analyse_run() write them, in files
// whose names begin with `stem`. Each returns these names for the terminal,
// "rdf.csv .png .svg". @throws DataError when a file cannot be written or drawing fails.

std::string write_orientation(const OrientationDistribution& distribution, const std::string& stem);
std::string write_orientation(const SpatialOrientation& orientation, const std::string& stem);
std::string write_rdf(const Rdf& rdf, const std::string& stem);
std::string write_axial_rdf(const AxialRdf& rdf, const std::string& stem);
std::string write_contact_forces(const ContactForces& forces, const std::string& stem);
std::string write_fabric(const Fabric& fabric, const std::string& stem);
/// `fit`: drawn too, unless null.
std::string write_profile(const PressureProfile& profile, const JanssenFit* fit,
                          const std::string& stem);
std::string write_profile(const VerticalProfile& profile, const JanssenFit* fit,
                          const std::string& stem);
std::string write_layers(const VerticalProfile& profile, const std::string& stem);

/// The fields on the grid, and in a cylinder their means over rings; `names`: of the fields, all
/// if empty. `time`: s.
std::string write_fields(const SpatialFieldSample& sample, const std::vector<std::string>& names,
                         double time, const std::string& stem);
/// Maps of the slices, `stem` and `stem`_across of middle_slices(), else with the names of the
/// slices behind it, and in a cylinder of the rings.
std::string draw_pressure_maps(const SpatialFieldSample& sample, const std::string& stem);
std::string draw_solid_fraction_maps(const SpatialFieldSample& sample, const std::string& stem);

}  // namespace rodpack

#endif
