// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/render.h"

#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>
#include <numeric>

#include "palette.h"
#include "rodpack/text.h"

namespace rodpack {
namespace {
constexpr double degree = 3.14159265358979323846 / 180;

// What the spheres' shades stand for.
struct ColourScale {
  std::vector<double> values;  // one per sphere, in the unit of the label; empty: one shade
  double lowest = 0;
  double highest = 1;
  bool open_top = false;  // some spheres are above the top
  std::string label;
  const std::array<Rgb, 9>* palette = &viridis;
  double tick = 0.5;

  std::string shade(std::size_t i) const {
    if (values.empty()) return "#8cbbd9";
    if (!std::isfinite(values[i])) return "#b0b0b0";
    return palette_colour(*palette, (values[i] - lowest) / (highest - lowest));
  }
};

ColourScale orientation_scale(const Frame& spheres) {
  ColourScale scale;
  const double period = spheres.periodic[0] ? spheres.bounds[0][1] - spheres.bounds[0][0] : 0;
  scale.values =
      long_axis_degrees(spheres.column("body"), spheres.column("x"), spheres.column("y"), period);
  scale.highest = 180;
  scale.tick = 45;
  scale.palette = &twilight;
  scale.label = "direction of the long axis (°)";
  return scale;
}

ColourScale force_scale(const Frame& spheres, SphereColour colour, std::optional<double> largest) {
  ColourScale scale;
  if (colour == SphereColour::fsum) {
    scale.values = spheres.column("fsum");
  } else {
    const auto& fx = spheres.column("fx");
    const auto& fy = spheres.column("fy");
    const auto& fz = spheres.column("fz");
    for (std::size_t i = 0; i < spheres.rows; ++i)
      scale.values.push_back(std::hypot(fx[i], fy[i], fz[i]));
  }
  // A few strongly loaded spheres would leave all others in one shade: they share the top one.
  auto sorted = scale.values;
  const auto rank = sorted.begin() + static_cast<std::ptrdiff_t>(0.99 * (sorted.size() - 1));
  std::nth_element(sorted.begin(), rank, sorted.end());
  double top = largest.value_or(*rank);
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
  scale.label = std::string(colour == SphereColour::fsum ? "sum of contact forces"
                                                         : "contact force on sphere") +
                " (" + unit.name + ")";
  return scale;
}

// Writes SVG elements; the drawing's own coordinates are pixels with y down.
class Drawing {
 public:
  void line(double x1, double y1, double x2, double y2, double width,
            const std::string& colour = "#202020") {
    text_ += "<path d=\"M" + at(x1) + " " + at(y1) + "L" + at(x2) + " " + at(y2) + "\" stroke=\"" +
             colour + "\" stroke-width=\"" + at(width) + "\" stroke-linecap=\"square\"/>\n";
  }
  void circle(double x, double y, double radius, const std::string& fill = "") {
    text_ += "<circle cx=\"" + at(x) + "\" cy=\"" + at(y) + "\" r=\"" + at(radius) + "\"" +
             (fill.empty() ? "" : " fill=\"" + fill + "\"") + "/>\n";
  }
  void rectangle(double x, double y, double width, double height, const std::string& attributes) {
    text_ += "<rect x=\"" + at(x) + "\" y=\"" + at(y) + "\" width=\"" + at(width) + "\" height=\"" +
             at(height) + "\" " + attributes + "/>\n";
  }
  void label(double x, double y, double size, const std::string& anchor, const std::string& content,
             const std::string& attributes = "") {
    text_ += "<text x=\"" + at(x) + "\" y=\"" + at(y) + "\" font-size=\"" + at(size) +
             "\" text-anchor=\"" + anchor + "\" " + attributes + ">" + content + "</text>\n";
  }
  void raw(const std::string& element) { text_ += element + "\n"; }
  const std::string& text() const { return text_; }
  static std::string at(double value) { return number_text(std::round(value * 100) / 100, 8); }

