// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>

#include "campaigns/beds/beds.h"
#include "figures/figure.h"
#include "reading/number_text.h"
#include "rodpack/geometry/chain_geometry.h"

namespace rodpack {
namespace {

struct Curve {
  std::string title, colour;
  int point;
  std::vector<double> x, y, error;
};

struct Panel {
  std::string label;  // of the y axis
  std::vector<Curve> curves;
  bool from_zero = false;
  std::string settings = "";  // gnuplot commands
};

/// An axis with few tics that holds all error bars.
std::string y_axis(const Panel& panel) {
  double low = panel.from_zero ? 0 : INFINITY, high = -INFINITY;
  for (const auto& curve : panel.curves)
    for (std::size_t i = 0; i < curve.y.size(); ++i) {
      low = std::min(low, curve.y[i] - curve.error[i]);
      high = std::max(high, curve.y[i] + curve.error[i]);
    }
  const double spread = std::max(high - low, 1e-3 * std::fabs(high));
  const double tic = 2 * round_step(spread / 5);
  // Labels of the tics have the digits that they need: gnuplot leaves more room.
  const double digits = tic < 1 ? 1 - std::floor(std::log10(tic) + 1e-9) : high < 10 ? 0 : 1;
  return "set yrange [" + number_text(panel.from_zero ? 0 : low - 0.06 * spread) + ":" +
         number_text(high + 0.06 * spread) + "]\nset ytics " + number_text(tic) + "\nset ylabel '" +
         panel.label + "' offset " + number_text(0.4 * digits) + ",0\n";
}

/// Lines that the titles of so many curves need.
std::size_t title_lines(std::size_t curves) { return curves > 5 ? 2 : 1; }

/// The titles of the curves that are drawn in a line or two above the panels. (A key there would
/// displace the first panel's labels.)
std::string titles(const std::vector<Curve>& curves) {
  std::vector<const Curve*> drawn;
  for (const Curve& curve : curves)
    if (!curve.title.empty() && !curve.x.empty()) drawn.push_back(&curve);
  const std::size_t lines = title_lines(drawn.size());
  const std::size_t columns = (drawn.size() + lines - 1) / lines;
  std::string text;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const std::size_t line = i / columns, column = i % columns;
    const double x = 0.15 + 0.85 * static_cast<double>(column) / static_cast<double>(columns);
    const double y = lines == 1 ? 0.965 : 0.968 - 0.038 * static_cast<double>(line);
    text += "set label '" + drawn[i]->title + "' at screen " + number_text(x) + "," +
            number_text(y) + " left offset 1,0 textcolor '" + drawn[i]->colour +
            "' point pointsize 1.4 pointtype " + std::to_string(drawn[i]->point) + " linecolor '" +
            drawn[i]->colour + "'\n";
  }
  return text;
}

/// Four panels; the first one's titles stand for all that have no key of their own.
void draw_panels(const std::string& stem, const std::string& x_label, const std::string& settings,
                 const std::vector<Panel>& panels) {
  std::string blocks, plots;
  int count = 0;
  for (const auto& panel : panels) {
    std::string plot;
    for (const auto& curve : panel.curves) {
      if (curve.x.empty()) continue;
      const std::string name = "curve" + std::to_string(++count);
      blocks += datablock(name, {curve.x, curve.y, curve.error});
      plot += (plot.empty() ? "plot $" : ", $") + name +
              " using 1:2:3 with yerrorlines linewidth 1.2 pointsize 0.9 pointtype " +
              std::to_string(curve.point) + " linecolor '" + curve.colour + "'" +
              (curve.title.empty() ? "" : " title '" + curve.title + "'");
    }
    if (plot.empty()) return;
    plots +=
        y_axis(panel) + panel.settings + plot + "\nset key off\nunset label\nunset logscale y\n";
  }
  draw_figure(stem, 1.35,
              blocks + "set multiplot layout 2,2 margins 0.15,0.985,0.14," +
                  (title_lines(panels.front().curves.size()) == 1 ? "0.925" : "0.895") +
                  " spacing 0.18,0.17\n"
                  "set grid xtics ytics linecolor '#DDDDDD'\nset xlabel '" +
                  x_label + "' offset 0,0.3\n" + settings + "set key off\n" +
                  titles(panels.front().curves) + plots + "unset multiplot\n");
}

using Value = std::function<double(const BedRow&)>;

/// Means over the runs at rest of each model, if four of five have come to rest: fewer would be a
/// choice of beds.
Curve curve(const std::vector<BedRow>& rows, const std::vector<BedModel>& models, int rods,
            const std::function<double(const BedModel&)>& x, const Value& y) {
  std::vector<std::pair<double, SeedMean>> points;
  for (const auto& model : models) {
    const auto mean = resting_mean(rows, model, rods, y);
    const auto runs = std::count_if(rows.begin(), rows.end(),
                                    [&](const BedRow& row) { return row.model == model; });
    if (mean.seeds > 0 && mean.seeds >= 0.8 * static_cast<double>(runs))
      points.push_back({x(model), mean});
  }
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  Curve result{"", colour::blue, 7, {}, {}, {}};
  for (const auto& [at, mean] : points) {
    result.x.push_back(at);
    result.y.push_back(mean.value);
    result.error.push_back(mean.error);
  }
  return result;
}

Curve named(Curve curve, const std::string& title, const std::string& colour, int point) {
  curve.title = title;
  curve.colour = colour;
  curve.point = point;
  return curve;
}

/// Cost per simulated second, or per step, over the paper's.
Curve cost(const std::vector<BedRow>& rows, const std::vector<BedModel>& models,
           const std::function<double(const BedModel&)>& x, bool per_step) {
  Curve result{per_step ? "of a step" : "of a second",
               per_step ? colour::vermilion : colour::blue,
               per_step ? 5 : 7,
               {},
               {},
               {}};
  const double base = bed_cost(rows, {});
  for (const auto& model : models) {
    const double here = bed_cost(rows, model);
    if (!(here > 0 && base > 0)) continue;
    result.x.push_back(x(model));
    result.y.push_back(here / base * (per_step ? model.step / paper_step : 1));
    result.error.push_back(0);
  }
  return result;
}

double solid_fraction(const BedRow& row) { return row.solid_fraction; }
double elastic_in_microjoule(const BedRow& row) { return 1e6 * row.elastic; }
double neighbours(const BedRow& row) { return row.neighbours; }
double overlap_in_percent(const BedRow& row) { return 100 * row.overlap; }

/// The quantities that are compared, each a panel.
std::vector<Panel> quantity_panels() {
  return {{"solid fraction {/:Italic φ}", {}},
          {"order {/:Italic S}_2", {}},
          {"elastic energy (µJ)", {}},
          {"neighbours per rod", {}}};
}

/// Method of a model and, if it has mass scaling or dashpots that relax, S or their time.
std::string look_of(const BedModel& model) {
  if (model.relaxation_steps > 0)
    return model.method + ", {/:Italic τ} = " + number_text(model.relaxation_steps) +
           " Δ{/:Italic t}";
  if (!(model.mass_scaling > 0)) return model.method;
  return model.method + ", {/:Italic S} = " + number_text(model.mass_scaling);
}

std::string colour_of(const BedModel& model) {
  if (model.relaxation_steps > 0) return "#009E73";
  if (!(model.mass_scaling > 0)) return accuracy_colour(model.method);
  return model.mass_scaling < 4 ? "#CC79A7" : model.mass_scaling < 5 ? "#E69F00" : "#56B4E9";
}

/// Results against cost: a curve for each method, along its steps.
void draw_frontier(const std::vector<BedRow>& rows, const BedComparison& comparison,
                   const BedScene& scene, const std::string& folder) {
  const int rods = scene.rods();
  const double base = bed_cost(rows, paper_model(comparison.by_engine(), scene));
  if (!(base > 0)) return;
  const auto x = [&](const BedModel& model) { return bed_cost(rows, model) / base; };
  const int points[] = {5, 7, 9, 11, 13};
  std::vector<std::string> looks;
  for (const auto& model : comparison.models)
    if (looks.empty() || looks.back() != look_of(model)) looks.push_back(look_of(model));
  std::vector<Panel> panels = quantity_panels();
  for (std::size_t m = 0; m < looks.size(); ++m) {
    std::vector<BedModel> models;
    for (const auto& model : comparison.models)
      if (look_of(model) == looks[m]) models.push_back(model);
    for (std::size_t q = 0; q < panels.size(); ++q)
      panels[q].curves.push_back(named(curve(rows, models, rods, x, bed_quantities()[q].value),
                                       looks[m], colour_of(models.front()), points[m % 5]));
  }
  draw_panels(folder + "/beds_" + comparison.name, "cost (1: ab3e at 11 µs)",
              "set logscale x 2\nset xrange [*:*]\n", panels);
}

void draw_steps(const std::vector<BedRow>& rows, const std::vector<BedComparison>& comparisons,
                int rods, const std::string& folder) {
  const std::string colours[] = {"#7F7F7F", colour::blue, colour::vermilion, "#009E73",
                                 "#E69F00", "#56B4E9",    "#CC79A7",         "#F0E442"};
  const int points[] = {5, 7, 9, 11, 13, 4, 6, 8};
  std::vector<Panel> panels = quantity_panels();
  std::size_t look = 0;
  for (const auto& comparison : comparisons) {
    if (comparison.name.rfind("step_", 0) != 0) continue;
    // Every third method lies beside the next two, so that error bars show.
    const double shift = 0.25 * (static_cast<double>(look % 3) - 1);
    const auto x = [shift](const BedModel& model) { return 1e6 * model.step + shift; };
    for (std::size_t q = 0; q < panels.size(); ++q)
      panels[q].curves.push_back(
          named(curve(rows, comparison.models, rods, x, bed_quantities()[q].value),
                comparison.models.front().method, colours[look % 8], points[look % 8]));
    ++look;
  }
  draw_panels(folder + "/beds_step", "time step (µs)", "set xrange [0:48]\nset xtics 10\n", panels);
}

void draw_surface(const std::vector<BedRow>& rows, const std::vector<BedModel>& models, int rods,
                  const std::string& folder) {
  const auto x = [](const BedModel& model) {
    return static_cast<double>(sphere_count({5, 3e-3, model.overlap, 0, 3e-3}));
  };
  const auto contacts = [](const BedRow& row) { return row.contacts; };
  draw_panels(
      folder + "/beds_surface", "primary spheres per rod",
      "set logscale x 2\nset xrange [4:42]\nset xtics (5, 9, 17, 33)\nunset mxtics\n",
      {{"solid fraction {/:Italic φ}", {curve(rows, models, rods, x, solid_fraction)}},
       {"elastic energy (µJ)", {curve(rows, models, rods, x, elastic_in_microjoule)}},
       {"per rod",
        {named(curve(rows, models, rods, x, contacts), "contacts", colour::blue, 7),
         named(curve(rows, models, rods, x, neighbours), "neighbours", colour::vermilion, 5)},
        true,
        "set key on inside top left vertical samplen 1 Left reverse\nset yrange [0:52]\nset ytics "
        "10\n"},
       {"cost, relative",
        {cost(rows, models, x, false), cost(rows, models, x, true)},
        false,
        "set key on inside top left vertical samplen 1 Left reverse\n"
        "set logscale y 2\nset yrange [0.5:24]\nset ytics 2\n"}});
}

void draw_stiffness(const std::vector<BedRow>& rows, const std::vector<BedModel>& models, int rods,
                    const std::string& folder) {
  std::vector<BedModel> fixed, scaled;
  for (const auto& model : models) {
    const bool paper = model == BedModel();
    if (paper || model.step == paper_step) fixed.push_back(model);
    if (paper || model.step != paper_step) scaled.push_back(model);
  }
  const auto both = [&](const Value& value) {
    const auto x = [](double factor) {
      return [factor](const BedModel& model) { return factor * model.stiffness; };
    };
    return std::vector<Curve>{
        named(curve(rows, fixed, rods, x(0.98), value), "step 11 µs", colour::blue, 7),
        named(curve(rows, scaled, rods, x(1.02), value), "step ∝ {/:Italic k}^{–1/2}",
              colour::vermilion, 5)};
  };
  const auto x = [](const BedModel& model) { return model.stiffness; };
  draw_panels(
      folder + "/beds_stiffness", "normal stiffness (N/m)",
      "set logscale x 2\nset xrange [800:5000]\nset xtics (1000, 2000, 4000)\nunset mxtics\n",
      {{"solid fraction {/:Italic φ}", both(solid_fraction)},
       {"overlap / {/:Italic d_p} (%)", both(overlap_in_percent), true},
       {"elastic energy (µJ)", both(elastic_in_microjoule), true},
       {"cost, relative",
        {named(cost(rows, fixed, x, false), "", colour::blue, 7),
         named(cost(rows, scaled, x, false), "", colour::vermilion, 5)},
        true}});
}

}  // namespace

void draw_beds(const std::vector<BedRow>& rows, const AccuracySettings& settings,
               const std::string& folder) {
  const int rods = settings.bed_scene.rods();
  const auto comparisons =
      bed_comparisons(settings.bed_methods, settings.bed_comparisons, settings.bed_scene);
  for (const auto& comparison : comparisons) {
    if (comparison.name == "surface") draw_surface(rows, comparison.models, rods, folder);
    if (comparison.name == "stiffness") draw_stiffness(rows, comparison.models, rods, folder);
    if (comparison.name == "frontier" || comparison.name == "economy")
      draw_frontier(rows, comparison, settings.bed_scene, folder);
  }
  const bool steps = std::any_of(
      comparisons.begin(), comparisons.end(),
      [](const BedComparison& comparison) { return comparison.name.rfind("step_", 0) == 0; });
  if (steps) draw_steps(rows, comparisons, rods, folder);
}

}  // namespace rodpack
