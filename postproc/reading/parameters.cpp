// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/parameters.h"

#include <filesystem>
#include <map>

#include "reading/checks/number_range.h"
#include "reading/data_error.h"
#include "reading/json_file.h"
#include "reading/parsing.h"

namespace rodpack {

namespace {

/// What the parameters of a deck that the post-processor reads may be.
NumberRange parameter_range(const std::string& key) {
  static const std::map<std::string, NumberRange> known{
      {"aspect_ratio", {1, 1000}},
      {"particle_diameter_m", {1e-12, 1e3}},
      {"container_width_m", {1e-12, 1e6}},
      {"timestep_s", {1e-30, 1e6}},
      {"gravity_m_s2", {0, 1e9}},
      {"density_kg_m3", {0, 1e9, false, true}},
      {"friction", {0, 1000}},
      {"inclination_deg", {0, 89}},
      {"orifice_width_m", {1e-12, 1e6}},
      {"close_after_s", {0, 1e9}},
      {"normal_stiffness_N_m", {0, 1e15, false, true}},
      {"tangential_stiffness_N_m", {0, 1e15}},
      {"damping_ratio_normal", {0, 1}},
      {"damping_ratio_tangential", {0, 1}},
      {"overlap", {0, 0.9999}},
      {"curvature_deg", {0, 180}},
      {"mass_scaling", {0, 1e9}},
      {"half_angle_deg", {0, 90, false, true}},
  };
  const auto found = known.find(key);
  constexpr double largest = 1e300;
  return found == known.end() ? NumberRange{-largest, largest} : found->second;
}

}  // namespace

double RunParameters::number(const std::string& key) const {
  const auto found = values.find(key);
  if (found == values.end()) throw DataError(file + ": no key '" + key + "'");
  const auto range = parameter_range(key);
  if (!found->is_number() || !range.contains(found->get<double>()))
    throw DataError(file + ": key '" + key + "': expected " + range.text() + ", found " +
                    shortened(found->dump()));
  return found->get<double>();
}

double RunParameters::positive_number(const std::string& key) const {
  const double value = number(key);
  if (!(value > 0))
    throw DataError(file + ": key '" + key + "': expected a number above 0, found " +
                    shortened(values.at(key).dump()));
  return value;
}

RunParameters read_parameters(const std::string& file) {
  nlohmann::json values = read_json_object(file);
  const auto units = values.value("units", nlohmann::json("si"));
  if (units != "si")
    throw DataError(file +
                    ": key 'units': expected \"si\", in whose units all is labelled, found " +
                    shortened(units.dump()));
  return {file, std::move(values)};
}

std::optional<RunParameters> find_parameters(const std::string& dump, const std::string& given) {
  if (!given.empty()) return read_parameters(given);
  const auto folder = std::filesystem::absolute(dump).parent_path();
  for (const auto& candidate : {folder, folder.parent_path()}) {
    const auto path = candidate / "parameters.json";
    if (std::filesystem::exists(path)) return read_parameters(path.string());
  }
  return std::nullopt;
}

}  // namespace rodpack
