// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <filesystem>
#include <limits>
#include <set>

#include "ensemble/ensemble.h"
#include "ensemble/mean_columns.h"
#include "reading/csv_file.h"
#include "reading/data_error.h"
#include "reading/json_file.h"
#include "reading/number_text.h"
#include "reading/text_file.h"

namespace rodpack {
namespace {
namespace fs = std::filesystem;
using OrderedJson = nlohmann::ordered_json;

constexpr const char* ensemble_format = "rodpack-ensemble 1";
constexpr const char* cost_format = "rodpack-cost 1";
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
// What the clock says, and no two runs agree in: kept in cost.json, so that ensemble.json is the
// same whenever and wherever it is made again.
const std::set<std::string> cost_numbers = {"wall_time_s", "core_seconds"};
// Keys of a case that are not numbers of it.
const std::set<std::string> other_keys = {"parameters", "runs", "seeds", "curves"};

OrderedJson number_or_null(double value) {
  return std::isfinite(value) ? OrderedJson(value) : OrderedJson(nullptr);
}
OrderedJson number_or_null(const std::optional<double>& value) {
  return number_or_null(value.value_or(unknown));
}

OrderedJson mean_json(const EnsembleMean& mean) {
  return {{"mean", number_or_null(mean.mean)}, {"sem", number_or_null(mean.sem)}, {"n", mean.n}};
}

OrderedJson curve_json(const EnsembleCurve& curve) {
  OrderedJson mean = OrderedJson::array(), sem = OrderedJson::array(), n = OrderedJson::array();
  for (const auto& y : curve.y) {
    mean.push_back(number_or_null(y.mean));
    sem.push_back(number_or_null(y.sem));
    n.push_back(y.n);
  }
  OrderedJson json = {
      {"abscissa", curve.abscissa}, {"x", curve.x}, {"mean", mean}, {"sem", sem}, {"n", n}};
  for (const auto& run : curve.of_runs) {
    OrderedJson values = OrderedJson::array();
    for (const double value : run) values.push_back(number_or_null(value));
    json["of_runs"].push_back(values);
  }
  return json;
}

OrderedJson case_json(const EnsembleCase& one) {
  OrderedJson json = {{"parameters", one.parameters}, {"runs", one.runs}, {"seeds", one.seeds}};
  for (const auto& [name, mean] : one.numbers)
    if (!cost_numbers.count(name)) json[name] = mean_json(mean);
  json["curves"] = OrderedJson::object();
  for (const auto& [name, curve] : one.curves) {
    const auto dot = name.find('.');
    json["curves"][name.substr(0, dot)][name.substr(dot + 1)] = curve_json(curve);
  }
  return json;
}

double number_or_nan(const OrderedJson& json) {
  return json.is_null() ? unknown : json.get<double>();
}

EnsembleMean mean_from(const OrderedJson& mean, const OrderedJson& sem, const OrderedJson& n) {
  EnsembleMean result{number_or_nan(mean), std::nullopt, n.get<int>()};
  if (!sem.is_null()) result.sem = sem.get<double>();
  return result;
}

EnsembleCurve curve_from(const OrderedJson& json) {
  EnsembleCurve curve{json.at("abscissa"), json.at("x").get<std::vector<double>>(), {}, {}};
  for (std::size_t k = 0; k < curve.x.size(); ++k)
    curve.y.push_back(mean_from(json.at("mean").at(k), json.at("sem").at(k), json.at("n").at(k)));
  for (const auto& run : json.value("of_runs", OrderedJson::array())) {
    curve.of_runs.emplace_back();
    for (std::size_t k = 0; k < curve.x.size(); ++k)
      curve.of_runs.back().push_back(number_or_nan(run.at(k)));
  }
  return curve;
}

// A file of that format, with an object 'cases'.
OrderedJson read_object(const std::string& file, const std::string& expected_format) {
  OrderedJson json = read_json_object(file);
  if (json.value("format", OrderedJson()) != expected_format)
    throw DataError(file + ": expected a JSON object with \"format\": \"" + expected_format + "\"");
  if (!json.value("cases", OrderedJson()).is_object())
    throw DataError(file + ": expected an object 'cases'");
  return json;
}

void read_numbers(const OrderedJson& json, EnsembleCase& one) {
  for (const auto& [key, value] : json.items())
    if (!other_keys.count(key))
      one.numbers[key] = mean_from(value.at("mean"), value.at("sem"), value.at("n"));
}

EnsembleCase case_from(const std::string& name, const OrderedJson& json) {
  EnsembleCase one;
  one.name = name;
  one.parameters = json.at("parameters");
  one.runs = json.at("runs").get<std::vector<std::string>>();
  one.seeds = json.at("seeds").get<std::vector<long>>();
  read_numbers(json, one);
  for (const auto& [table, columns] : json.at("curves").items())
    for (const auto& [column, curve] : columns.items())
      one.curves[std::string(table).append(".").append(column)] = curve_from(curve);
  return one;
}

// Removes what an earlier call left in `folder`, so that no table of a case that is no more stays.
void remove_tables_of_before(const fs::path& folder) {
  const OrderedJson before = json_object_if_sound((folder / "ensemble.json").string());
  if (!before.is_object() || !before.contains("cases") || !before["cases"].is_object()) return;
  std::error_code ignored;
  for (const auto& [name, one] : before["cases"].items()) {
    if (name.find('/') != std::string::npos || !one.contains("curves")) continue;
    for (const auto& table : one["curves"].items())
      fs::remove(folder / (name + "_" + table.key() + ".csv"), ignored);
    fs::remove(folder / (name + "_fields.csv"), ignored);
  }
}

// One CSV table per measured table: the abscissa, then mean, standard error and n of each column.
void write_tables(const EnsembleCase& one, const fs::path& folder) {
  std::map<std::string, CsvColumns> tables;
  for (const auto& [name, curve] : one.curves) {
    const auto dot = name.find('.');
    const std::string column = name.substr(dot + 1);
    auto& table = tables[name.substr(0, dot)];
    if (table.empty()) table.emplace_back(curve.abscissa, curve.x);
    add_mean_columns(column, curve.y, table);
  }
  for (const auto& [name, columns] : tables)
    write_csv((folder / (one.name + "_" + name + ".csv")).string(), columns);
}

// The numbers of all cases, a line each.
void write_numbers(const Ensemble& ensemble, const fs::path& folder) {
  std::string text = csv_line({"case", "number", "mean", "sem", "n"}) + "\n";
  for (const auto& one : ensemble.cases)
    for (const auto& [name, mean] : one.numbers) {
      if (cost_numbers.count(name)) continue;
      text += csv_line({one.name, name, number_text(mean.mean),
                        number_text(mean.sem.value_or(unknown)), std::to_string(mean.n)}) +
              "\n";
    }
  write_text((folder / "numbers.csv").string(), text);
}

OrderedJson cost_json(const Ensemble& ensemble) {
  OrderedJson json = {{"format", cost_format}, {"cases", OrderedJson::object()}};
  for (const auto& one : ensemble.cases)
    for (const auto& [name, mean] : one.numbers)
      if (cost_numbers.count(name)) json["cases"][one.name][name] = mean_json(mean);
  return json;
}

// Writes the file whole or not at all, also when this is interrupted.
void write_whole(const OrderedJson& json, const fs::path& file) {
  const fs::path unfinished = file.string() + ".part";
  write_json(unfinished.string(), json);
  std::error_code error;
  fs::rename(unfinished, file, error);
  if (error) throw DataError(file.string() + ": cannot be written (" + error.message() + ")");
}

}  // namespace

const EnsembleCase* case_named(const Ensemble& ensemble, const std::string& name) {
  for (const auto& one : ensemble.cases)
    if (one.name == name) return &one;
  return nullptr;
}

Ensemble read_ensemble(const std::string& file) {
  const OrderedJson json = read_object(file, ensemble_format);
  const std::string cost_file = (fs::path(file).parent_path() / "cost.json").string();
  const OrderedJson cost =
      fs::exists(cost_file) ? read_object(cost_file, cost_format) : OrderedJson();
  Ensemble ensemble;
  try {
    for (const auto& [name, one] : json.at("cases").items()) {
      ensemble.cases.push_back(case_from(name, one));
      if (cost.is_object() && cost.at("cases").contains(name))
        read_numbers(cost["cases"][name], ensemble.cases.back());
    }
    ensemble.notes = json.at("notes").get<std::vector<std::string>>();
  } catch (const nlohmann::json::exception& reason) {
    throw DataError(file + ": is not as `rodpack ensemble` writes it: " + reason.what());
  }
  return ensemble;
}

void write_ensemble(const Ensemble& ensemble, const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw DataError(folder + ": cannot be created (" + error.message() + ")");
  remove_tables_of_before(folder);
  OrderedJson json = {
      {"format", ensemble_format}, {"cases", OrderedJson::object()}, {"notes", ensemble.notes}};
  for (const auto& one : ensemble.cases) {
    json["cases"][one.name] = case_json(one);
    write_tables(one, folder);
  }
  write_numbers(ensemble, folder);
  write_whole(cost_json(ensemble), fs::path(folder) / "cost.json");
  write_whole(json, fs::path(folder) / "ensemble.json");
}

}  // namespace rodpack
