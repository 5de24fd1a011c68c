// SPDX-License-Identifier: GPL-2.0-or-later
#include "study/case_panels.h"

#include <algorithm>
#include <limits>

#include "reading/number_text.h"

namespace rodpack {

PanelSheet sheet_of_one(const std::string& x_label, const std::string& y_label,
                        const std::string& x_tics) {
  PanelSheet sheet;
  sheet.x_label = x_label;
  sheet.y_label = y_label;
  sheet.x_tics = x_tics;
  sheet.y_low.reset();
  sheet.columns = 1;
  sheet.panel_width = 40;
  sheet.panel_aspect = 1.4;
  return sheet;
}

std::string aspect_ratio_title(double aspect_ratio) {
  return "AR = " + number_text(aspect_ratio, 4);
}

std::string angle_title(double theta) {
  return theta > 0 ? "{/:Italic θ} = " + number_text(theta, 4) + "°" : "straight";
}

Series curve_series(const EnsembleCase& each, const std::string& name, double factor) {
  const auto* curve = curve_of(&each, name);
  return curve ? series_of(*curve, factor) : Series{};
}

std::optional<Packing> mean_bed(const EnsembleCase& each, double& omega) {
  const auto* height = number_of(&each, "bed_height_m");
  const auto* scale = number_of(&each, "omega_m");
  const auto parameter = [&](const char* name) {
    const auto found = each.parameters.find(name);
    return found != each.parameters.end() && found->is_number() ? found->get<double>() : 0;
  };
  const double d = parameter("particle_diameter_m"), width = parameter("container_width_m");
  if (!height || !scale || !(d > 0) || !(width > 0)) return std::nullopt;
  omega = scale->mean / d;
  Packing bed;
  bed.particle_diameter = 1;
  bed.aspect_ratio = std::max(1.0, parameter("aspect_ratio"));
  bed.walls.right = width / d;
  bed.surface = height->mean / d;
  return bed;
}

void add_straight_panels(PanelSheet& sheet, const Ensemble& ensemble, const SeriesOfCase& series) {
  for (const double aspect_ratio : aspect_ratios(ensemble, false)) {
    Panel panel;
    panel.title = aspect_ratio_title(aspect_ratio);
    for (const bool coarse : {true, false})
      if (const auto* each = straight_case(ensemble, surface_of(coarse), aspect_ratio))
        panel.series.push_back(with_look(series(*each), coarse));
    sheet.panels.push_back(panel);
  }
}

void add_curved_panels(PanelSheet& sheet, const Ensemble& ensemble, bool straight,
                       const SeriesOfCase& series) {
  std::vector<double> all{0};
  for (const double aspect_ratio : aspect_ratios(ensemble, true))
    for (const double theta : opening_angles(ensemble, aspect_ratio))
      if (std::find(all.begin(), all.end(), theta) == all.end()) all.push_back(theta);
  std::sort(all.begin(), all.end());
  for (const double aspect_ratio : aspect_ratios(ensemble, true)) {
    Panel panel;
    panel.title = aspect_ratio_title(aspect_ratio);
    for (std::size_t place = straight ? 0 : 1; place < all.size(); ++place) {
      const auto* each = curved_case(ensemble, aspect_ratio, all[place]);
      if (!each) continue;
      Series line = with_look_of_place(series(*each), place);
      line.title = angle_title(all[place]);
      panel.series.push_back(line);
    }
    sheet.panels.push_back(panel);
  }
}

void add_point(Series& series, double x, const EnsembleMean& value) {
  if (value.n == 0) return;
  series.x.push_back(x);
  series.y.push_back(value.mean);
  series.sem.push_back(value.sem.value_or(0));
}

void fit_x(PanelSheet& sheet) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const auto& panel : sheet.panels)
    for (const auto& series : panel.series)
      for (const double x : series.x) {
        low = std::min(low, x);
        high = std::max(high, x);
      }
  const double room = high > low ? 0.06 * (high - low) : 1;
  sheet.x_low = low - room;
  sheet.x_high = high + room;
}

void without_points(PanelSheet& sheet) {
  for (auto& panel : sheet.panels)
    for (auto& series : panel.series) series.point = 0;
}

void fit_x_high(PanelSheet& sheet) {
  for (const auto& panel : sheet.panels)
    for (const auto& series : panel.series)
      for (const double x : series.x) sheet.x_high = std::max(sheet.x_high, x);
  sheet.x_tics = number_text(round_step((sheet.x_high - sheet.x_low) / 3));  // numbers keep apart
}

StudyFigure finish(StudyFigure figure, const PanelSheet& sheet, const std::string& out,
                   const std::string& missing) {
  if (!draw_panels(sheet, out + "/" + figure.name)) figure.not_drawn = missing;
  return figure;
}

}  // namespace rodpack
