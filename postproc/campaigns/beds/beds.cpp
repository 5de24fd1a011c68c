// SPDX-License-Identifier: GPL-2.0-or-later
#include "campaigns/beds/beds.h"

#include <algorithm>
#include <cmath>

#include "campaigns/accuracy/accuracy_folder.h"
#include "reading/csv_file.h"
#include "reading/data_error.h"
#include "reading/number_text.h"
#include "rodpack/geometry/mass_properties.h"
#include "rodpack/contact/dashpot_relaxation.h"
#include "rodpack/motion/mass_scaling.h"

namespace rodpack {
namespace {

/// Columns of beds.csv that hold one number of the row each.
const struct {
  const char* name;
  double BedRow::*value;
} measures[] = {{"kinetic_J", &BedRow::kinetic},
                {"elastic_J", &BedRow::elastic},
                {"carried_weight_ratio", &BedRow::carried_weight},
                {"mean_height_over_dp", &BedRow::height},
                {"solid_fraction", &BedRow::solid_fraction},
                {"S2_horizontal", &BedRow::order},
                {"neighbours_per_rod", &BedRow::neighbours},
                {"contacts_per_rod", &BedRow::contacts},
                {"mean_overlap_over_dp", &BedRow::overlap},
                {"mean_pair_force_N", &BedRow::mean_force},
                {"largest_pair_force_N", &BedRow::largest_force},
                {"step_over_limit", &BedRow::step_over_limit}};

std::string header() {
  std::vector<std::string> names = {
      "method",           "timestep_s", "overlap", "normal_stiffness_N_m", "planar", "mass_scaling",
      "relaxation_steps", "seed",       "rods"};
  for (const auto& measure : measures) names.emplace_back(measure.name);
  names.insert(names.end(), {"steps", "processor_s_per_step"});
  return csv_line(names);
}

// Time steps that are compared, s, from the stability limit of velocity Verlet down to half the
// paper's.
const double compared_steps[] = {6.6e-5, 4.4e-5, 3.3e-5, 2.75e-5, 2.2e-5, 1.65e-5, 1.1e-5, 0.55e-5};

// Of the deck.
constexpr double density = 2500, damping_ratio = 0.2;

bool close(double a, double b) { return std::fabs(a - b) <= 1e-9 * std::fabs(b); }

}  // namespace

bool BedModel::operator==(const BedModel& other) const {
  return method == other.method && planar == other.planar && engine == other.engine &&
         close(mass_scaling, other.mass_scaling) &&
         close(relaxation_steps, other.relaxation_steps) && close(step, other.step) &&
         close(overlap, other.overlap) && close(stiffness, other.stiffness);
}

BedModel paper_model(bool engine, const BedScene& scene) {
  BedModel model;
  model.engine = engine;
  model.overlap = scene.overlap();
  return model;
}

bool BedComparison::by_engine() const {
  return std::all_of(models.begin(), models.end(), [](const BedModel& m) { return m.engine; });
}

bool BedRow::at_rest(int expected_rods) const {
  return rods == expected_rods && kinetic <= 1e-5 * elastic &&
         std::fabs(carried_weight - 1) <= 0.01;
}

namespace {

/// Cheap methods at long steps, all by the engine, down to the paper's at half its step.
BedComparison frontier() {
  BedComparison frontier{"frontier", "What is the cheapest way to a bed at rest?", {}};
  const std::pair<const char*, std::vector<double>> methods[] = {
      {"ab1", {8, 6, 5, 4, 3, 2, 1}},
      {"ab2", {5, 4, 3, 2, 1}},
      {"ab2e", {3, 2.5, 2, 1.5, 1}},
      {"ab3", {2.5, 2, 1}},
      {"ab3e", {3, 2.5, 2, 1.5, 1, 0.5}}};  // over the paper's step
  for (const auto& [method, factors] : methods)
    for (const double factor : factors) {
      BedModel model;
      model.method = method;
      model.step = factor * paper_step;
      model.engine = true;
      frontier.models.push_back(model);
    }
  return frontier;
}

/// Steps that only mass scaling or dashpots that relax allow, beside the longest ones without and
/// the paper's method.
BedComparison economy() {
  BedComparison economy{"economy", "What do mass scaling and dashpots that relax save?", {}};
  const auto add = [&](const char* method, double factor, double mass_scaling,
                       double relaxation_steps = 0) {
    BedModel model;
    model.method = method;
    model.step = factor * paper_step;
    model.engine = true;
    model.mass_scaling = mass_scaling;
    model.relaxation_steps = relaxation_steps;
    economy.models.push_back(model);
  };
  for (const double factor : {8, 6}) add("ab2", factor, 3);
  for (const double factor : {8, 6, 5}) add("ab2", factor, 4);
  for (const double factor : {6, 5}) add("ab2", factor, 5);
  for (const double factor : {6, 5, 4}) add("leapfrog", factor, 0, 1);
  for (const double factor : {4, 3}) add("leapfrog", factor, 0);
  add("ab2", 3, 0);
  economy.models.push_back(paper_model(true));
  return economy;
}

/// The presets of the deposition's deck, and the paper's method at half its step.
BedComparison presets(const BedScene& scene) {
  const ChainShape shape = {scene.aspect_ratio, rod_diameter, scene.overlap(), 0, rod_diameter};
  const double mass = mass_properties(shape, density, MassRule::reference, false).mass;
  BedModel economy = paper_model(true, scene);
  economy.method = "leapfrog";
  economy.mass_scaling = 7;
  economy.relaxation_steps = 1;
  // As `timestep auto` takes it.
  const PackingLaw law = {0.5 * economy.stiffness, damping_ratio, mass,
                          share_in_fastest_motion(economy.relaxation_steps, 1)};
  economy.step = 0.9 * mass_scaled_timestep_limit(0, economy.mass_scaling, law);
  BedModel finest = paper_model(true, scene);
  finest.step = 0.5 * paper_step;
  return {"presets",
          "Do the presets of the deposition give the same beds?",
          {economy, paper_model(true, scene), finest}};
}

std::vector<BedComparison> all_comparisons(const std::vector<std::string>& methods,
                                           const BedScene& scene) {
  const BedModel paper;
  std::vector<BedComparison> all;

  BedComparison surface{"surface", "How many primary spheres does a rod need?", {}};
  // The more spheres lie side by side, the stiffer two rods on each other: they need shorter steps.
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
    for (const double dt : compared_steps) {
      step.models.push_back(paper);
      step.models.back().method = method;
      step.models.back().step = dt;
      step.models.back().planar = method != "builtin";
    }
    all.push_back(step);
  }
  all.push_back(frontier());
  all.push_back(economy());
  for (BedComparison& comparison : all)
    if (comparison.name != "surface")
      for (BedModel& model : comparison.models) model.overlap = scene.overlap();
  all.push_back(presets(scene));
  return all;
}

/// Returns what column `planar` says.
std::string motion_text(const BedModel& model) {
  return model.engine ? "engine" : model.planar ? "yes" : "no";
}

}  // namespace