 private:
  std::string text_;
};

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

void rasterise(const std::string& svg, const std::string& png) {
  std::remove(png.c_str());
  const auto quoted = [](const std::string& name) {
    std::string result = "'";
    for (const char c : name) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
  };
  const auto command = "rsvg-convert --unlimited -o " + quoted(png) + " -- " + quoted(svg);
  const int status = std::system(command.c_str());
  if (WIFEXITED(status) && WEXITSTATUS(status) == 127)
    throw DataError("rsvg-convert was not found: install librsvg2-bin");
  if (status != 0) throw DataError(png + ": rsvg-convert failed to draw it");
}

}  // namespace

std::vector<double> long_axis_degrees(const std::vector<double>& body, const std::vector<double>& x,
                                      const std::vector<double>& y, double period) {
  struct Moments {
    double x0, y0;  // the first sphere of the body, to unwrap the others
    double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  };
  std::map<double, Moments> bodies;
  for (std::size_t i = 0; i < body.size(); ++i) {
    auto& m = bodies.try_emplace(body[i], Moments{x[i], y[i]}).first->second;
    double dx = x[i] - m.x0;
    if (period > 0) dx -= period * std::round(dx / period);
    const double dy = y[i] - m.y0;
    m.n += 1;
    m.x += dx;
    m.y += dy;
    m.xx += dx * dx;
    m.xy += dx * dy;
    m.yy += dy * dy;
  }
  std::vector<double> result;
  for (const double id : body) {
    const auto& m = bodies.at(id);
    if (m.n < 2) {
      result.push_back(std::numeric_limits<double>::quiet_NaN());
      continue;
    }
    const double xx = m.xx - m.x * m.x / m.n;
    const double xy = m.xy - m.x * m.y / m.n;
    const double yy = m.yy - m.y * m.y / m.n;
    const double angle = 0.5 * std::atan2(2 * xy, xx - yy) / degree;
    result.push_back(angle < 0 ? angle + 180 : angle);
  }
  return result;
}

double sphere_diameter(const Frame& spheres, const PackingOptions& options) {
  if (options.particle_diameter) return *options.particle_diameter;
  const auto parameters = find_parameters(spheres.file, options.parameters);
  if (parameters && parameters->values.contains("particle_diameter_m"))
    return parameters->number("particle_diameter_m");
  const auto& radius = spheres.column("radius");
  return 2 * std::accumulate(radius.begin(), radius.end(), 0.0) / static_cast<double>(spheres.rows);
}

void render_spheres(const Frame& spheres, const RenderOptions& options, const std::string& stem) {
  const auto& x = spheres.column("x");
  const auto& y = spheres.column("y");
  const auto& radius = spheres.column("radius");
  if (spheres.rows == 0)
    throw DataError(spheres.file + ": the frame of timestep " + std::to_string(spheres.timestep) +
                    " holds no spheres");
  const Walls walls = find_walls(spheres, options.packing,
                                 find_parameters(spheres.file, options.packing.parameters));
  const double diameter = sphere_diameter(spheres, options.packing);

  double top = walls.floor;
  for (std::size_t i = 0; i < spheres.rows; ++i) top = std::max(top, y[i] + radius[i]);
  const auto window = options.window.value_or(
      std::array<double, 4>{walls.left, walls.right, walls.floor, top + 0.5 * diameter});
  const double width = window[1] - window[0];
  const double height = window[3] - window[2];
  std::vector<std::size_t> visible;
  for (std::size_t i = 0; i < spheres.rows; ++i)
    if (x[i] + radius[i] > window[0] && x[i] - radius[i] < window[1] &&
        y[i] + radius[i] > window[2] && y[i] - radius[i] < window[3])
      visible.push_back(i);
  if (visible.empty())
    throw DataError(spheres.file + ": no sphere lies in the window x " + number_text(window[0]) +
                    " ... " + number_text(window[1]) + " m, y " + number_text(window[2]) + " ... " +
                    number_text(window[3]) + " m");

  ColourScale scale;
  if (options.colour == SphereColour::orientation)
    scale = orientation_scale(spheres);
  else if (options.colour != SphereColour::none)
    scale = force_scale(spheres, options.colour, options.largest);

  const double longer = std::max(width, height);
  const double pixels =
      options.pixels > 0 ? options.pixels : std::clamp(8 * longer / diameter, 1200.0, 4000.0);
  const double per_metre = pixels / longer;
  const double draw_width = width * per_metre;
  const double draw_height = height * per_metre;
  const double font = std::clamp(std::sqrt(draw_width * draw_height) / 40, 12.0, draw_height / 8);
  const double wall = std::max(2.0, font / 6);
  const double margin = wall + 0.5 * font;
  const double right = margin + draw_width;
  const double bottom = margin + draw_height;
  const double total_width = right + (scale.values.empty() ? margin : 7 * font);
  const double total_height = bottom + 2.6 * font;

  Drawing drawing;
  drawing.raw("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
              Drawing::at(std::ceil(total_width)) + "\" height=\"" +
              Drawing::at(std::ceil(total_height)) +
              "\" font-family=\"DejaVu Sans, sans-serif\" fill=\"#202020\">");
  drawing.rectangle(0, 0, total_width + 1, total_height + 1, "fill=\"#ffffff\"");
  drawing.raw("<clipPath id=\"window\">");
  drawing.rectangle(margin, margin, draw_width, draw_height, "");
  drawing.raw("</clipPath>\n<g clip-path=\"url(#window)\">");
  const auto px = [&](double value) { return margin + (value - window[0]) * per_metre; };
  const auto py = [&](double value) { return bottom - (value - window[2]) * per_metre; };
  // All dark discs first, the shaded ones a little smaller on top: an outline around each particle,
  // none between the overlapping spheres of one.
  const double outline = std::clamp(0.06 * diameter * per_metre, 0.3, 3.0);
  for (const auto i : visible) drawing.circle(px(x[i]), py(y[i]), radius[i] * per_metre);
  for (const auto i : visible)
    drawing.circle(px(x[i]), py(y[i]), radius[i] * per_metre - outline, scale.shade(i));
  drawing.raw("</g>");

  // Walls where the window shows them, just outside the particles' space.
  const double low = std::max(py(window[2]), 0.0);
  const double eps = 1e-9 * longer;
  if (walls.sides)
    for (const double at : {walls.left, walls.right})
      if (at >= window[0] - eps && at <= window[1] + eps) {
        const double shifted = px(at) + (at == walls.left ? -wall / 2 : wall / 2);
        drawing.line(shifted, margin, shifted, std::min(low, py(walls.floor)), wall);
      }
  if (walls.bottom && walls.floor >= window[2] - eps && walls.floor <= window[3] + eps) {
    const double shifted = py(walls.floor) + wall / 2;
    drawing.line(std::max(margin, px(walls.left)) - wall / 2, shifted,
                 std::min(right, px(walls.right)) + wall / 2, shifted, wall);
  }

  const double bar = round_step(width / 3);
  const auto unit = scaled_unit(bar, "m");
  const double level = bottom + 1.2 * font;
  drawing.line(margin, level, margin + bar * per_metre, level, 0.22 * font);
  drawing.label(margin + bar * per_metre + 0.6 * font, level + 0.36 * font, font, "start",
                number_text(bar * unit.factor, 4) + " " + unit.name + " = " +
                    number_text(bar / diameter, 3) + " <tspan font-style=\"italic\">d</tspan>" +
                    "<tspan dy=\"" + Drawing::at(0.25 * font) + "\" font-size=\"" +
                    Drawing::at(0.7 * font) + "\">p</tspan>");
  if (!scale.values.empty()) {
    const double length = std::min(draw_height - 1.5 * font, 14 * font);
    draw_colour_bar(drawing, scale, right + 1.2 * font, margin + 1.2 * font, font, length, font);
  }
  drawing.raw("</svg>");
  write_text(stem + ".svg", drawing.text());
  rasterise(stem + ".svg", stem + ".png");
}

}  // namespace rodpack
