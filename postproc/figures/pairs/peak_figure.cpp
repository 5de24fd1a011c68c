// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/pairs/peak_figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "figures/figure.h"
#include "figures/rdf_figure.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {

constexpr std::size_t most_insets = 8;
constexpr std::size_t most_in_a_row = 4;
// Heights in units of the figure's width.
constexpr double graph_height = 0.57;  // with what stands above the insets
constexpr double inset_height = 0.27;
constexpr double line_height = 0.033;
constexpr double character_width = 0.0125;

// A configuration of which fewer pairs lie near the one drawn is one of a continuous series.
constexpr double clear_share = 0.75;

// Discs of one colour.
struct Discs {
  std::vector<double> x, y, radius;
  void add(double at_x, double at_y, double r) {
    x.push_back(at_x);
    y.push_back(at_y);
    radius.push_back(r);
  }
};

// The spheres of a particle whose centre of mass is at (x, y), turned by `angle`.
Discs particle(const ChainShape& shape, double x, double y, double angle) {
  Discs discs;
  const double c = std::cos(angle), s = std::sin(angle);
  for (const auto& [u, v] : sphere_centres(shape))
    discs.add(x + c * u - s * v, y + s * u + c * v, shape.diameter / 2);
  return discs;
}

struct Inset {
  Discs centre, neighbour, common;
  bool centre_in_front = true;
  std::array<double, 2> neighbour_at{};    // its centre of mass; that of the other is opposite
  double half_width = 0, half_height = 0;  // of all discs about the middle of the two centres
};

// Spheres that touch both of a pair that is `distance` apart lie above and below the middle.
Discs common_spheres(double distance, int count) {
  Discs discs;
  if (distance >= 2) return discs;
  const double height = std::sqrt(1 - distance * distance / 4);
  for (int k = 0; k < std::min(count, 2); ++k) discs.add(0, k == 0 ? height : -height, 0.5);
  return discs;
}

// Where a place of the centre particle's frame is seen, from beside and above; last its depth,
// which grows towards the eye.
Vector3 seen(const Vector3& place) {
  constexpr double aside = 0.44, above = 0.35;  // rad
  const double behind = place[2] * std::cos(aside) - place[0] * std::sin(aside);
  return {place[0] * std::cos(aside) + place[2] * std::sin(aside),
          place[1] * std::cos(above) + behind * std::sin(above),
          behind * std::cos(above) - place[1] * std::sin(above)};
}

// The spheres of a straight particle, in space.
std::vector<Vector3> spheres_in_space(const ChainShape& shape, const Vector3& middle,
                                      const Vector3& axis) {
  std::vector<Vector3> places;
  for (const auto& sphere : sphere_centres(shape)) {
    places.push_back(middle);
    for (std::size_t c = 0; c < 3; ++c) places.back()[c] += sphere[0] * axis[c];
  }
  return places;
}

// Two rods do not overlap, so that one of them is in front where they are closest.
Inset inset_in_space(const PeakExplanation& explanation, const PeakConfiguration& configuration) {
  const auto& pair = configuration.pair;
  const Vector3 half{pair.along / 2, pair.across / 2, 0};
  const auto centre =
      spheres_in_space(explanation.shape, {-half[0], -half[1], 0}, Vector3{1, 0, 0});
  const auto neighbour = spheres_in_space(explanation.shape, half, configuration.axis);
  Inset inset;
  const auto at = seen(half);
  inset.neighbour_at = {at[0], at[1]};
  double least = std::numeric_limits<double>::infinity();
  for (const auto& a : centre)
    for (const auto& b : neighbour) {
      const double distance = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
      if (distance < least) inset.centre_in_front = seen(a)[2] >= seen(b)[2];
      least = std::min(least, distance);
    }
  for (const auto& [places, discs] :
       {std::pair(&centre, &inset.centre), std::pair(&neighbour, &inset.neighbour)})
    for (const auto& place : *places) {
      const auto [x, y, depth] = seen(place);
      discs->add(x, y, explanation.shape.diameter / 2);
    }
  return inset;
}

Inset inset_in_plane(const PeakExplanation& explanation, const PeakConfiguration& configuration) {
  const auto& pair = configuration.pair;
  Inset inset;
  inset.neighbour_at = {pair.along / 2, pair.across / 2};
  inset.centre = particle(explanation.shape, -pair.along / 2, -pair.across / 2, 0);
  inset.neighbour = particle(explanation.shape, pair.along / 2, pair.across / 2, pair.angle);
  return inset;
}

