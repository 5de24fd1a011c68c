// SPDX-License-Identifier: GPL-2.0-or-later
#include "page/words.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <utility>
#include <vector>

#include "page/html.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {

const std::vector<std::pair<std::string, std::string>>& units() {  // the longer ending first
  static const std::vector<std::pair<std::string, std::string>> all{
      {"_per_deg", "1/°"}, {"_over_dp", "<i>d</i><sub>p</sub>"},
      {"_kg_m3", "kg/m³"}, {"_kg_m2", "kg/m²"},
      {"_m_s2", "m/s²"},   {"_m_s", "m/s"},
      {"_N_m2", "N/m²"},   {"_N_m", "N/m"},
      {"_1_m2", "1/m²"},   {"_m2", "m²"},
      {"_deg", "°"},       {"_kg", "kg"},
      {"_N", "N"},         {"_J", "J"},
      {"_m", "m"},         {"_s", "s"}};
  return all;
}

// Labels of keys, without their units, that the key itself says badly.
const std::map<std::string, std::string>& result_labels() {
  static const std::map<std::string, std::string> all{
      {"solid_fraction", "solid fraction φ"},
      {"solid_fraction_from_3_omega_above_floor_to_surface",
       "solid fraction φ, central slice, from 3ω above the floor to the surface (the kernel "
       "averages "
       "over the empty space above it)"},
      {"solid_fraction_from_3_omega_above_floor_to_3_omega_below_surface",
       "solid fraction φ, central slice, from 3ω above the floor to 3ω below the surface"},
      {"solid_fraction_to_3_omega_below_surface", "solid fraction φ up to 3ω below the surface"},
      {"covered_area_over_area_below_surface",
       "area covered by particles / area of the bed below its surface"},
      {"omega", "coarse-graining scale ω"},
      {"nematic_order_S2", "nematic order <i>S</i><sub>2</sub>"},
      {"nematic_order_S2_pooled", "nematic order <i>S</i><sub>2</sub>, repetitions pooled"},
      {"sixfold_order_S6",
       "sixfold order of directions <i>S</i><sub>6</sub> = |⟨e<sup>6<i>i</i>γ</sup>⟩|"},
      {"mean_cos_6_gamma", "⟨cos 6γ⟩: positive for 0, 60, 120°, negative for 30, 90, 150°"},
      {"sixfold_bond_order_local", "sixfold bond order, mean |<i>ψ</i><sub>6</sub>|"},
      {"sixfold_bond_order_global", "sixfold bond order of all, |⟨<i>ψ</i><sub>6</sub>⟩|"},
      {"sixfold_bond_order_points", "points of the sixfold bond order"},
      {"director", "director, angle to the horizontal"},
      {"director_pooled", "director, repetitions pooled"},
      {"bed_height", "height of the bed"},
      {"orientation_particles", "particles in the orientation distribution"},
      {"orientation_left_out_closer_than_AR_dp_to_walls",
       "particles left out of it: closer than AR <i>d</i><sub>p</sub> to a wall"},
      {"rdf_centres", "centres of the radial distribution function"},
      {"rdf_margin", "least distance of those centres from walls and surface"},
      {"rdf_tail_mean", "<i>G</i>(<i>r</i>) at large <i>r</i>, has to be 1"},
      {"rdf_peak_g", "highest peak of <i>G</i>(<i>r</i>)"},
      {"rdf_peak_r", "distance <i>r</i> of that peak"},
      {"mean_normal_force", "mean normal force of a sphere contact"},
      {"mean_tangential_force", "mean tangential force of a sphere contact"},
      {"mobilised_friction_mean",
       "mean mobilised friction <i>f</i><sub>t</sub> / (μ <i>f</i><sub>n</sub>)"},
      {"sliding_fraction", "share of sliding contacts"},
      {"coordination_number", "particles that a particle touches, mean"},
      {"contacts_per_particle", "sphere contacts of a particle, mean"},
      {"rattlers", "particles without contact"},
      {"janssen_pressure", "Janssen fit, pressure <i>P</i><sub>j</sub> at depth"},
      {"janssen_depth", "Janssen fit, depth <i>h</i><sub>c</sub>"},
      {"janssen_depth_over_fitted_depth", "Janssen fit, <i>h</i><sub>c</sub> / fitted depth"},
      {"janssen_depth_of_mean_profile", "Janssen fit to the mean profile, <i>h</i><sub>c</sub>"},
      {"janssen_pressure_of_mean_profile", "Janssen fit to the mean profile, <i>P</i><sub>j</sub>"},
      {"janssen_rms_residual", "Janssen fit, rms residual"},
      {"order_tensor_S2", "order tensor, largest value <i>S</i><sub>2</sub>"},
      {"order_tensor_S2_without_bias", "<i>S</i><sub>2</sub> without its bias of order 1/N"},
      {"order_tensor_S2_of_as_many_isotropic_mean",
       "<i>S</i><sub>2</sub> of as many isotropic particles, mean"},
      {"order_tensor_S2_of_as_many_isotropic_standard_deviation",
       "<i>S</i><sub>2</sub> of as many isotropic particles, standard deviation"},
      {"order_tensor_second_value", "order tensor, second value"},
      {"order_tensor_third_value", "order tensor, smallest value (−½: none along its direction)"},
      {"order_about_vertical",
       "order about the vertical ⟨3 cos² − 1⟩ / 2: 1 upright, 0 isotropic, −½ flat"},
      {"director_from_vertical", "director, angle to the vertical"},
      {"director_azimuth", "director, azimuth about the vertical"},
      {"contact_normals_S2", "order tensor of the contact normals, largest value"},
      {"contact_normals_S2_without_bias", "the same without its bias of order 1/N"},
      {"contact_normals_S2_of_as_many_isotropic_mean",
       "the same of as many isotropic normals, mean"},
      {"contact_normals_S2_of_as_many_isotropic_standard_deviation",
       "the same of as many isotropic normals, standard deviation"},
      {"contact_normals_second_value", "order tensor of the contact normals, second value"},
      {"contact_normals_third_value", "order tensor of the contact normals, smallest value"},
      {"contact_normals_about_vertical", "order of the contact normals about the vertical"},
      {"rdf_axial_centres", "centres of the pair correlation along and across"},
      {"rdf_axial_margin", "least distance of those centres from walls and surface"},
      {"solid_fraction_of_cross_section_from_3_omega_above_floor_to_3_omega_below_surface",
       "solid fraction φ, whole cross-section, from 3ω above the floor to 3ω below the surface"},
      {"container_cross_section", "cross-section of the container"},
      {"vertical_axis", "axis that points up"},
      {"walls_from", "walls taken from"},
      {"kinetic_energy", "kinetic energy at the end"},
      {"elastic_energy", "elastic energy at the end"}};
  return all;
}

