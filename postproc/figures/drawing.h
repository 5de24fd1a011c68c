// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_DRAWING_H
#define RODPACK_FIGURES_DRAWING_H

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "figures/palette.h"
#include "reading/packing.h"

namespace rodpack {

// Pictures drawn as SVG by ourselves; for the rooms that draw packings: this one and page.

/// What the shades of a picture's elements stand for.
struct ColourScale {
  std::vector<double> values;  // one per element, in the unit of the label; empty: one shade
  double lowest = 0;
  double highest = 1;
  bool open_top = false;  // some elements are above the top
  std::string label;
  const std::array<Rgb, 9>* palette = &viridis;
  double tick = 0.5;

  /// Colour of one element, "#rrggbb".
  std::string shade(std::size_t i) const;
};

/// Makes a scale from 0 for force magnitudes (N, at least one), labelled `what` with a readable
/// unit. Its top is `largest`, else a round number that 99 % of the values are below.
ColourScale force_scale(const std::vector<double>& forces, std::optional<double> largest,
                        const std::string& what);

/// Returns what 99 % of `values` (at least one) do not exceed.
double quantile_99(std::vector<double> values);

/// Draws a picture's SVG file as PNG. @throws DataError when rsvg-convert is missing or fails.
void rasterise(const std::string& svg, const std::string& png);

/// Writes SVG elements; coordinates, widths and sizes are in pixels, y points down.
class Drawing {
 public:
  /// Straight line between two points; `cap`: how SVG ends it.
  void line(double x1, double y1, double x2, double y2, double width,
            const std::string& colour = "#202020", const std::string& cap = "square");
  /// Disc; without `fill` in the colour that the drawing has set.
  void circle(double x, double y, double radius, const std::string& fill = "");
  /// Rectangle from its upper left corner; `attributes`: of SVG, such as its fill.
  void rectangle(double x, double y, double width, double height, const std::string& attributes);
  /// Text on one line; `anchor`: the end of it that stands at (x, y), as SVG names it.
  void label(double x, double y, double size, const std::string& anchor, const std::string& content,
             const std::string& attributes = "");
  /// Any element, as it stands.
  void raw(const std::string& element) { text_ += element + "\n"; }
  /// All that was written.
  const std::string& text() const { return text_; }
  /// A coordinate, rounded to hundredths of a pixel.
  static std::string at(double value);

 private:
  std::string text_;
};

/// A picture of a packing in its true aspect ratio: what is drawn between begin() and finish() is
/// cut off at the window; finish() adds walls, scale bar and colour bar.
class PackingPicture {
 public:
  /// `window`: xlo, xhi, ylo, yhi, m, its longer side drawn with `pixels`.
  PackingPicture(const std::array<double, 4>& window, double pixels, bool colour_bar);

  double x(double metres) const { return margin_ + (metres - window_[0]) * per_metre_; }
  double y(double metres) const { return bottom_ - (metres - window_[2]) * per_metre_; }
  double per_metre() const { return per_metre_; }
  /// Size of its letters, pixels.
  double font() const { return font_; }

  Drawing& begin();
  /// Writes `stem`.svg and `stem`.png; the scale bar gives its length also in the particle
  /// `diameter`, m, unless that is 0. @throws DataError when a file cannot be written or
  /// rsvg-convert is missing or fails.
  /// `legend`: colours and what they stand for, beside the scale bar; `scale_bar_note`: what stands
  /// behind its length.
  void finish(const Walls& walls, double diameter, const ColourScale& scale,
              const std::string& stem,
              const std::vector<std::pair<std::string, std::string>>& legend = {},
              const std::string& scale_bar_note = "");

 private:
  void draw_walls(const Walls& walls);
  void draw_scale_bar(double diameter, const std::string& note);
  void draw_legend(const std::vector<std::pair<std::string, std::string>>& legend);

  std::array<double, 4> window_;
  Drawing drawing_;
  bool colour_bar_;
  double per_metre_, draw_width_, draw_height_, font_, wall_, margin_, right_, bottom_;
};

}  // namespace rodpack

#endif
