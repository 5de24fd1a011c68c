// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstdio>
#include <set>

#include "analysis/surface_roughness.h"
#include "campaigns/beds/beds.h"
#include "reading/number_text.h"
#include "rodpack/geometry/chain_geometry.h"

namespace rodpack {
namespace {

using RowList = std::vector<BedRow>;

constexpr double aspect_ratio = 5;  // of the paper's rods, which surfaces are compared with

/// Writes a mean with as many digits as its error tells: down to the error's second one.
std::string text(const SeedMean& mean) {
  double value = mean.value;
  const double error = mean.error;
  if (mean.seeds == 0) return "–";
  if (!(error > 0)) return number_text(value, 3);
  const int decimals = std::max(0, 1 - static_cast<int>(std::floor(std::log10(error))));
  if (std::fabs(value) < 0.5 * std::pow(10.0, -decimals)) value = 0;  // no "-0.00"
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.*f ± %.*f", decimals, value, decimals, error);
  return buffer;
}

int spheres(double overlap, double of_rod = aspect_ratio) {
  return sphere_count({of_rod, rod_diameter, overlap, 0, rod_diameter});
}

std::string microseconds(double step) { return number_text(1e6 * step, 3); }

std::string integrator(const BedModel& model) {
  const std::string scaling =
      model.mass_scaling > 0 ? ", mass scaling " + number_text(model.mass_scaling) : "";
  const std::string relaxation =
      model.relaxation_steps > 0
          ? ", dashpots relax in " + number_text(model.relaxation_steps) + " Δt"
          : "";
  return model.method + scaling + relaxation +
         (model.method == "builtin" ? ""
          : model.engine            ? " engine"
          : model.planar            ? " planar"
                                    : " 3D");
}

std::string bodies(const BedModel& model, const BedScene& scene = {}) {
  return std::to_string(spheres(model.overlap, scene.aspect_ratio)) + " spheres, " +
         number_text(model.stiffness) + " N/m";
}

std::string ratio(double cost, double base) {
  return base > 0 && cost > 0 ? number_text(cost / base, 2) : "–";
}

std::string seconds_text(double cost) {
  return cost > 0 ? ", " + number_text(cost, 2) + " s per s" : "";
}

std::string difference_text(const BedSummary& summary, bool reference) {
  if (reference) return "reference";
  if (summary.worst_of.empty()) return "–";
  return summary.worst_of + ", " + number_text(summary.worst, 2);
}

std::string error_text(const BedSummary& summary, std::size_t quantity) {
  return summary.at_rest == 0 ? "not at rest" : text(summary.differences[quantity]);
}

std::string comparison_table(const RowList& rows, const BedComparison& comparison,
                             const BedScene& scene) {
  const int rods = scene.rods();
  const auto summaries = summarise_beds(rows, comparison, rods);
  if (summaries.empty()) return "";
  std::string table = "\n### " + comparison.question +
                      "\n| integrator | step, µs | spheres, stiffness | at rest | φ | S₂ | E_p, µJ "
                      "| neighbours | contacts | overlap / d_p, % | largest / mean force | step / "
                      "limit | largest difference | cost |\n"
                      "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const auto& summary : summaries) {
    const auto& model = summary.model;
    const auto mean = [&](auto value) { return resting_mean(rows, model, rods, value); };
    const auto limit = mean([](const BedRow& r) { return r.step_over_limit; });
    table += "| " + integrator(model) + " | " + microseconds(model.step) + " | " +
             bodies(model, scene) + " | " + std::to_string(summary.at_rest) + " of " +
             std::to_string(summary.runs);
    for (const auto& value : summary.means) table += " | " + text(value);
    table +=
        " | " + text(mean([](const BedRow& r) { return r.contacts; })) + " | " +
        text(mean([](const BedRow& r) { return 100 * r.overlap; })) + " | " +
        text(mean([](const BedRow& r) {
          return r.mean_force > 0 ? r.largest_force / r.mean_force : 0;
        })) +
        " | " + (summary.at_rest > 0 ? number_text(limit.value, 2) : "–") + " | " +
        difference_text(summary, &summary == &summaries.back()) + " | " +
        ratio(bed_cost(rows, model), bed_cost(rows, paper_model(comparison.by_engine(), scene))) +
        " |\n";
  }
  return table;
}

std::string surface_table(const RowList& rows, int rods) {
  const auto capsule = [] {
    const double length = (aspect_ratio - 1) * rod_diameter;
    return length * rod_diameter + std::acos(-1.0) / 4 * rod_diameter * rod_diameter;
  }();
  std::string table =
      "\n### A chain beside the capsule it stands for\nClosed forms; the range of the force is "
      "that of a rod's end on a rod, over a capsule's, at the mean overlap of the beds.\n\n"
      "| spheres (overlap) | depth of grooves / d | up and down when sliding along / d, % | over "
      "mean overlap | friction by grooves | force: least, mean, largest | covered area / capsule's "
      "|\n|---|---|---|---|---|---|---|\n";
  const auto comparisons = bed_comparisons({});
  for (const auto& model : comparisons.front().models) {
    const double f = model.overlap;
    const auto overlap = resting_mean(rows, model, rods, [](const BedRow& r) { return r.overlap; });
    std::string force = "–", over = "–";
    if (overlap.value > 0) {
      const auto range = chain_force_range(f, overlap.value);
      force = number_text(range.least, 2) + ", " + number_text(range.mean, 2) + ", " +
              number_text(range.largest, 2);
      over = number_text(sliding_amplitude(f) / overlap.value, 2);
    }
    table +=
        "| " + std::to_string(spheres(f)) + " (" + number_text(f) + ") | " +
        number_text(groove_depth(f), 3) + " | " + number_text(100 * sliding_amplitude(f), 3) +
        " | " + over + " | " + number_text(groove_friction(f), 3) + " | " + force + " | " +
        number_text(covered_area({aspect_ratio, rod_diameter, f, 0, rod_diameter}) / capsule, 4) +
        " |\n";
  }
  return table;
}

/// Says what stopped the step from growing: what the first step above `largest`, s, did.
std::string first_failure(const std::vector<BedSummary>& steps, double largest) {
  const BedSummary* next = nullptr;
  for (const auto& step : steps)
    if (step.model.step > largest * (1 + 1e-9) && (!next || step.model.step < next->model.step))
      next = &step;
  if (!next) return "none tried";
  return microseconds(next->model.step) + ": " +
         (next->all_at_rest()
              ? difference_text(*next, false) + " s.e."
              : std::to_string(next->at_rest) + " of " + std::to_string(next->runs) + " at rest");
}

std::string step_table(const RowList& rows, const std::vector<std::string>& methods, int rods) {
  std::string table =
      "\n### The largest step with the same results\nFrom the finest step up, all runs at rest and "
      "all four means within so many standard errors of the difference from the finest step's. "
      "With this many "
      "comparisons some 2 are passed by chance.\n\n| integrator | within 2, µs | next step | "
      "within "
      "3, µs | next step | cost there |\n|---|---|---|---|---|---|\n";
  for (const auto& comparison : bed_comparisons(methods)) {
    if (comparison.name.rfind("step_", 0) != 0) continue;
    const auto steps = summarise_beds(rows, comparison, rods);
    if (steps.empty()) continue;
    table += "| " + integrator(steps.front().model);
    double cost = 0;
    for (const double bound : {2.0, 3.0}) {
      const auto largest = largest_step_within(steps, bound);
      BedModel model = steps.front().model;
      model.step = largest.value_or(0);
      cost = bed_cost(rows, model);
      table += " | " + (largest ? microseconds(*largest) : "–") + " | " +
               first_failure(steps, largest.value_or(0));
    }
    table += " | " + ratio(cost, bed_cost(rows, {})) + " |\n";
  }
  return table;
}

}  // namespace

