// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_STUDY_CASE_PANELS_H
#define RODPACK_STUDY_CASE_PANELS_H

#include <functional>
#include <optional>
#include <string>

#include "reading/packing.h"
#include "study/panels.h"
#include "study/study_case.h"
#include "study/study_figures.h"

namespace rodpack {

// Which cases stand in which panel; for the sources of this room only.

using SeriesOfCase = std::function<Series(const EnsembleCase&)>;

/// A sheet of one panel: a number of cases over `x_label`, with tics `x_tics` apart.
PanelSheet sheet_of_one(const std::string& x_label, const std::string& y_label,
                        const std::string& x_tics);

/// "AR = 5".
std::string aspect_ratio_title(double aspect_ratio);
/// The angle, as gnuplot writes it, or "straight" for 0.
std::string angle_title(double theta);

/// A curve of a case as a series, times `factor`; empty when there is none.
Series curve_series(const EnsembleCase& each, const std::string& name, double factor = 1);

/// The bed of a case in lengths of d_p, surface at the mean height of the runs' beds, as a packing
/// without particles; none where its numbers do not tell. `omega`: filled with w, d_p.
std::optional<Packing> mean_bed(const EnsembleCase& each, double& omega);

/// Adds a panel per aspect ratio, both surfaces in each.
void add_straight_panels(PanelSheet& sheet, const Ensemble& ensemble, const SeriesOfCase& series);

/// Adds a panel per aspect ratio of curved particles, a line per angle; `straight`: the straight
/// smooth ones too.
void add_curved_panels(PanelSheet& sheet, const Ensemble& ensemble, bool straight,
                       const SeriesOfCase& series);

/// Adds a point to a series.
void add_point(Series& series, double x, const EnsembleMean& value);

/// Leaves room beside the outermost points, so that they do not lie on the frame.
void fit_x(PanelSheet& sheet);

/// Draws lines without points.
void without_points(PanelSheet& sheet);

/// Ends the x axis where the longest series does.
void fit_x_high(PanelSheet& sheet);

/// Draws the sheet into `out`; `missing`: why there is no data, if there is none.
StudyFigure finish(StudyFigure figure, const PanelSheet& sheet, const std::string& out,
                   const std::string& missing);

}  // namespace rodpack

#endif
