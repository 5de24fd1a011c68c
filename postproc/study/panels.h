// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_STUDY_PANELS_H
#define RODPACK_STUDY_PANELS_H

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "ensemble/ensemble.h"

namespace rodpack {

// Figures of several panels with common axes; for the sources of this room only.

/// The size of the letters, in widths of a figure of one column: 34 of its 1600 pixels. Lengths in
/// a figure are in em.
constexpr double em = 34.0 / 1600;

enum class ErrorsAs { bars, band };

/// One line of a panel, with what its points look like.
struct Series {
  std::vector<double> x, y, sem;  // sem: 0 where there is none
  std::string title;              // in the key; empty: not there
  std::string colour;
  int point = 0;     // gnuplot's point type; 0: a line alone
  int dash = 1;      // gnuplot's dash type
  bool line = true;  // false: points alone
  double line_width = 1;
  // Where on the x axis its averages hold nothing of the space beyond the bed, and where the bed's
  // surface is; none: everywhere, and it is not marked.
  std::optional<std::array<double, 2>> undisturbed;
  std::optional<double> surface;
};

/// Makes a series of a curve, its means and standard errors times `factor`; entries without a
/// repetition are left out, and between others one that is no number parts the line.
Series series_of(const EnsembleCurve& curve, double factor = 1);

/// A name of a place on the x axis, upright in a strip at the top or bottom of a panel.
struct PlaceName {
  double x = 0;   // where it stands
  double of = 0;  // the place; a line leads to it from beside
  bool top = true;
  std::string text;
  std::string colour;
};

enum class Corner { left, middle, right, low };

/// What all series of a panel have undisturbed is white, the rest grey; surfaces are marked at the
/// lower edge.
struct Panel {
  std::string title;
  std::vector<Series> series;
  std::vector<PlaceName> names;
};

/// A sheet of panels with the same x axis, and the same y axis unless each has its own. A key over
/// the sheet has every title of the series once.
struct PanelSheet {
  std::string x_label, y_label;
  double x_low = 0, x_high = 1;
  std::optional<double> y_low = 0;  // none: by the data
  std::string x_tics;               // distance of the tics; empty: gnuplot's choice
  std::optional<double> level;      // a thin line across, such as G = 1
  ErrorsAs errors = ErrorsAs::bars;
  bool own_y = false;  // every panel has a y axis of its own
  int columns = 2;
  double panel_width = 25;  // in sizes of the letters
  double panel_aspect = 1.3;
  Corner title_at = Corner::left;
  std::vector<Panel> panels;
};

/// Draws the sheet: `stem`.png and `stem`.svg. Panels without data are left out. @return false when
/// none is left. @throws DataError when a file cannot be written.
bool draw_panels(const PanelSheet& sheet, const std::string& stem);

/// Look of a surface: coarse '+', smooth 'o'.
Series with_look(Series series, bool coarse);
/// Look of one of several lines, by its place among them.
Series with_look_of_place(Series series, std::size_t place);

}  // namespace rodpack

#endif