std::string bed_guide(const RowList& rows, const std::vector<std::string>& methods, int rods) {
  std::string table =
      "| scene | model | integrator | step, µs | expected error of φ | of E_p, µJ | largest "
      "difference, "
      "s.e. | relative cost |\n|---|---|---|---|---|---|---|---|\n";
  const auto add = [&](const std::string& scene, const std::vector<BedSummary>& all,
                       const BedSummary& summary) {
    const bool is_reference = &summary == &all.back();
    table += "| " + scene + " | " + bodies(summary.model) + " | " + integrator(summary.model) +
             " | " + microseconds(summary.model.step);
    for (const std::size_t quantity : {std::size_t{0}, std::size_t{2}})
      table += " | " + (is_reference ? std::string("reference") : error_text(summary, quantity));
    table += " | " + difference_text(summary, is_reference) + " | " +
             ratio(bed_cost(rows, summary.model), bed_cost(rows, {})) + " |\n";
  };
  const BedModel paper;
  for (const auto& comparison : bed_comparisons(methods)) {
    const auto all = summarise_beds(rows, comparison, rods);
    if (all.empty()) continue;
    const bool steps = comparison.name.rfind("step_", 0) == 0;
    const auto largest = steps ? largest_step_within(all, 3) : std::nullopt;
    for (const auto& summary : all) {
      const auto& model = summary.model;
      if (comparison.name == "surface")
        add("how rough the rods are", all, summary);
      else if (comparison.name == "planar")
        add("planar or not", all, summary);
      else if (comparison.name == "engine")
        add("by run_style verlet/planar", all, summary);
      else if (comparison.name == "stiffness" && (model == paper || model.step != paper_step))
        add("how soft, at a step of its own", all, summary);
      else if (largest && model.step == *largest)
        add("means of a bed, the longest step", all, summary);
    }
  }
  return table;
}

