// SPDX-License-Identifier: GPL-2.0-or-later
#include "study/case_panels.h"

namespace rodpack {
namespace {

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
  without_points(sheet);
  return finish({"fig7_orientation_curved", "Fig. 7",
                 "Distribution of the orientation of curved particles: 0° where the arc bulges up, "
                 "180° where it opens up; mean over the repetitions with its standard error. "
                 "Dashed: isotropic.",
                 ""},
                sheet, out, "no curved case has an orientation distribution");
}

}  // namespace rodpack
