// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>

#include "campaigns/accuracy/accuracy.h"
#include "figures/figure.h"
#include "reading/data_error.h"
#include "reading/number_text.h"
#include "reading/text_file.h"

namespace rodpack {
namespace {

using RowList = std::vector<AccuracyRow>;

RowList select(const RowList& rows, const std::string& scene, const std::string& method) {
  RowList result;
  for (const auto& row : rows)
    if (row.scene == scene && row.method == method) result.push_back(row);
  std::sort(result.begin(), result.end(), [](const AccuracyRow& a, const AccuracyRow& b) {
    return a.steps_per_contact < b.steps_per_contact;
  });
  return result;
}

/// Returns the value of `y` where `x` reaches `at`, on a straight line between logarithms.
double between(double x0, double x1, double y0, double y1, double at) {
  const double share = std::log(at / x0) / std::log(x1 / x0);
  return y0 * std::pow(y1 / y0, share);
}

std::optional<double> error_at(const RowList& rows, double steps) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& row = rows[i];
    if (std::fabs(row.steps_per_contact / steps - 1) < 1e-9) return row.error;
    if (i == 0 || row.steps_per_contact < steps || rows[i - 1].steps_per_contact > steps) continue;
    const auto& last = rows[i - 1];
    if (!(row.error > 0 && last.error > 0) || std::isinf(last.error)) return row.error;
    return between(last.steps_per_contact, row.steps_per_contact, last.error, row.error, steps);
  }
  return std::nullopt;
}

std::string processor() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  return "an unknown processor";
}

std::string or_dash(const std::optional<double>& value, int digits = 2) {
  return value ? number_text(*value, digits) : "–";
}

// A cost to reach the target, or that of the finest step, which does not.
std::string cost(const std::optional<double>& value, bool at_once, double finest) {
  return value ? (at_once ? "≤ " : "") + number_text(*value, 3) : "> " + number_text(finest, 3);
}

// Cost of the stock method over that of this one; both may be bounds only.
std::string factor(const std::optional<double>& stock, double finest_of_stock,
                   const std::optional<double>& value) {
  if (!value) return "–";
  return stock ? number_text(*stock / *value, 2) : "> " + number_text(finest_of_stock / *value, 2);
}

void draw(const RowList& rows, const std::string& scene, const std::vector<std::string>& methods,
          bool against_seconds, double paper_evaluations, const std::string& stem) {
  std::string blocks, curves;
  double largest = 1e-15, least_cost = INFINITY, most_cost = 0;
  // The signs are open, so that curves that lie on each other show.
  constexpr int points[] = {6, 4, 8, 10, 12, 14, 1, 2};
  std::size_t point = 0;
  for (const auto& method : methods) {
    ++point;
    std::vector<double> cost, error;
    for (const auto& row : select(rows, scene, method)) {
      if (!(row.error > 0) || row.error > 1e6) continue;
      cost.push_back(against_seconds ? row.seconds : row.force_evaluations);
      error.push_back(row.error);
      largest = std::max(largest, row.error);
      least_cost = std::min(least_cost, cost.back());
      most_cost = std::max(most_cost, cost.back());
    }
    if (cost.empty()) continue;
    blocks += datablock(method, {cost, error});
    curves += (curves.empty() ? "plot " : ", ") + ("$" + method) +
              " using 1:2 with linespoints linewidth 1.5 pointsize 1.6 pointtype " +
              std::to_string(points[point - 1]) + " linecolor '" + accuracy_colour(method) + "'" +
              (method == "builtin" ? " dashtype 2" : "") + " title '" + method + "'";
  }
  if (curves.empty()) return;
  std::string paper;
  if (!against_seconds && paper_evaluations > least_cost && paper_evaluations < most_cost) {
    const std::string at = number_text(paper_evaluations) + ", graph ";
    paper = "set arrow from " + at + "0 to " + at + "1 nohead dashtype 3 linecolor '#7F7F7F'\n" +
            "set label \"the paper's step\" at " + at +
            "0.02 rotate by 90 offset -1.1,0 textcolor '#7F7F7F'\n";
  }
  draw_figure(stem, 1.35,
              blocks +
                  "set logscale xy\nset format xy '10^{%L}'\nset mxtics 10\nset mytics 10\n"
                  "set key outside right top\nset grid xtics ytics linecolor '#DDDDDD'\n"
                  "set xlabel '" +
                  (against_seconds ? "time of the loop (s)" : "force evaluations") +
                  "'\nset xrange [" + number_text(0.8 * least_cost) + ":" +
                  number_text(1.25 * most_cost) + "]\n" + paper +
                  "set ylabel 'error'\nset title '" + scene + "' noenhanced\nset yrange [:" +
                  number_text(std::min(largest * 2, 10.0)) + "]\n" + curves + "\n");
}