std::string beds_section(const RowList& rows, const AccuracySettings& settings) {
  const BedScene& scene = settings.bed_scene;
  if (rows.empty()) return "";
  std::set<int> seeds;
  for (const auto& row : rows) seeds.insert(row.seed);
  std::string section =
      "\n## Beds at rest\n" + std::to_string(scene.rods()) + " " + scene.surface + " rods (AR " +
      number_text(scene.aspect_ratio) + ") fall into a container " +
      number_text(1e3 * scene.width()) + " mm wide and rest after " +
      number_text(scene.duration()) + " s; means over " + std::to_string(seeds.size()) +
      " seeds with standard errors, over the runs at rest: all rods there, E_k ≤ 1e-5 E_p, floor "
      "and walls carry the weight to 1 %.\n\n"
      "- φ: covered area over that of an even bed of this mean height. S₂: ⟨cos 2γ⟩ about the "
      "horizontal. neighbours, contacts: per rod, of rods and of primary spheres. Forces: of pairs "
      "of rods.\n"
      "- step / limit: fix check/timestep/multisphere at the end. largest difference: of φ, S₂, "
      "E_p and neighbours from the last line's, in standard errors of the difference, seed by "
      "seed: "
      "the start makes much of the scatter, so that differences are known better than means.\n"
      "- cost: processor time per simulated second, median over the seeds, over that of the "
      "paper's model (ab3e planar, 11 µs, 2000 N/m)" +
      seconds_text(bed_cost(rows, paper_model(false, scene))) +
      "; where all models are the engine's, over that by the engine" +
      seconds_text(bed_cost(rows, paper_model(true, scene))) + ".\n";
  for (const auto& comparison :
       bed_comparisons(settings.bed_methods, settings.bed_comparisons, scene))
    section += comparison_table(rows, comparison, scene);
  if (!settings.bed_comparisons.empty()) return section;
  return section + step_table(rows, settings.bed_methods, scene.rods()) +
         surface_table(rows, scene.rods()) +
         "\n### Guide\nErrors are differences from the best model tried of each comparison.\n\n" +
         bed_guide(rows, settings.bed_methods, scene.rods());
}

}  // namespace rodpack
