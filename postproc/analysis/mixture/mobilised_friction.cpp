// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/mixture/mobilised_friction.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "reading/checks/body_axes.h"
#include "reading/csv_file.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {

constexpr double sliding = 0.999;

double mobilised(const FrictionalContact& contact) {
  return std::min(contact.tangential / (contact.coefficient * contact.normal), 1.0);
}

}  // namespace

FrictionOfContacts::FrictionOfContacts(const Frame& contacts, const FrictionTable& table)
    : contacts_(contacts), table_(table) {
  if (table.size() == 1) return;
  wall_ = &contacts.column("wall");
  first_ = &contacts.column("type_i");
  second_ = &contacts.column("type_j");
}

// An atom type of the table, counted from 1.
int FrictionOfContacts::type_of(std::size_t row, bool second, int least) const {
  const double type = (second ? *second_ : *first_)[row];
  if (type < least || type > static_cast<double>(table_.size()))
    throw DataError(at_row(contacts_, row) + "column '" + (second ? "type_j" : "type_i") +
                    "': expected an atom type of the scene's friction, " + std::to_string(least) +
                    " to " + std::to_string(table_.size()) + ", found " + number_text(type));
  return static_cast<int>(type);
}

// Of a sphere and a wall whose type is not told.
double FrictionOfContacts::with_any(std::size_t row, int type) const {
  const auto& all = table_[static_cast<std::size_t>(type - 1)];
  if (std::all_of(all.begin(), all.end(), [&](double each) { return each == all[0]; }))
    return all[0];
  throw DataError(at_row(contacts_, row) + "expected the wall's atom type, since spheres of type " +
                  std::to_string(type) +
                  " have another friction with each, found none: LIGGGHTS's own dumps do not tell "
                  "it; 'dump contact/gran' does, and --friction gives one");
}

FrictionalContact FrictionOfContacts::of(std::size_t row, double normal, double tangential) const {
  if (table_.size() == 1) return {normal, tangential, 0, 0, table_[0][0]};
  const int i = type_of(row, false, 1);
  const int j = type_of(row, true, (*wall_)[row] != 0 ? 0 : 1);
  const double coefficient =
      j == 0 ? with_any(row, i)
             : table_[static_cast<std::size_t>(i - 1)][static_cast<std::size_t>(j - 1)];
  return {normal, tangential, std::min(i, j), std::max(i, j), coefficient};
}

std::optional<MobilisedFriction> mobilised_friction(
    const std::vector<FrictionalContact>& contacts) {
  constexpr std::size_t bins = 20;
  constexpr double width = 1.0 / bins;
  MobilisedFriction result;
  result.count.assign(bins, 0);
  std::map<std::pair<int, int>, FrictionOfTypes> pairs;
  std::size_t number = 0;
  for (const auto& contact : contacts) {
    const double mu = contact.coefficient;
    if (!(mu > 0)) {
      ++result.frictionless;
      continue;
    }
    result.lowest = number == 0 ? mu : std::min(result.lowest, mu);
    result.highest = std::max(result.highest, mu);
    ++number;
    const double ratio = mobilised(contact);
    auto& pair = pairs[{contact.lower_type, contact.upper_type}];
    pair.lower_type = contact.lower_type;
    pair.upper_type = contact.upper_type;
    pair.coefficient = mu;
    ++pair.contacts;
    pair.mean += ratio;
    result.mean += ratio;
    if (ratio >= sliding) {
      ++pair.sliding_fraction;
      ++result.sliding_fraction;
    }
    result.count[std::min(static_cast<std::size_t>(ratio / width), bins - 1)] += 1;
  }
  if (number == 0) return std::nullopt;
  const auto n = static_cast<double>(number);
  result.mean /= n;
  result.sliding_fraction /= n;
  for (std::size_t k = 0; k < bins; ++k) {
    result.centre.push_back((static_cast<double>(k) + 0.5) * width);
    const double p = result.count[k] / n;
    result.density.push_back(p / width);
    result.standard_error.push_back(std::sqrt(p * (1 - p) / n) / width);
  }
  if (pairs.begin()->first.second == 0) return result;  // one coefficient of all
  for (auto& [types, pair] : pairs) {
    pair.mean /= static_cast<double>(pair.contacts);
    pair.sliding_fraction /= static_cast<double>(pair.contacts);
    result.by_type.push_back(pair);
  }
  return result;
}

std::string write_friction_tables(const MobilisedFriction& friction, const std::string& stem) {
  write_csv(stem + ".csv", {{"mobilised_friction", friction.centre},
                            {"count", friction.count},
                            {"probability_density", friction.density},
                            {"standard_error", friction.standard_error}});
  if (friction.by_type.empty()) return "";
  const auto column = [&](auto value) {
    std::vector<double> values;
    for (const auto& pair : friction.by_type) values.push_back(static_cast<double>(value(pair)));
    return values;
  };
  using Pair = const FrictionOfTypes&;
  write_csv(stem + "_types.csv",
            {{"lower_type", column([](Pair pair) { return pair.lower_type; })},
             {"upper_type", column([](Pair pair) { return pair.upper_type; })},
             {"friction", column([](Pair pair) { return pair.coefficient; })},
             {"contacts", column([](Pair pair) { return pair.contacts; })},
             {"mobilised_friction_mean", column([](Pair pair) { return pair.mean; })},
             {"sliding_fraction", column([](Pair pair) { return pair.sliding_fraction; })}});
  return stem + "_types.csv";
}

}  // namespace rodpack