// The same for parameters, heads of tables and what a run took.
const std::map<std::string, std::string>& other_labels() {
  static const std::map<std::string, std::string> all{
      {"aspect_ratio", "aspect ratio AR"},
      {"particle_diameter", "diameter of the primary spheres <i>d</i><sub>p</sub>"},
      {"curvature", "curvature θ"},
      {"overlap", "overlap of neighbouring spheres"},
      {"friction", "friction coefficient μ"},
      {"damping_ratio_normal", "damping ratio η<sub>n</sub>"},
      {"damping_ratio_tangential", "damping ratio η<sub>t</sub>"},
      {"normal_stiffness", "normal stiffness <i>k</i><sub>n</sub>"},
      {"tangential_stiffness", "tangential stiffness <i>k</i><sub>t</sub>"},
      {"timestep_s", "time step"},
      {"timestep", "steps of the run"},
      {"time", "simulated time"},
      {"wall_time", "time the run took"},
      {"core_seconds", "processor time of all cores (s)"},
      {"sem", "standard error"},
      {"averaged_from", "averaged from"},
      {"published_error", "published error"},
      {"difference", "difference"},
      {"combined_error", "combined error"},
      {"difference_over_combined_error", "difference / combined error"},
      {"gamma", "γ"},
      {"r", "<i>r</i>"},
      {"width_in_lengths", "width of the container / axial length"},
      {"size_spread", "spread of the diameters, ±"}};
  return all;
}

}  // namespace

Wording wording(const std::string& key) {
  Wording result;
  std::string stem = key;
  for (const auto& [ending, unit] : units())
    if (key.size() > ending.size() &&
        key.compare(key.size() - ending.size(), ending.size(), ending) == 0) {
      result.unit = unit;
      stem = key.substr(0, key.size() - ending.size());
      break;
    }
  for (const auto* labels : {&result_labels(), &other_labels()})
    for (const auto& name : {key, stem})
      if (const auto known = labels->find(name); known != labels->end()) {
        result.label = known->second;
        return result;
      }
  std::replace(stem.begin(), stem.end(), '_', ' ');
  result.label = escaped(stem);
  return result;
}

std::string heading(const std::string& key, const std::string& unit) {
  auto label = wording(key).label;
  const auto small = [&](std::size_t at) {
    return at < label.size() && std::islower(static_cast<unsigned char>(label[at]));
  };
  if (small(0) && (small(1) || label[1] == ' '))
    label[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(label[0])));
  return unit.empty() ? label : label + " (" + unit + ")";
}

std::string heading(const std::string& key) { return heading(key, wording(key).unit); }

std::string particles_in_words(const nlohmann::ordered_json& parameters) {
  const auto number = [&](const char* key) {
    const auto value = parameters.find(key);
    return value != parameters.end() && value->is_number() ? value->get<double>() : 0.0;
  };
  const double ratio = number("aspect_ratio");
  if (!(ratio > 0)) return "particles";
  if (ratio == 1) return "spheres";
  const double curvature = number("curvature_deg");
  const auto surface = parameters.find("surface");
  std::string text = surface != parameters.end() && surface->is_string()
                         ? surface->get<std::string>() + " "
                         : std::string();
  text += std::string(curvature > 0 ? "curved " : "") +
          "spherocylinders of AR = " + number_text(ratio, 4);
  if (curvature > 0) text += ", θ = " + number_text(curvature, 4) + "°";
  return text;
}

}  // namespace rodpack