/// Lists for each scene and error the method that reaches it with the fewest force evaluations.
std::string cheapest_table(const RowList& rows, const AccuracySettings& settings) {
  std::string table =
      "\n## The cheapest\nFewest force evaluations to an error; factor: those of `builtin` over "
      "them (>: it does not get there with the finest step).\n\n"
      "| scene | error | method | steps per contact | factor |\n|---|---|---|---|---|\n";
  for (const auto& name : settings.scenes) {
    if (name == beds_scene || name == stability_scene) continue;
    const auto scene = accuracy_scene(name);
    const auto stock_rows = select(rows, name, "builtin");
    for (const double target : {1e-2, 1e-3, 1e-4}) {
      std::optional<AccuracySummary> best, stock;
      for (const auto& method : settings.methods) {
        const auto these = select(rows, name, method);
        if (these.empty()) continue;
        const auto s =
            summarise(these, scene.contact_time / paper_step, scene.asymptotic_from, 1e-9, target);
        if (method == "builtin") stock = s;
        if (s.evaluations && (!best || *s.evaluations < *best->evaluations)) best = s;
      }
      if (!best) continue;
      table +=
          "| " + name + " | " + number_text(target) + " | " + best->method + " | " +
          (best->at_once ? "≤ " : "") +
          number_text(*best->evaluations * scene.contact_time / scene.duration, 3) + " | " +
          (stock ? factor(stock->evaluations, stock->finest_evaluations, best->evaluations) : "–") +
          " |\n";
    }
  }
  return table;
}

}  // namespace

const std::string& accuracy_colour(const std::string& method) {
  static const std::map<std::string, std::string> colours = {
      {"builtin", colour::grey}, {"leapfrog", "#000000"},     {"ab1", "#E69F00"},
      {"ab2", "#56B4E9"},        {"ab3", colour::blue},       {"ab4", "#009E73"},
      {"ab2e", "#F0E442"},       {"ab3e", colour::vermilion}, {"ab4e", "#CC79A7"}};
  return colours.at(method);
}

std::optional<double> observed_order(const std::vector<double>& steps,
                                     const std::vector<double>& errors, double asymptotic_from,
                                     double floor) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i] < asymptotic_from || !(errors[i] > floor) || errors[i] > 0.05) continue;
    const double u = std::log(steps[i]), v = std::log(errors[i]);
    n += 1;
    x += u;
    y += v;
    xx += u * u;
    xy += u * v;
  }
  if (n < 3) return std::nullopt;
  return -(n * xy - x * y) / (n * xx - x * x);
}

AccuracySummary summarise(const std::vector<AccuracyRow>& given, double steps_of_paper,
                          double asymptotic_from, double floor, double target) {
  if (given.empty()) throw DataError("no rows to summarise");
  const auto rows = select(given, given.front().scene, given.front().method);
  AccuracySummary result;
  result.scene = rows.front().scene;
  result.method = rows.front().method;
  result.finest_evaluations = rows.back().force_evaluations;
  result.finest_seconds = rows.back().seconds;
  std::vector<double> steps, errors;
  for (const auto& row : rows) {
    steps.push_back(row.steps_per_contact);
    errors.push_back(row.error);
  }
  result.order = observed_order(steps, errors, asymptotic_from, floor);
  result.paper_error = error_at(rows, steps_of_paper);
  // The coarsest step from which on all errors stay below the target.
  std::size_t first = rows.size();
  while (first > 0 && rows[first - 1].error <= target) --first;
  if (first == rows.size()) return result;
  const auto& reached = rows[first];
  result.at_once = first == 0;
  if (first == 0 || std::isinf(rows[first - 1].error) || !(reached.error > 0)) {
    result.evaluations = reached.force_evaluations;
    result.seconds = reached.seconds;
  } else {
    const auto& before = rows[first - 1];
    result.evaluations = between(before.error, reached.error, before.force_evaluations,
                                 reached.force_evaluations, target);
    result.seconds = between(before.error, reached.error, before.seconds, reached.seconds, target);
  }
  return result;
}