Inset inset_of(const PeakExplanation& explanation, const PeakConfiguration& configuration) {
  const bool rods_in_space = explanation.in_space && explanation.kind != ParticleKind::sphere;
  auto inset = rods_in_space ? inset_in_space(explanation, configuration)
                             : inset_in_plane(explanation, configuration);
  if (explanation.kind == ParticleKind::sphere)
    inset.common = common_spheres(configuration.distance,
                                  static_cast<int>(std::lround(configuration.common_neighbours)));
  for (const auto* discs : {&inset.centre, &inset.neighbour, &inset.common})
    for (std::size_t k = 0; k < discs->x.size(); ++k) {
      inset.half_width = std::max(inset.half_width, std::abs(discs->x[k]) + discs->radius[k]);
      inset.half_height = std::max(inset.half_height, std::abs(discs->y[k]) + discs->radius[k]);
    }
  return inset;
}

// Words on lines of at most so many characters; some stay with the word before them.
std::vector<std::string> wrapped(const std::string& text, std::size_t width) {
  std::vector<std::string> lines{""};
  std::size_t begin = 0, length = 0;
  while (begin < text.size()) {
    const auto end = std::min(text.find(' ', begin), text.size());
    const auto word = text.substr(begin, end - begin);
    const bool stays = word == "d_p" || word == "on" || word == "%";
    if (length > 0 && !stays && length + 1 + word.size() > width) {
      lines.emplace_back();
      length = 0;
    }
    lines.back() += (length > 0 ? " " : "") + (word == "d_p" ? "{/:Italic d}_p" : word);
    length += word.size() + 1;
    begin = end + 1;
  }
  return lines;
}

std::string percent(double share) { return number_text(std::round(1000 * share) / 10, 3) + " %"; }

std::string label(const std::string& text, double x, double y) {
  return "set label '" + text + "' at screen " + number_text(x, 6) + "," + number_text(y, 6) +
         " center\n";
}

std::string margins(double left, double right, double bottom, double top) {
  return "set lmargin at screen " + number_text(left, 6) + "\nset rmargin at screen " +
         number_text(right, 6) + "\nset bmargin at screen " + number_text(bottom, 6) +
         "\nset tmargin at screen " + number_text(top, 6) + "\n";
}

std::string graph(const Rdf& rdf, const RdfPeak& peak, double height) {
  const double highest = *std::max_element(rdf.g.begin(), rdf.g.end());
  return datablock("g", {rdf.r, drawn_g(rdf)}) +
         margins(0.14, 0.96, 1 - (graph_height - 0.17) / height, 1 - 0.02 / height) +
         "set xlabel 'distance {/:Italic r} / {/:Italic d}_p'\n"
         "set ylabel '{/:Italic G}({/:Italic r})'\n"
         "set xrange [0:" +
         number_text(rdf.r.back() + rdf.r.front()) +
         "]\nset yrange [0:" + number_text(1.1 * highest) + "]\nset object 1 rectangle from " +
         number_text(peak.from) + ", graph 0 to " + number_text(peak.to) +
         ", graph 1 behind fillcolor '#f3d3bd' fillstyle solid noborder\n"
         "plot 1 with lines dashtype 2 linewidth 1 linecolor '" +
         colour::grey + "', $g using 1:2 with lines linewidth 1.3 linecolor '" + colour::blue +
         "'\n";
}

std::string discs_plot(const std::string& block, const std::string& fill) {
  const std::string discs = "$" + block + " using 1:2";
  return discs + ":($3+0.045) with circles linecolor '#202020' fillstyle solid, " + discs +
         ":3 with circles linecolor '" + fill + "' fillstyle solid, " + discs +
         ":3 with circles linewidth 0.6 linecolor '#60202020' fillstyle empty";
}

