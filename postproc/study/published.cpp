// SPDX-License-Identifier: GPL-2.0-or-later
#include "study/published.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "campaigns/launch/deck_folder.h"
#include "reading/table.h"
#include "study/study_case.h"

namespace rodpack {
namespace {

// The numbers that a study has whatever its cases are; any other one of the ensemble will do too.
const std::vector<std::string>& known_quantities() {
  static const std::vector<std::string> names = {
      "solid_fraction",       "solid_fraction_to_3_omega_below_surface",
      "nematic_order_S2",     "covered_area_over_area_below_surface",
      "coordination_number",  "contacts_per_particle",
      "mean_normal_force_N",  "mean_tangential_force_N",
      "janssen_pressure_N_m", "janssen_depth_over_dp",
      "sliding_fraction",     "mobilised_friction_mean",
      "bed_height_m",         "director_deg"};
  return names;
}

bool known_case(const std::string& name, const Ensemble& ensemble) {
  return study_case(name) ||
         std::any_of(ensemble.cases.begin(), ensemble.cases.end(),
                     [&](const EnsembleCase& each) { return each.name == name; });
}

bool known_quantity(const std::string& name, const Ensemble& ensemble) {
  const auto& known = known_quantities();
  return std::find(known.begin(), known.end(), name) != known.end() ||
         std::any_of(ensemble.cases.begin(), ensemble.cases.end(),
                     [&](const EnsembleCase& each) { return each.numbers.count(name) > 0; });
}

// A unit of the last printed digit: 0.87 -> 0.01, 1.2e-3 -> 1e-4.
double last_digit(const std::string& text) {
  const auto exponent_at = text.find_first_of("eE");
  // Of a number that a double holds; "0e99999999999" is one.
  const long exponent =
      exponent_at == std::string::npos
          ? 0
          : std::clamp(std::strtol(text.c_str() + exponent_at + 1, nullptr, 10), -400L, 400L);
  const auto digits = text.substr(0, exponent_at);
  const auto point = digits.find('.');
  const auto decimals =
      point == std::string::npos ? 0 : static_cast<int>(digits.size() - point) - 1;
  return std::pow(10.0, static_cast<double>(exponent - decimals));
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

std::string find_published(const std::string& given, const std::string& study) {
  if (!given.empty()) return given;
  const auto own = std::filesystem::path(study) / "published.csv";
  return std::filesystem::exists(own) ? own.string() : find_deck("study/published.csv", "");
}

std::vector<PublishedValue> read_published(const std::string& file, const Ensemble& ensemble) {
  const Table table = read_table(file);
  const auto &cases = table.words("case"), &quantities = table.words("quantity");
  const auto &values = table.column("value"), &errors = table.column("error");
  std::set<std::pair<std::string, std::string>> seen;
  std::vector<PublishedValue> published;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (!known_case(cases[row], ensemble))
      table.refuse(row, "case",
                   "a case of the study, or a name like spheres, coarse-AR2, smooth-AR2 or "
                   "curved-AR5-theta60");
    if (!known_quantity(quantities[row], ensemble))
      table.refuse(row, "quantity", "one of " + listed(known_quantities()));
    if (!std::isfinite(values[row])) table.refuse(row, "value", "a finite number");
    if (!(errors[row] >= 0) || !std::isfinite(errors[row]))
      table.refuse(row, "error", "a finite number, at least 0");
    if (!seen.insert({cases[row], quantities[row] + "," + table.words("source")[row]}).second)
      table.refuse(row, "case", "one line per case, quantity and source");
    published.push_back({cases[row], quantities[row], values[row], errors[row],
                         last_digit(table.words("value")[row]) / std::sqrt(12),
                         table.words("source")[row]});
  }
  return published;
}

std::optional<double> PublishedComparison::deviation() const {
  if (!published || !combined_error || !(*combined_error > 0)) return std::nullopt;
  return difference / *combined_error;
}

std::vector<PublishedComparison> compare_with_published(
    const Ensemble& ensemble, const std::vector<PublishedValue>& published,
    const std::string& quantity) {
  // The paper names no distance from the surface: its values stand beside either average.
  const bool fraction = quantity == "solid_fraction_to_3_omega_below_surface";
  std::vector<PublishedComparison> rows;
  for (const auto& each : ensemble.cases) {
    const auto* measured = number_of(&each, quantity);
    if (!measured) continue;
    PublishedComparison row;
    row.case_name = each.name;
    row.quantity = quantity;
    row.measured = *measured;
    bool any = false;
    for (const auto& value : published) {
      const bool meant =
          value.quantity == quantity || (fraction && value.quantity == "solid_fraction");
      if (value.case_name != each.name || !meant) continue;
      any = true;
      row.published = value;
      row.difference = measured->mean - value.value;
      row.combined_error.reset();
      if (measured->sem)
        row.combined_error = std::sqrt(*measured->sem * *measured->sem + value.error * value.error +
                                       value.rounding * value.rounding);
      rows.push_back(row);
    }
    const auto meaning = study_case(each.name);
    if (!any && (!meaning || meaning->variation.empty())) rows.push_back(row);
  }
  return rows;
}

}  // namespace rodpack