std::vector<BedComparison> bed_comparisons(const std::vector<std::string>& methods,
                                           const std::vector<std::string>& only,
                                           const BedScene& scene) {
  const auto all = all_comparisons(methods, scene);
  if (only.empty()) return all;
  std::vector<BedComparison> chosen;
  for (const auto& name : only) {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const BedComparison& c) { return c.name == name; });
    if (found == all.end()) {
      std::string names;
      for (const auto& comparison : all) names += " " + comparison.name;
      throw DataError("--comparisons: expected one of" + names + ", found '" + name + "'");
    }
    chosen.push_back(*found);
  }
  return chosen;
}

std::string bed_row_text(const BedRow& row) {
  const auto& m = row.model;
  std::vector<std::string> fields = {m.method,
                                     number_text(m.step),
                                     number_text(m.overlap),
                                     number_text(m.stiffness),
                                     motion_text(m),
                                     number_text(m.mass_scaling),
                                     number_text(m.relaxation_steps),
                                     std::to_string(row.seed),
                                     std::to_string(row.rods)};
  for (const auto& measure : measures) fields.push_back(number_text(row.*measure.value));
  fields.push_back(number_text(static_cast<double>(row.steps)));
  fields.push_back(number_text(row.seconds_per_step));
  return csv_line(fields);
}

std::vector<BedRow> read_bed_rows(const std::string& file) {
  const Table table = resume_table(file, header());
  const auto &method = table.words("method"), &motion = table.words("planar");
  const auto &step = table.column("timestep_s"), &overlap = table.column("overlap"),
             &stiffness = table.column("normal_stiffness_N_m"),
             &mass_scaling = table.column("mass_scaling"),
             &relaxation_steps = table.column("relaxation_steps"),
             &seconds_per_step = table.column("processor_s_per_step");
  const auto seed = table.whole_numbers("seed"), rods = table.whole_numbers("rods"),
             steps_taken = table.whole_numbers("steps");
  std::vector<BedRow> rows(table.rows());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (motion[i] != "yes" && motion[i] != "no" && motion[i] != "engine")
      table.refuse(i, "planar", "yes, no or engine");
    rows[i].model = {method[i],         step[i],
                     overlap[i],        stiffness[i],
                     motion[i] != "no", motion[i] == "engine",
                     mass_scaling[i],   relaxation_steps[i]};
    rows[i].seed = static_cast<int>(seed[i]);
    rows[i].rods = static_cast<int>(rods[i]);
    rows[i].steps = steps_taken[i];
    rows[i].seconds_per_step = seconds_per_step[i];
  }
  for (const auto& measure : measures) {
    const auto& values = table.column(measure.name);
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].*measure.value = values[i];
  }
  return rows;
}

}  // namespace rodpack
