// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/drawing.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "reading/number_text.h"
#include "programs/run_program.h"
#include "reading/text_file.h"

namespace rodpack {
namespace {

// Vertical bar with ticks and label; (x, y) its upper left corner.
void draw_colour_bar(Drawing& drawing, const ColourScale& scale, double x, double y, double width,
                     double height, double font) {
  std::string stops;
  constexpr int pieces = 32;
  for (int k = 0; k <= pieces; ++k)
    stops += "<stop offset=\"" + number_text(static_cast<double>(k) / pieces, 4) +
             "\" stop-color=\"" + palette_colour(*scale.palette, static_cast<double>(k) / pieces) +
             "\"/>";
  drawing.raw("<linearGradient id=\"scale\" x1=\"0\" y1=\"1\" x2=\"0\" y2=\"0\">" + stops +
              "</linearGradient>");
  const double line = font / 14;
  const std::string outline =
      "fill=\"url(#scale)\" stroke=\"#202020\" stroke-width=\"" + Drawing::at(line) + "\"";
  if (scale.open_top)  // a tip, for values above the scale
    drawing.raw("<path d=\"M" + Drawing::at(x) + " " + Drawing::at(y) + "l" +
                Drawing::at(width / 2) + " " + Drawing::at(-width * 0.7) + "l" +
                Drawing::at(width / 2) + " " + Drawing::at(width * 0.7) + "z\" fill=\"" +
                palette_colour(*scale.palette, 1) + "\" stroke=\"#202020\" stroke-width=\"" +
                Drawing::at(line) + "\"/>");
  drawing.rectangle(x, y, width, height, outline);
  const double range = scale.highest - scale.lowest;
  double widest = 0;
  for (int k = 0; scale.lowest + k * scale.tick <= scale.highest + 1e-9 * range; ++k) {
    const double value = scale.lowest + k * scale.tick;
    const double tick = y + height * (1 - (value - scale.lowest) / range);
    const auto text = number_text(value, 4);
    widest = std::max(widest, 0.62 * font * static_cast<double>(text.size()));
    drawing.line(x + width, tick, x + width + 0.3 * font, tick, line);
    drawing.label(x + width + 0.5 * font, tick + 0.36 * font, font, "start", text);
  }
  const double axis = x + width + 0.5 * font + widest + 1.1 * font;
  const double middle = y + height / 2;
  drawing.label(axis, middle, font, "middle", scale.label,
                "transform=\"rotate(-90 " + Drawing::at(axis) + " " + Drawing::at(middle) + ")\"");
}

}  // namespace

void rasterise(const std::string& svg, const std::string& png) {
  std::remove(png.c_str());
  const int status = run_program({"rsvg-convert", "--unlimited", "--output=" + png, "--", svg});
  if (status == 127) throw DataError("rsvg-convert was not found: install librsvg2-bin");
  if (status != 0) throw DataError(png + ": rsvg-convert failed to draw it");
}

std::string ColourScale::shade(std::size_t i) const {
  if (values.empty()) return "#8cbbd9";
  if (!std::isfinite(values[i])) return "#b0b0b0";
  return palette_colour(*palette, (values[i] - lowest) / (highest - lowest));
}

double quantile_99(std::vector<double> values) {
  const auto rank =
      values.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), rank, values.end());
  return *rank;
}

ColourScale force_scale(const std::vector<double>& forces, std::optional<double> largest,
                        const std::string& what) {
  ColourScale scale;
  scale.values = forces;
  // A few strongly loaded elements would leave all others in one shade: they share the top one.
  double top = largest ? *largest : quantile_99(forces);
  if (!(top > 0)) top = *std::max_element(scale.values.begin(), scale.values.end());
  if (!(top > 0)) top = 1e-3;  // no contacts at all: any scale shows that
  const auto unit = scaled_unit(top, "N");
  for (auto& value : scale.values) value *= unit.factor;
  scale.highest = top * unit.factor;
  if (!largest) {  // a round number
    const double step = round_step(scale.highest / 5);
    scale.highest = step * std::ceil(scale.highest / step - 1e-9);
  }
  scale.tick = round_step(scale.highest / 3.9);
  scale.open_top = *std::max_element(scale.values.begin(), scale.values.end()) > scale.highest;
  scale.label = what + " (" + unit.name + ")";
  return scale;
}

void Drawing::line(double x1, double y1, double x2, double y2, double width,
                   const std::string& colour, const std::string& cap) {
  text_ += "<path d=\"M" + at(x1) + " " + at(y1) + "L" + at(x2) + " " + at(y2) + "\" stroke=\"" +
           colour + "\" stroke-width=\"" + at(width) + "\" stroke-linecap=\"" + cap + "\"/>\n";
}

void Drawing::circle(double x, double y, double radius, const std::string& fill) {
  text_ += "<circle cx=\"" + at(x) + "\" cy=\"" + at(y) + "\" r=\"" + at(radius) + "\"" +
           (fill.empty() ? "" : " fill=\"" + fill + "\"") + "/>\n";
}

void Drawing::rectangle(double x, double y, double width, double height,
                        const std::string& attributes) {
  text_ += "<rect x=\"" + at(x) + "\" y=\"" + at(y) + "\" width=\"" + at(width) + "\" height=\"" +
           at(height) + "\" " + attributes + "/>\n";
}

