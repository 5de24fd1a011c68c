// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/edges/undisturbed.h"
#include "study/case_panels.h"

namespace rodpack {
namespace {

Series slice_series(const EnsembleCase& each) {
  Series series = curve_series(each, "solid_fraction.solid_fraction");
  double omega = 0;
  if (const auto bed = mean_bed(each, omega)) {
    series.undisturbed = undisturbed_heights(*bed, 3 * omega);
    series.surface = bed->surface;
  }
  return series;
}

PanelSheet slice_sheet() {
  PanelSheet sheet;
  sheet.x_label = "height above the floor / {/:Italic d}_p";
  sheet.y_label = "solid fraction {/:Italic φ}";
  sheet.errors = ErrorsAs::band;
  sheet.title_at = Corner::low;
  return sheet;
}

const std::string what =
    " in the central slice over the height above the floor, mean and standard error over the "
    "repetitions. Grey: within 3ω of a wall or the surface, where the kernel averages over the "
    "empty "
    "space beyond; dotted marks below: mean surfaces. ";

}  // namespace

StudyFigure draw_slice(const Ensemble& ensemble, const std::string& out) {
  PanelSheet sheet = slice_sheet();
  add_straight_panels(sheet, ensemble, slice_series);
  without_points(sheet);
  fit_x_high(sheet);
  return finish({"fig2_slice", "Fig. 2", "Solid fraction" + what + "Straight particles.", ""},
                sheet, out, "no straight case has a solid fraction over the height");
}

StudyFigure draw_curved_slice(const Ensemble& ensemble, const std::string& out) {
  PanelSheet sheet = slice_sheet();
  add_curved_panels(sheet, ensemble, true, slice_series);
  without_points(sheet);
  sheet.columns = 3;
  fit_x_high(sheet);
  return finish({"fig2_slice_curved", "Fig. 2", "Solid fraction" + what + "Curved particles.", ""},
                sheet, out, "no curved case has a solid fraction over the height");
}

}  // namespace rodpack
