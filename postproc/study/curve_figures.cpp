// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "figures/figure.h"
#include "reading/number_text.h"
#include "reading/text_file.h"
#include "study/panels.h"
#include "study/peaks.h"
#include "study/pressure.h"
#include "study/study_case.h"
#include "study/study_figures.h"

namespace rodpack {
namespace {

std::string fixed_text(double value, int decimals) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

std::string aspect_ratio_title(double aspect_ratio) {
  return "AR = " + number_text(aspect_ratio, 4);
}

std::string angle_title(double theta) {
  return theta > 0 ? "{/:Italic θ} = " + number_text(theta, 4) + "°" : "straight";
}

Surface surface_of(bool coarse) { return coarse ? Surface::coarse : Surface::smooth; }

// A panel per aspect ratio, both surfaces in each.
template <class SeriesOfCase>
void add_straight_panels(PanelSheet& sheet, const Ensemble& ensemble, SeriesOfCase series) {
  for (const double aspect_ratio : aspect_ratios(ensemble, false)) {
    Panel panel;
    panel.title = aspect_ratio_title(aspect_ratio);
    for (const bool coarse : {true, false})
      if (const auto* each = straight_case(ensemble, surface_of(coarse), aspect_ratio))
        panel.series.push_back(with_look(series(*each), coarse));
    sheet.panels.push_back(panel);
  }
}

// A panel per aspect ratio of curved particles, a line per angle; `straight`: the straight smooth
// ones too.
template <class SeriesOfCase>
void add_curved_panels(PanelSheet& sheet, const Ensemble& ensemble, bool straight,
                       SeriesOfCase series) {
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

StudyFigure finish(StudyFigure figure, const PanelSheet& sheet, const std::string& out,
                   const std::string& missing) {
  if (!draw_panels(sheet, out + "/" + figure.name)) figure.not_drawn = missing;
  return figure;
}

Series curve_series(const EnsembleCase& each, const std::string& name, double factor = 1) {
  const auto* curve = curve_of(&each, name);
  return curve ? series_of(*curve, factor) : Series{};
}

// Over a whole turn: the first bin, at 0, again at the end.
Series orientation_series(const EnsembleCase& each, double range) {
  Series series = curve_series(each, "orientation.probability_density_per_deg", 1e3);
  if (series.x.empty()) return series;
  series.x.push_back(series.x.front() + range);
  series.y.push_back(series.y.front());
  series.sem.push_back(series.sem.front());
  return series;
}

PanelSheet orientation_sheet(double range) {
  PanelSheet sheet;
  sheet.x_label = "orientation {/:Italic γ} (°)";
  sheet.y_label = "probability density (10^{−3} / °)";
  sheet.x_high = range;
  sheet.x_tics = range > 180 ? "60" : "30";
  sheet.level = 1e3 / range;
  sheet.title_at = Corner::middle;
  return sheet;
}

Series rdf_series(const EnsembleCase& each) {
  Series series = curve_series(each, "rdf.g");
  return series;
}

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
  for (const double shift : {0.0, 0.25, -0.25, 0.5, -0.5, 0.75, -0.75, 1.0, -1.0}) {
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
  const double letter = 0.75 * (sheet.x_high - sheet.x_low) / sheet.panel_width;
  std::vector<Peak> by_prominence = peaks;
  std::sort(by_prominence.begin(), by_prominence.end(),
            [](const Peak& a, const Peak& b) { return a.prominence > b.prominence; });
  std::vector<std::pair<double, double>> taken;
  for (const auto& peak : by_prominence) {
    const auto place = free_place(peak.position, taken, letter);
    if (!place) continue;
    taken.push_back({*place, peak.position});
    panel.names.push_back({*place, top, fixed_text(peak.position, 2), series.colour});
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

Series pressure_series(const EnsembleCase& each) {
  return curve_series(each, "profile.pressure_N_m");
}

PanelSheet pressure_sheet() {
  PanelSheet sheet;
  sheet.x_label = "depth {/:Italic h} / {/:Italic d}_p";
  sheet.y_label = "pressure {/:Italic P}_0 (N/m)";
  sheet.errors = ErrorsAs::band;
  return sheet;
}

// Depths differ by case: the axes end where the deepest one does.
void fit_depths(PanelSheet& sheet) {
  for (const auto& panel : sheet.panels)
    for (const auto& series : panel.series)
      for (const double x : series.x) sheet.x_high = std::max(sheet.x_high, x);
}

Panel sphere_panel(const EnsembleCase& spheres) {
  Panel panel;
  panel.title = "spheres";
  Series measured = pressure_series(spheres);
  measured.title = "spheres";
  measured.colour = "#202020";
  panel.series.push_back(measured);
  std::string ignored;
  const auto fit = janssen_of(spheres, ignored);
  if (!fit) return panel;
  const double diameter = spheres.parameters["particle_diameter_m"].get<double>();
  Series law;
  law.title = "Janssen’s law";
  law.colour = "#009E73";
  law.dash = 2;
  law.line_width = 1.6;
  for (int k = 0; k <= 100; ++k) {
    const double h = fit->from + (fit->to - fit->from) * k / 100;
    law.x.push_back(h / diameter);
    law.y.push_back(fit->pressure * (1 - std::exp(-h / fit->depth)));
    law.sem.push_back(0);
  }
  panel.series.push_back(law);
  return panel;
}

}  // namespace

StudyFigure draw_orientation(const Ensemble& ensemble, const std::string& out) {
  PanelSheet sheet = orientation_sheet(180);
  add_straight_panels(sheet, ensemble,
                      [](const EnsembleCase& each) { return orientation_series(each, 180); });
  return finish(
      {"fig3_orientation", "Fig. 3",
       "Distribution of the orientation of straight particles, bins centred on 0°, 5°, …; "
       "mean over the repetitions with its standard error. Dashed: isotropic.",
       ""},
      sheet, out, "no straight case has an orientation distribution");
}

StudyFigure draw_curved_orientation(const Ensemble& ensemble, const std::string& out) {
  PanelSheet sheet = orientation_sheet(360);
  sheet.columns = 1;
  sheet.panel_width = 40;
  sheet.panel_aspect = 2.2;
  sheet.errors = ErrorsAs::band;
  add_curved_panels(sheet, ensemble, false,
                    [](const EnsembleCase& each) { return orientation_series(each, 360); });
  for (auto& panel : sheet.panels)
    for (auto& series : panel.series) series.point = 0;
  return finish({"fig7_orientation_curved", "Fig. 7",
                 "Distribution of the orientation of curved particles: 0° where the arc bulges up, "
                 "180° where it opens up; mean over the repetitions with its standard error. "
                 "Dashed: isotropic.",
                 ""},
                sheet, out, "no curved case has an orientation distribution");
}

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
       "error over the repetitions. Peaks that stand out by more than 3 standard errors are "
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
       "ones, mean and standard error over the repetitions. Peaks that stand out by more than 3 "
       "standard errors are named by their position.",
       ""},
      sheet, out, "no curved case has a radial distribution function");
  if (figure.not_drawn.empty()) write_text(out + "/fig9_rdf_peaks.csv", peak_columns + rows);
  return figure;
}

StudyFigure draw_pressure(const Ensemble& ensemble, const std::string& out) {
  PanelSheet sheet = pressure_sheet();
  if (const auto* spheres = straight_case(ensemble, Surface::sphere, 1))
    sheet.panels.push_back(sphere_panel(*spheres));
  const std::size_t first = sheet.panels.size();
  add_straight_panels(sheet, ensemble, pressure_series);
  for (std::size_t p = first; p < sheet.panels.size(); ++p)
    for (auto& series : sheet.panels[p].series) series.point = 0;
  sheet.columns = 3;
  fit_depths(sheet);
  return finish({"fig5_pressure", "Fig. 5",
                 "Pressure in the central slice over the depth below the highest surface of the "
                 "repetitions; mean and standard error. Spheres with Janssen's law.",
                 ""},
                sheet, out, "no case of spheres or straight particles has a pressure profile");
}

StudyFigure draw_curved_pressure(const Ensemble& ensemble, const std::string& out) {
  PanelSheet sheet = pressure_sheet();
  add_curved_panels(sheet, ensemble, true, pressure_series);
  for (auto& panel : sheet.panels)
    for (auto& series : panel.series) series.point = 0;
  sheet.columns = 3;
  fit_depths(sheet);
  return finish({"fig10_pressure_curved", "Fig. 10",
                 "Pressure in the central slice over the depth below the highest surface of the "
                 "repetitions, curved particles and the straight smooth ones; mean and standard "
                 "error.",
                 ""},
                sheet, out, "no curved case has a pressure profile");
}

}  // namespace rodpack