void Drawing::label(double x, double y, double size, const std::string& anchor,
                    const std::string& content, const std::string& attributes) {
  text_ += "<text x=\"" + at(x) + "\" y=\"" + at(y) + "\" font-size=\"" + at(size) +
           "\" text-anchor=\"" + anchor + "\" " + attributes + ">" + content + "</text>\n";
}

std::string Drawing::at(double value) { return number_text(std::round(value * 100) / 100, 8); }

PackingPicture::PackingPicture(const std::array<double, 4>& window, double pixels, bool colour_bar)
    : window_(window), colour_bar_(colour_bar) {
  const double width = window[1] - window[0];
  const double height = window[3] - window[2];
  per_metre_ = pixels / std::max(width, height);
  draw_width_ = width * per_metre_;
  draw_height_ = height * per_metre_;
  font_ = std::clamp(std::sqrt(draw_width_ * draw_height_) / 40, 12.0, draw_height_ / 8);
  wall_ = std::max(2.0, font_ / 6);
  margin_ = wall_ + 0.5 * font_;
  right_ = margin_ + draw_width_;
  bottom_ = margin_ + draw_height_;
}

Drawing& PackingPicture::begin() {
  const double total_width = right_ + (colour_bar_ ? 7 * font_ : margin_);
  const double total_height = bottom_ + 2.6 * font_;
  drawing_.raw("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
               Drawing::at(std::ceil(total_width)) + "\" height=\"" +
               Drawing::at(std::ceil(total_height)) +
               "\" font-family=\"DejaVu Sans, sans-serif\" fill=\"#202020\">");
  drawing_.rectangle(0, 0, total_width + 1, total_height + 1, "fill=\"#ffffff\"");
  drawing_.raw("<clipPath id=\"window\">");
  drawing_.rectangle(margin_, margin_, draw_width_, draw_height_, "");
  drawing_.raw("</clipPath>\n<g clip-path=\"url(#window)\">");
  return drawing_;
}

// Walls where the window shows them, just outside the particles' space.
void PackingPicture::draw_walls(const Walls& walls) {
  const double low = std::max(y(window_[2]), 0.0);
  const double eps = 1e-9 * std::max(window_[1] - window_[0], window_[3] - window_[2]);
  if (walls.sides)
    for (const double at : {walls.left, walls.right})
      if (at >= window_[0] - eps && at <= window_[1] + eps) {
        const double shifted = x(at) + (at == walls.left ? -wall_ / 2 : wall_ / 2);
        drawing_.line(shifted, margin_, shifted, std::min(low, y(walls.floor)), wall_);
      }
  if (walls.bottom && walls.floor >= window_[2] - eps && walls.floor <= window_[3] + eps) {
    const double shifted = y(walls.floor) + wall_ / 2;
    drawing_.line(std::max(margin_, x(walls.left)) - wall_ / 2, shifted,
                  std::min(right_, x(walls.right)) + wall_ / 2, shifted, wall_);
  }
}

void PackingPicture::draw_scale_bar(double diameter, const std::string& note) {
  const double bar = round_step((window_[1] - window_[0]) / 3);
  const auto unit = scaled_unit(bar, "m");
  const double level = bottom_ + 1.2 * font_;
  drawing_.line(margin_, level, margin_ + bar * per_metre_, level, 0.22 * font_);
  std::string text = number_text(bar * unit.factor, 4) + " " + unit.name;
  if (diameter > 0)
    text += " = " + number_text(bar / diameter, 3) + " <tspan font-style=\"italic\">d</tspan>" +
            "<tspan dy=\"" + Drawing::at(0.25 * font_) + "\" font-size=\"" +
            Drawing::at(0.7 * font_) + "\">p</tspan>";
  if (!note.empty())
    text += "<tspan dx=\"" + Drawing::at(0.4 * font_) + "\" dy=\"" +
            Drawing::at(diameter > 0 ? -0.25 * font_ : 0) + "\">" + note + "</tspan>";
  drawing_.label(margin_ + bar * per_metre_ + 0.6 * font_, level + 0.36 * font_, font_, "start",
                 text);
}

void PackingPicture::draw_legend(const std::vector<std::pair<std::string, std::string>>& legend) {
  const double level = bottom_ + 1.2 * font_;
  double at = right_;  // entries from the right edge to the left
  for (auto entry = legend.rbegin(); entry != legend.rend(); ++entry) {
    drawing_.label(at, level + 0.36 * font_, font_, "end", entry->second);
    at -= 0.57 * font_ * static_cast<double>(entry->second.size()) + font_;
    drawing_.rectangle(at, level - 0.4 * font_, 0.8 * font_, 0.8 * font_,
                       "fill=\"" + entry->first + "\"");
    at -= 1.2 * font_;
  }
}

void PackingPicture::finish(const Walls& walls, double diameter, const ColourScale& scale,
                            const std::string& stem,
                            const std::vector<std::pair<std::string, std::string>>& legend,
                            const std::string& scale_bar_note) {
  drawing_.raw("</g>");
  draw_walls(walls);
  draw_scale_bar(diameter, scale_bar_note);
  draw_legend(legend);
  if (colour_bar_) {
    const double length = std::min(draw_height_ - 1.5 * font_, 14 * font_);
    draw_colour_bar(drawing_, scale, right_ + 1.2 * font_, margin_ + 1.2 * font_, font_, length,
                    font_);
  }
  drawing_.raw("</svg>");
  write_text(stem + ".svg", drawing_.text());
  rasterise(stem + ".svg", stem + ".png");
}

}  // namespace rodpack
