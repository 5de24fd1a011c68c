// SPDX-License-Identifier: GPL-2.0-or-later
#include "campaigns/beds/beds.h"

#include <algorithm>
#include <cmath>

#include "campaigns/accuracy/accuracy_folder.h"
#include "reading/data_error.h"
#include "reading/text.h"

namespace rodpack {
namespace {

const std::string header =
    "method,timestep_s,overlap,normal_stiffness_N_m,planar,seed,rods,kinetic_J,elastic_J,"
    "carried_weight_ratio,mean_height_over_dp,solid_fraction,S2_horizontal,neighbours_per_rod,"
    "contacts_per_rod,mean_overlap_over_dp,mean_pair_force_N,largest_pair_force_N,step_over_limit,"
    "steps,processor_s_per_step";

// From the stability limit of velocity Verlet down to half the paper's.
const double steps[] = {6.6e-5, 4.4e-5, 3.3e-5, 2.75e-5, 2.2e-5, 1.65e-5, 1.1e-5, 0.55e-5};

double number(const std::string& text) {
  std::size_t used = 0;
  const double value = std::stod(text, &used);
  if (used != text.size()) throw std::invalid_argument(text);
  return value;
}

bool close(double a, double b) { return std::fabs(a - b) <= 1e-9 * std::fabs(b); }

}  // namespace

bool BedModel::operator==(const BedModel& other) const {
  return method == other.method && planar == other.planar && engine == other.engine &&
         close(step, other.step) && close(overlap, other.overlap) &&
         close(stiffness, other.stiffness);
}

bool BedRow::at_rest(int expected_rods) const {
  return rods == expected_rods && kinetic <= 1e-5 * elastic &&
         std::fabs(carried_weight - 1) <= 0.01;
}

namespace {

std::vector<BedComparison> all_comparisons(const std::vector<std::string>& methods) {
  const BedModel paper;
  std::vector<BedComparison> all;

  BedComparison surface{"surface", "How many primary spheres does a rod need?", {}};
  // The more spheres side by side, the stiffer two rods that lie on each other: shorter steps.
  for (const auto& [overlap, step] : {std::pair(0.0, paper_step),
                                      {0.5, paper_step},
                                      {0.75, 0.75 * paper_step},
                                      {0.875, 0.375 * paper_step}}) {
    surface.models.push_back(paper);
    surface.models.back().overlap = overlap;
    surface.models.back().step = step;
  }
  all.push_back(surface);

  BedComparison planar{"planar", "Does a planar bed need the motion in the plane only?", {}};
  for (const auto& [method, flag] :
       {std::pair("builtin", false), {"ab3e", false}, {"ab3e", true}}) {
    planar.models.push_back(paper);
    planar.models.back().method = method;
    planar.models.back().planar = flag;
  }
  all.push_back(planar);

  BedComparison engine{"engine", "Does the planar engine give the same beds?", {paper, paper}};
  engine.models.front().engine = true;
  all.push_back(engine);

  BedComparison stiffness{"stiffness", "Which stiffness, and what does a softer spring save?", {}};
  for (const double k : {1000.0, 2000.0, 4000.0})
    for (const bool scaled : {false, true}) {
      if (scaled && k == paper.stiffness) continue;
      stiffness.models.push_back(paper);
      stiffness.models.back().stiffness = k;
      if (scaled) stiffness.models.back().step = paper_step * std::sqrt(paper.stiffness / k);
    }
  all.push_back(stiffness);

  for (const auto& method : methods) {
    BedComparison step{"step_" + method, "How far can the step of " + method + " grow?", {}};
    for (const double dt : steps) {
      step.models.push_back(paper);
      step.models.back().method = method;
      step.models.back().step = dt;
      step.models.back().planar = method != "builtin";
    }
    all.push_back(step);
  }
  return all;
}

/// Column `planar`.
std::string motion_text(const BedModel& model) {
  return model.engine ? "engine" : model.planar ? "yes" : "no";
}

}  // namespace

std::vector<BedComparison> bed_comparisons(const std::vector<std::string>& methods,
                                           const std::vector<std::string>& only) {
  const auto all = all_comparisons(methods);
  if (only.empty()) return all;
  std::vector<BedComparison> chosen;
  for (const auto& name : only) {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const BedComparison& c) { return c.name == name; });
    if (found == all.end()) {
      std::string names;
      for (const auto& comparison : all) names += " " + comparison.name;
      throw DataError("--comparisons: '" + name + "', expected one of" + names);
    }
    chosen.push_back(*found);
  }
  return chosen;
}

std::string bed_row_text(const BedRow& row) {
  const auto& m = row.model;
  std::string text = m.method + "," + number_text(m.step) + "," + number_text(m.overlap) + "," +
                     number_text(m.stiffness) + "," + motion_text(m) + "," +
                     std::to_string(row.seed) + "," + std::to_string(row.rods);
  for (const double value :
       {row.kinetic, row.elastic, row.carried_weight, row.height, row.solid_fraction, row.order,
        row.neighbours, row.contacts, row.overlap, row.mean_force, row.largest_force,
        row.step_over_limit, static_cast<double>(row.steps), row.seconds_per_step})
    text += "," + number_text(value);
  return text;
}

std::vector<BedRow> read_bed_rows(const std::string& file) {
  std::vector<BedRow> rows;
  long line = 1;
  for (const auto& f : read_fields(file, header)) {
    ++line;
    try {
      if (f[4] != "yes" && f[4] != "no" && f[4] != "engine") throw std::invalid_argument(f[4]);
      BedRow row;
      row.model = {f[0], number(f[1]), number(f[2]), number(f[3]), f[4] != "no", f[4] == "engine"};
      row.seed = static_cast<int>(number(f[5]));
      row.rods = static_cast<int>(number(f[6]));
      std::size_t next = 7;
      for (double* value :
           {&row.kinetic, &row.elastic, &row.carried_weight, &row.height, &row.solid_fraction,
            &row.order, &row.neighbours, &row.contacts, &row.overlap, &row.mean_force,
            &row.largest_force, &row.step_over_limit})
        *value = number(f[next++]);
      row.steps = std::lround(number(f[next++]));
      row.seconds_per_step = number(f[next]);
      rows.push_back(row);
    } catch (const std::logic_error&) {
      throw DataError(file + ":" + std::to_string(line) +
                      ": expected a method, three numbers, yes, no or engine, and numbers");
    }
  }
  return rows;
}

}  // namespace rodpack