void report_accuracy(const std::vector<AccuracyRow>& rows, const std::string& beds,
                     const AccuracySettings& settings, const std::string& folder) {
  std::string table, scenes;
  for (const auto& name : settings.scenes) {
    if (name == beds_scene || name == stability_scene) continue;
    const auto scene = accuracy_scene(name);
    const double of_paper = scene.contact_time / paper_step;
    const auto stock_rows = select(rows, name, "builtin");
    std::optional<AccuracySummary> stock;
    if (!stock_rows.empty()) stock = summarise(stock_rows, of_paper, scene.asymptotic_from);
    for (const auto& method : settings.methods) {
      const auto these = select(rows, name, method);
      if (these.empty()) continue;
      const auto s = summarise(these, of_paper, scene.asymptotic_from);
      table +=
          "| " + name + " | " + method + " | " + or_dash(s.order, 3) + " | " +
          or_dash(s.paper_error) + " | " + cost(s.evaluations, s.at_once, s.finest_evaluations) +
          " | " +
          (stock ? factor(stock->evaluations, stock->finest_evaluations, s.evaluations) : "–") +
          " | " + cost(s.seconds, s.at_once, s.finest_seconds) + " | " +
          (stock ? factor(stock->seconds, stock->finest_seconds, s.seconds) : "–") + " |\n";
    }
    scenes += "| " + name + " | " + scene.error_is + " | " + scene.reference +
              (scene.agreement > 0 ? ": agree to " + number_text(scene.agreement, 2) : "") + " | " +
              number_text(scene.contact_time, 4) + " | " + number_text(of_paper, 3) + " |\n";
    const double at_paper = scene.duration / paper_step;
    draw(rows, name, settings.methods, false, at_paper, folder + "/" + name + "_evaluations");
    draw(rows, name, settings.methods, true, at_paper, folder + "/" + name + "_seconds");
  }
  write_text(
      folder + "/accuracy.md",
      "# Accuracy against cost\n\n"
      "Program: `" +
          std::filesystem::absolute(settings.liggghts.program).lexically_normal().string() +
          "`. Seconds: loop time per step, median of " + std::to_string(settings.repeats) +
          " runs of " + std::to_string(settings.timed_steps) +
          " steps on one fixed core, times the number of steps; measured on " + processor() +
          ". Other load on the machine shows in them.\n\n"
          "- order: observed, least squares over the errors between 1e-9 and 0.05 from 25 steps "
          "per contact on (free spin: all); –: fewer than three of them (exact to rounding, or too "
          "coarse)\n"
          "- error at the paper's step: 1.1e-5 s, between rows of accuracy.csv\n"
          "- cost of an error of 1e-3: between rows; ≤: the coarsest step reaches it already, >: "
          "the "
          "finest does not; "
          "factor: of the same cost of `builtin` (velocity Verlet) over this one\n\n"
          "| scene | method | order | error at the paper's step | force evaluations to 1e-3 | "
          "factor "
          "| seconds to 1e-3 | factor |\n|---|---|---|---|---|---|---|---|\n" +
          table + cheapest_table(rows, settings) +
          "\n## Scenes\n| scene | error of | reference | contact time, s | steps per contact at "
          "the "
          "paper's step |\n|---|---|---|---|---|\n" +
          scenes + beds);
}

}  // namespace rodpack
