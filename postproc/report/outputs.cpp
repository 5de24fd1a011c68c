// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/outputs.h"

#include <algorithm>

#include "figures/contact_forces_figure.h"
#include "figures/orientation_figure.h"
#include "figures/profile_figure.h"
#include "figures/rdf_figure.h"
#include "figures/space/axial_rdf_figure.h"
#include "figures/space/direction_figure.h"
#include "figures/space/section_figure.h"
#include "figures/space/vertical_profile_figure.h"

namespace rodpack {
namespace {

std::string table_and_figure(const std::string& stem) { return stem + ".csv .png .svg"; }
std::string figure_alone(const std::string& stem) { return stem + ".png .svg"; }

using PlotSection = void (*)(const Section&, const SpatialFieldSample&, const std::string&);

std::string draw_maps(const SpatialFieldSample& sample, PlotSection plot, const std::string& stem) {
  std::string written;
  const auto draw = [&](const Section& section, const std::string& name) {
    plot(section, sample, name);
    written += (written.empty() ? "" : ", ") + figure_alone(name);
  };
  const auto sections = sample.sections();
  for (std::size_t k = 0; k < sections.size(); ++k) {
    const std::string ending = sample.slices_are_given() ? "_" + sample.slices()[k].name()
                               : k == 0                  ? ""
                                                         : "_across";
    draw(sections[k], stem + ending);
  }
  if (const auto rings = sample.rings()) draw(*rings, stem + "_rings");
  return written;
}

std::vector<Field> fields_named(std::vector<Field> fields, const std::vector<std::string>& names) {
  if (names.empty()) return fields;
  std::vector<Field> kept;
  for (const auto& name : names) kept.push_back(field_named(fields, name));
  return kept;
}

}  // namespace

std::string write_orientation(const OrientationDistribution& distribution,
                              const std::string& stem) {
  write_orientation_table(distribution, stem + ".csv");
  plot_orientation_linear(distribution, stem);
  plot_orientation_polar(distribution, stem + "_polar");
  return table_and_figure(stem) + ", " + figure_alone(stem + "_polar");
}

std::string write_orientation(const SpatialOrientation& orientation, const std::string& stem) {
  write_direction_table(orientation.polar, "polar", stem + ".csv");
  write_direction_table(orientation.azimuth, "azimuth", stem + "_azimuth.csv");
  write_order_table(orientation.order, orientation.vertical, stem + "_order.csv");
  plot_polar_angle(orientation.polar, "particle", orientation.vertical, stem);
  plot_azimuth(orientation.azimuth, "particle", orientation.vertical, stem + "_azimuth");
  return table_and_figure(stem) + ", " + table_and_figure(stem + "_azimuth") + ", " + stem +
         "_order.csv";
}

std::string write_rdf(const Rdf& rdf, const std::string& stem) {
  write_rdf_table(rdf, stem + ".csv");
  plot_rdf(rdf, stem);
  return table_and_figure(stem);
}

std::string write_axial_rdf(const AxialRdf& rdf, const std::string& stem) {
  write_axial_rdf_table(rdf, stem + ".csv");
  plot_axial_rdf(rdf, stem);
  return table_and_figure(stem);
}

std::string write_contact_forces(const ContactForces& forces, const std::string& stem) {
  const auto of_types = write_contact_force_tables(forces, stem);
  plot_contact_forces(forces, stem);
  return table_and_figure(stem) + ", " +
         (forces.friction ? table_and_figure(stem + "_friction") + ", " : "") +
         (of_types.empty() ? "" : of_types + ", ") + table_and_figure(stem + "_coordination");
}

std::string write_fabric(const Fabric& fabric, const std::string& stem) {
  write_fabric_table(fabric, stem + ".csv");
  write_order_table(fabric.order, fabric.vertical, stem + "_order.csv");
  plot_fabric(fabric, stem);
  return table_and_figure(stem) + ", " + stem + "_order.csv";
}

std::string write_profile(const PressureProfile& profile, const JanssenFit* fit,
                          const std::string& stem) {
  write_profile_table(profile, stem + ".csv");
  plot_profile(profile, fit, stem);
  return table_and_figure(stem);
}

std::string write_profile(const VerticalProfile& profile, const JanssenFit* fit,
                          const std::string& stem) {
  write_vertical_profile_table(profile, stem + ".csv");
  plot_vertical_stresses(profile, fit, stem);
  return table_and_figure(stem);
}

std::string write_layers(const VerticalProfile& profile, const std::string& stem) {
  write_layer_table(profile, stem + ".csv");
  plot_layers(profile, stem);
  return table_and_figure(stem);
}

std::string write_fields(const SpatialFieldSample& sample, const std::vector<std::string>& names,
                         double time, const std::string& stem) {
  write_fields(sample.averages(), fields_named(sample.fields(), names), time, stem);
  std::string written = stem + ".vti .csv";
  if (auto rings = sample.rings()) {
    rings->fields = fields_named(rings->fields, names);
    write_section_table(*rings, sample.packing().particle_diameter, stem + "_rings.csv");
    written += ", " + stem + "_rings.csv";
  }
  return written;
}

std::string draw_pressure_maps(const SpatialFieldSample& sample, const std::string& stem) {
  return draw_maps(sample, plot_section_pressure, stem);
}

std::string draw_solid_fraction_maps(const SpatialFieldSample& sample, const std::string& stem) {
  return draw_maps(sample, plot_section_solid_fraction, stem);
}

}  // namespace rodpack
