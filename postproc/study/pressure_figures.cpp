// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

#include "analysis/edges/undisturbed.h"
#include "reading/number_text.h"
#include "study/case_panels.h"
#include "study/pressure.h"

namespace rodpack {
namespace {

Series pressure_series(const EnsembleCase& each) {
  Series series = curve_series(each, "profile.pressure_N_m");
  double omega = 0;
  const auto bed = mean_bed(each, omega);
  if (!bed || series.x.empty()) return series;
  const auto heights = undisturbed_heights(*bed, 3 * omega);
  // Depths count from the highest surface, the floor of the last one.
  const double floor = series.x.back();
  series.undisturbed = {floor - heights[1], floor - heights[0]};
  return series;
}

const std::string grey_means =
    "Grey: within 3ω of the surface or a wall, where the kernel averages over the empty space "
    "beyond.";

PanelSheet pressure_sheet() {
  PanelSheet sheet;
  sheet.x_label = "depth {/:Italic h} / {/:Italic d}_p";
  sheet.y_label = "pressure {/:Italic P}_0 (N/m)";
  sheet.errors = ErrorsAs::band;
  return sheet;
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

StudyFigure draw_pressure(const Ensemble& ensemble, const std::string& out) {
  PanelSheet sheet = pressure_sheet();
  if (const auto* spheres = straight_case(ensemble, Surface::sphere, 1))
    sheet.panels.push_back(sphere_panel(*spheres));
  add_straight_panels(sheet, ensemble, pressure_series);
  without_points(sheet);
  sheet.columns = 3;
  fit_x_high(sheet);
  return finish({"fig5_pressure", "Fig. 5",
                 "Pressure in the central slice over the depth below the highest surface of the "
                 "repetitions; mean and standard error. Spheres with Janssen's law. " +
                     grey_means,
                 ""},
                sheet, out, "no case of spheres or straight particles has a pressure profile");
}

StudyFigure draw_curved_pressure(const Ensemble& ensemble, const std::string& out) {
  PanelSheet sheet = pressure_sheet();
  add_curved_panels(sheet, ensemble, true, pressure_series);
  without_points(sheet);
  sheet.columns = 3;
  fit_x_high(sheet);
  return finish({"fig10_pressure_curved", "Fig. 10",
                 "Pressure in the central slice over the depth below the highest surface of the "
                 "repetitions, curved particles and the straight smooth ones; mean and standard "
                 "error. " +
                     grey_means,
                 ""},
                sheet, out, "no curved case has a pressure profile");
}

StudyFigure draw_pressure_over_theta(const Ensemble& ensemble, const std::string& out) {
  PanelSheet sheet =
      sheet_of_one("opening angle {/:Italic θ} (°)", "mean pressure {/:Italic P}_0 (N/m)", "30");
  Panel panel;
  std::size_t place = 0;
  for (const double aspect_ratio : aspect_ratios(ensemble, true)) {
    Series series = with_look_of_place({}, ++place);
    const auto means = pressure_over_theta(ensemble, aspect_ratio);
    for (std::size_t k = 0; k < means.theta.size(); ++k)
      add_point(series, means.theta[k], means.pressure[k]);
    if (series.x.size() < 2) continue;
    series.title = aspect_ratio_title(aspect_ratio) +
                   ", {/:Italic h} = " + number_text(means.from, 2) + "…" +
                   number_text(means.to, 3) + " {/:Italic d}_p";
    panel.series.push_back(series);
  }
  sheet.panels.push_back(panel);
  fit_x(sheet);
  return finish(
      {"pressure_over_theta", "stress and θ",
       "Pressure over the opening angle of the arc, mean over the lower half of the depths "
       "that all cases of an aspect ratio have, down to 3ω above the floor; 0°: straight, "
       "smooth. Standard errors over the repetitions.",
       ""},
      sheet, out, "no curved case has a pressure profile that reaches below 3ω");
}

}  // namespace rodpack
