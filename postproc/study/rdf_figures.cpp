// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>

#include "reading/number_text.h"
#include "reading/text_file.h"
#include "study/case_panels.h"
#include "study/peaks.h"

namespace rodpack {
namespace {

Series rdf_series(const EnsembleCase& each) { return curve_series(each, "rdf.g"); }

PanelSheet rdf_sheet() {
  PanelSheet sheet;
  sheet.x_label = "distance {/:Italic r} / {/:Italic d}_p";
  sheet.y_label = "{/:Italic G}({/:Italic r})";
  sheet.x_high = 10;
  sheet.x_tics = "2";
  sheet.level = 1;
  sheet.errors = ErrorsAs::band;
  sheet.own_y = true;
  sheet.panel_aspect = 1.15;
  sheet.title_at = Corner::right;
  return sheet;
}

// A place for the name of a peak at `x` beside the names at the places `taken` (of name and peak),
// in the order of their peaks; none when there is no room near `x`.
std::optional<double> free_place(double x, const std::vector<std::pair<double, double>>& taken,
                                 double room) {
  for (const double shift : {0.0, 0.25, -0.25, 0.5, -0.5, 0.75, -0.75, 1.0, -1.0, 1.25, -1.25}) {
    const double place = x + shift * room;
    if (std::all_of(taken.begin(), taken.end(), [&](const std::pair<double, double>& other) {
          return std::fabs(place - other.first) >= room &&
                 (place < other.first) == (x < other.second);
        }))
      return place;
  }
  return std::nullopt;
}

// Names peaks in a strip of the panel by their position, the most prominent of those that have
// room.
void name_peaks(const PanelSheet& sheet, Panel& panel, const Series& series,
                const std::vector<Peak>& peaks, bool top) {
  const double letter = 0.95 * (sheet.x_high - sheet.x_low) / sheet.panel_width;
  std::vector<Peak> by_prominence = peaks;
  std::sort(by_prominence.begin(), by_prominence.end(),
            [](const Peak& a, const Peak& b) { return a.prominence > b.prominence; });
  std::vector<std::pair<double, double>> taken;
  for (const auto& peak : by_prominence) {
    const auto place = free_place(peak.position, taken, letter);
    if (!place) continue;
    taken.push_back({*place, peak.position});
    panel.names.push_back(
        {*place, peak.position, top, fixed_text(peak.position, 2), series.colour});
  }
}

std::string peak_rows(const EnsembleCase& each, const std::vector<Peak>& peaks) {
  std::string rows;
  for (const auto& peak : peaks)
    rows += each.name + "," + number_text(peak.position, 5) + "," +
            number_text(peak.position_error, 2) + "," + number_text(peak.height.mean, 5) + "," +
            number_text(peak.height.sem.value_or(NAN), 2) + "," + number_text(peak.prominence, 4) +
            "," + number_text(peak.prominence_error, 2) + "\n";
  return rows;
}

const char* const peak_columns =
    "case,position_over_dp,position_error_over_dp,g,g_sem,prominence,prominence_error\n";

}  // namespace

StudyFigure draw_rdf(const Ensemble& ensemble, const std::string& out) {
  PanelSheet sheet = rdf_sheet();
  add_straight_panels(sheet, ensemble, rdf_series);
  std::string rows;
  std::size_t place = 0;
  for (const double aspect_ratio : aspect_ratios(ensemble, false)) {
    Panel& panel = sheet.panels[place++];
    for (auto& series : panel.series) {
      series.point = 0;
      const bool coarse = series.title == "coarse";
      const auto* each = straight_case(ensemble, surface_of(coarse), aspect_ratio);
      const auto* curve = curve_of(each, "rdf.g");
      if (!curve) continue;
      const auto peaks = find_peaks(*curve);
      rows += peak_rows(*each, peaks);
      name_peaks(sheet, panel, series, peaks, coarse);
    }
  }
  const auto figure = finish(
      {"fig4_rdf", "Fig. 4",
       "Radial distribution function of the centres of straight particles, mean and standard "
       "error over the repetitions. Peaks that stand out by more than 5 standard errors are "
       "named by their position.",
       ""},
      sheet, out, "no straight case has a radial distribution function");
  if (figure.not_drawn.empty()) write_text(out + "/fig4_rdf_peaks.csv", peak_columns + rows);
  return figure;
}

StudyFigure draw_curved_rdf(const Ensemble& ensemble, const std::string& out) {
  PanelSheet sheet = rdf_sheet();
  sheet.columns = 1;
  sheet.panel_width = 40;
  sheet.panel_aspect = 2;
  add_curved_panels(sheet, ensemble, true, rdf_series);
  std::string rows;
  std::size_t place = 0;
  for (const double aspect_ratio : aspect_ratios(ensemble, true)) {
    Panel& panel = sheet.panels[place++];
    for (auto& series : panel.series) series.point = 0;
    const auto angles = opening_angles(ensemble, aspect_ratio);
    for (const double theta : angles) {
      const auto* each = curved_case(ensemble, aspect_ratio, theta);
      const auto* curve = curve_of(each, "rdf.g");
      if (!curve) continue;
      const auto peaks = find_peaks(*curve);
      rows += peak_rows(*each, peaks);
      for (const auto& series : panel.series)
        if (series.title == angle_title(theta) &&
            (theta == angles.front() || theta == angles.back()))
          name_peaks(sheet, panel, series, peaks, theta == angles.back());
    }
  }
  const auto figure = finish(
      {"fig9_rdf_curved", "Fig. 9",
       "Radial distribution function of the centres of curved particles, and of the straight "
       "smooth "
       "ones, mean and standard error over the repetitions. Peaks that stand out by more than 5 "
       "standard errors are named by their position.",
       ""},
      sheet, out, "no curved case has a radial distribution function");
  if (figure.not_drawn.empty()) write_text(out + "/fig9_rdf_peaks.csv", peak_columns + rows);
  return figure;
}

}  // namespace rodpack