// The two particles and the line between their centres, in a window of d_p around its middle.
std::string pair_plot(const Inset& inset, std::size_t k, double width, double height) {
  const auto id = std::to_string(k);
  const auto block = [&](const std::string& name, const Discs& discs) {
    return discs.x.empty() ? "" : datablock(name + id, {discs.x, discs.y, discs.radius});
  };
  const auto range = [](const char* axis, double size) {
    return "set " + std::string(axis) + "range [" + number_text(-size / 2) + ":" +
           number_text(size / 2) + "]\n";
  };
  std::string text = block("c", inset.centre) + block("n", inset.neighbour) +
                     block("s", inset.common) +
                     datablock("l" + id, {{-inset.neighbour_at[0], inset.neighbour_at[0]},
                                          {-inset.neighbour_at[1], inset.neighbour_at[1]}}) +
                     range("x", width) + range("y", height) + "plot ";
  if (!inset.common.x.empty())
    text += "$s" + id +
            " using 1:2:3 with circles linewidth 0.8 dashtype 2 linecolor '#7F7F7F' "
            "fillstyle empty, ";
  const auto neighbour = discs_plot("n" + id, "#f2c9a8"), centre = discs_plot("c" + id, "#9cc6e3");
  text += inset.centre_in_front ? neighbour + ", " + centre : centre + ", " + neighbour;
  return text + ", $l" + id +
         " using 1:2 with linespoints linewidth 0.8 pointtype 7 pointsize 0.5 linecolor "
         "'#202020'\n";
}

// What stands below an inset: share and name, and how much of a continuous series is near.
std::vector<std::string> caption(const PeakConfiguration& configuration, std::size_t width) {
  std::vector<std::string> lines{"{/:Bold " + percent(configuration.share) + "}"};
  for (const auto& line : wrapped(configuration.name, width)) lines.push_back(line);
  if (configuration.near_share < clear_share)
    for (const auto& line :
         wrapped(percent(configuration.near_share) + " of these within 0.3 d_p", width + width / 6))
      lines.push_back("{/=*0.85 " + line + "}");
  return lines;
}

}  // namespace

void plot_peak(const Rdf& rdf, const PeakExplanation& explanation, const std::string& stem) {
  const auto count = std::min(explanation.configurations.size(), most_insets);
  const auto columns = std::max<std::size_t>(std::min(count, most_in_a_row), 1);
  const double cell = 0.94 / static_cast<double>(columns);
  std::vector<Inset> insets;
  std::vector<std::vector<std::string>> captions;
  double half_width = 0, half_height = 0;
  std::size_t lines = 0;
  for (std::size_t k = 0; k < count; ++k) {
    insets.push_back(inset_of(explanation, explanation.configurations[k]));
    captions.push_back(
        caption(explanation.configurations[k], static_cast<std::size_t>(cell / character_width)));
    half_width = std::max(half_width, insets.back().half_width);
    half_height = std::max(half_height, insets.back().half_height);
    lines = std::max(lines, captions.back().size());
  }
  // One scale for all, d_p per width of the figure: what fits the widest and the highest of them.
  const double scale = 1.06 * std::max({2 * half_width / cell, 2 * half_height / inset_height,
                                        0.5 / (0.12 * inset_height)});
  const double row_height = inset_height + line_height * static_cast<double>(lines + 1);
  const auto rows = (count + columns - 1) / columns;
  const double height = graph_height + static_cast<double>(rows) * row_height;

  const auto& peak = explanation.peak;
  std::string commands = "set multiplot\n" + graph(rdf, peak, height) +
                         "unset object\nunset border\nunset tics\nunset xlabel\nunset ylabel\n";
  for (std::size_t k = 0; k < count; ++k) {
    const auto row = k / columns;
    const auto in_row = std::min(columns, count - row * columns);
    const double left =
        0.5 + cell * (static_cast<double>(k % columns) - static_cast<double>(in_row) / 2);
    const double top = 1 - (graph_height + static_cast<double>(row) * row_height) / height;
    const double bottom = top - inset_height / height;
    commands += margins(left, left + cell, bottom, top) + "unset label\n";
    if (k == 0)
      commands +=
          label("pairs at " + number_text(peak.from, 4) + " to " + number_text(peak.to, 4) +
                    " {/:Italic d}_p; in none of these: " + percent(explanation.other_share),
                0.5, 1 - (graph_height - line_height) / height);
    for (std::size_t line = 0; line < captions[k].size(); ++line)
      commands += label(captions[k][line], left + cell / 2,
                        bottom - line_height * (static_cast<double>(line) + 0.8) / height);
    commands += pair_plot(insets[k], k, cell * scale, inset_height * scale);
  }
  draw_figure(stem, 1 / height, commands + "unset multiplot\n");
}

}  // namespace rodpack
