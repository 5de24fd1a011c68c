// SPDX-License-Identifier: GPL-2.0-or-later
#include "study/panels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <regex>
#include <set>

#include "figures/edges/shading.h"
#include "figures/figure.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {

struct Layout {
  int columns = 1, rows = 1;
  double left = 6, right = 1.8, bottom = 4.3, top = 0.8;
  double gap_x = 2.2, gap_y = 1.1, panel_width = 1, panel_height = 1;
  int key_rows = 0;
  double key_entry = 0;  // width

  double width() const { return left + columns * panel_width + (columns - 1) * gap_x + right; }
  double height() const { return bottom + rows * panel_height + (rows - 1) * gap_y + top; }
  std::string across(double length) const { return number_text(length / width(), 6); }
  std::string up(double length) const { return number_text(length / height(), 6); }
};

bool empty(const Panel& panel) {
  return std::all_of(panel.series.begin(), panel.series.end(),
                     [](const Series& each) { return each.x.empty(); });
}

double lowest_of(const Panel& panel) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const auto& series : panel.series)
    for (std::size_t k = 0; k < series.x.size(); ++k)
      lowest = std::min(lowest, series.y[k] - series.sem[k]);
  return lowest;
}

double highest_of(const Panel& panel) {
  double highest = -std::numeric_limits<double>::infinity();
  for (const auto& series : panel.series)
    for (std::size_t k = 0; k < series.x.size(); ++k)
      highest = std::max(highest, series.y[k] + series.sem[k]);
  return highest;
}

std::string look_of(const Series& series) {
  return " linewidth " + number_text(series.line_width) + " dashtype " +
         std::to_string(series.dash) + " linecolor '" + series.colour + "'" +
         (series.point ? " pointtype " + std::to_string(series.point) + " pointsize 1" : "");
}

std::string style_of(const Series& series) {
  return !series.point ? "lines" : series.line ? "linespoints" : "points";
}

// What gnuplot plots of one series, its data in the block `name`.
std::string plot_of(const Series& series, const std::string& name, ErrorsAs errors) {
  const bool any =
      std::any_of(series.sem.begin(), series.sem.end(), [](double error) { return error > 0; });
  std::string text;
  if (any && errors == ErrorsAs::band)
    text = name +
           " using 1:($2-$3):($2+$3) with filledcurves fillstyle transparent solid 0.25 "
           "linecolor '" +
           series.colour + "', ";
  if (any && errors == ErrorsAs::bars)
    text = name +
           " using ($3 > 0 ? $1 : NaN):($2-$3):(0):(2*$3) with vectors heads size graph "
           "0.007,90 linewidth 0.8 linecolor '" +
           series.colour + "', ";
  return text + name + " using 1:2 with " + style_of(series) + look_of(series);
}

// Series whose titles stand in the key, each title once.
std::vector<const Series*> key_of(const std::vector<const Panel*>& panels) {
  std::set<std::string> seen;
  std::vector<const Series*> entries;
  for (const auto* panel : panels)
    for (const auto& series : panel->series)
      if (!series.x.empty() && !series.title.empty() && seen.insert(series.title).second)
        entries.push_back(&series);
  return entries;
}

struct Range {
  double low, high;
};

// The data of these panels, with a margin at the ends that are not given.
Range y_range(const PanelSheet& sheet, const std::vector<const Panel*>& panels) {
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const auto* panel : panels) {
    range.low = std::min(range.low, lowest_of(*panel));
    range.high = std::max(range.high, highest_of(*panel));
  }
  if (sheet.y_low) range.low = *sheet.y_low;
  double extent = range.high - range.low;
  if (!(extent > 0)) extent = std::max(std::fabs(range.high), 1e-12);
  range.high += 0.08 * extent;
  if (!sheet.y_low) range.low -= 0.08 * extent;
  return range;
}

// Distance of the tics, some four of them.
double tic_step(const Range& range) { return round_step((range.high - range.low) / 4); }

// Letters of the longest number at the y axis.
double longest_number(const Range& range) {
  const double step = tic_step(range);
  std::size_t longest = 1;
  for (double k = std::ceil(range.low / step - 1e-9); k * step <= range.high; ++k)
    longest = std::max(longest, number_text(k * step, 6).size());
  return static_cast<double>(longest);
}

// Letters of the longest title, without gnuplot's marks of fonts.
double longest_title(const std::vector<const Series*>& key) {
  static const std::regex mark("\\{/:?[^ ]* |[{}]");
  long longest = 0;
  for (const auto* series : key) {
    const auto plain = std::regex_replace(series->title, mark, "");
    longest = std::max(longest, std::count_if(plain.begin(), plain.end(), [](char c) {
                         return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
                       }));
  }
  return static_cast<double>(longest);
}

Layout layout_of(const PanelSheet& sheet, const std::vector<const Panel*>& panels,
                 const std::vector<const Series*>& key) {
  Layout layout;
  const int count = static_cast<int>(panels.size());
  layout.left = 3.6 + 0.66 * longest_number(y_range(sheet, panels));
  layout.columns = std::min(sheet.columns, count);
  layout.rows = (count + layout.columns - 1) / layout.columns;
  layout.panel_width = sheet.panel_width;
  layout.panel_height = sheet.panel_width / sheet.panel_aspect;
  if (sheet.own_y) layout.gap_x = 4;
  if (!key.empty()) {
    layout.key_entry = 4.5 + 0.62 * longest_title(key);
    const auto per_row = std::max(1.0, std::floor((layout.width() - 2) / layout.key_entry));
    layout.key_rows = static_cast<int>(std::ceil(static_cast<double>(key.size()) / per_row));
    layout.top = 0.7 + 1.8 * layout.key_rows;
  }
  return layout;
}

// The key has the width of the whole sheet: a plot of its own, of nothing.
std::string key_plot(const std::vector<const Series*>& key, const Layout& layout) {
  if (key.empty()) return "";
  // gnuplot counts the marks of fonts as letters.
  const bool marks = std::any_of(key.begin(), key.end(), [](const Series* series) {
    return series->title.find('{') != std::string::npos;
  });
  std::string text = "set lmargin at screen 0\nset rmargin at screen 1\nset bmargin at screen " +
                     layout.up(layout.height() - layout.top) +
                     "\nset tmargin at screen 1\nunset border\nunset tics\nset xrange [0:1]\n"
                     "set yrange [0:1]\nset key center center horizontal maxrows " +
                     std::to_string(layout.key_rows) +
                     (marks ? " samplen 1.4 width -1" : " width 1") + " Left reverse\n";
  std::string parts;
  for (const auto* series : key)
    parts +=
        ", NaN with " + style_of(*series) + look_of(*series) + " title '" + series->title + "'";
  return text + "plot " + parts.substr(2) +
         "\nunset key\nset border 15\nset xtics\nset ytics\nset mxtics 2\nset mytics 2\n";
}

// Labels of both axes, once for the whole sheet.
std::string sheet_labels(const PanelSheet& sheet, const Layout& layout) {
  const double middle_x = layout.left + 0.5 * (layout.width() - layout.left - layout.right);
  const double middle_y = layout.bottom + 0.5 * (layout.height() - layout.bottom - layout.top);
  return "set label 1 '" + sheet.x_label + "' at screen " + layout.across(middle_x) + "," +
         layout.up(0.9) + " center\nset label 2 '" + sheet.y_label + "' at screen " +
         layout.across(1.3) + "," + layout.up(middle_y) + " center rotate by 90\n";
}

// Range and tics of the y axis; strips of names lie beyond the data.
std::string y_axis(const Panel& panel, const Range& data) {
  const auto any = [&](bool at_top) {
    return std::any_of(panel.names.begin(), panel.names.end(),
                       [&](const PlaceName& name) { return name.top == at_top; });
  };
  const double strip = 0.24 * (data.high - data.low);
  const double step = tic_step(data);
  return "set yrange [" + number_text(data.low - (any(false) ? strip : 0)) + ":" +
         number_text(data.high + (any(true) ? strip : 0)) + "]\nset ytics " +
         number_text(step * std::ceil(data.low / step - 1e-9)) + "," + number_text(step) + "," +
         number_text(data.high) + "\n";
}

// Grey where the averages of a series are disturbed, and marks at the surfaces.
std::string edges_of(const PanelSheet& sheet, const Panel& panel) {
  double from = sheet.x_low, to = sheet.x_high;
  std::string marks;
  for (const auto& series : panel.series) {
    if (series.x.empty()) continue;
    if (series.undisturbed) {
      from = std::max(from, (*series.undisturbed)[0]);
      to = std::min(to, (*series.undisturbed)[1]);
    }
    if (series.surface)
      marks += "set arrow from first " + number_text(*series.surface) + ", graph 0 to first " +
               number_text(*series.surface) +
               ", graph 0.16 nohead back linewidth 1.4 dashtype 3 linecolor '" + series.colour +
               "'\n";
  }
  if (from >= to) return grey_strip('x', sheet.x_low, sheet.x_high) + marks;
  return grey_strip('x', sheet.x_low, from) + grey_strip('x', to, sheet.x_high) + marks;
}

// Names in the strips, clear of the tics, those beside their place with a line to it.
std::string names_of(const Panel& panel, const Layout& layout) {
  const double letter = 1 / layout.panel_height;
  // From the edge: tics, four letters of 0.7 the size on their side, the line.
  const double begin = 0.9 * letter, end = begin + 1.9 * letter, tip = end + 0.6 * letter;
  std::string text;
  int number = 4;
  for (const auto& name : panel.names) {
    const auto level = [&](double from_edge) {
      return ",graph " + number_text(name.top ? 1 - from_edge : from_edge, 6);
    };
    text += "set label " + std::to_string(number++) + " '{/*0.7 " + name.text + "}' at first " +
            number_text(name.x) + level(begin) + (name.top ? " right" : " left") +
            " rotate by 90 front textcolor '" + name.colour + "'\n";
    if (name.x != name.of)  // an upright line would be read as a minus sign
      text += "set arrow from first " + number_text(name.x) + level(end) + " to first " +
              number_text(name.of) + level(tip) + " nohead front linewidth 0.6 linecolor '" +
              name.colour + "'\n";
  }
  return text;
}

// Frame, axes and texts of the panel at `place`, of `count` ones.
std::string axes_of(const PanelSheet& sheet, const Panel& panel, const Layout& layout, int place,
                    int count, const Range& shared) {
  const int column = place % layout.columns, row = place / layout.columns;
  const double x0 = layout.left + column * (layout.panel_width + layout.gap_x);
  const double y0 =
      layout.height() - layout.top - (row + 1) * layout.panel_height - row * layout.gap_y;
  const bool lowest = place + layout.columns >= count;  // nothing stands below it
  const bool names_above = std::any_of(panel.names.begin(), panel.names.end(),
                                       [](const PlaceName& name) { return name.top; });
  const std::string level = names_above ? "0.78" : "0.91";
  const std::string titles[] = {"0.04,graph " + level + " left", "0.5,graph " + level + " center",
                                "0.96,graph " + level + " right", "0.5,graph 0.1 center"};
  std::string text = "set lmargin at screen " + layout.across(x0) + "\nset rmargin at screen " +
                     layout.across(x0 + layout.panel_width) + "\nset bmargin at screen " +
                     layout.up(y0) + "\nset tmargin at screen " +
                     layout.up(y0 + layout.panel_height) + "\nset xrange [" +
                     number_text(sheet.x_low) + ":" + number_text(sheet.x_high) + "]\n" +
                     y_axis(panel, sheet.own_y ? y_range(sheet, {&panel}) : shared) +
                     "set format x '" + (lowest ? "%g" : "") + "'\nset format y '" +
                     (column == 0 || sheet.own_y ? "%g" : "") + "'\nset label 3 '" + panel.title +
                     "' at graph " + titles[static_cast<int>(sheet.title_at)] + " front\n";
  return text + names_of(panel, layout);
}

}  // namespace

Series series_of(const EnsembleCurve& curve, double factor) {
  Series series;
  bool gap = false;
  for (std::size_t k = 0; k < curve.x.size(); ++k) {
    const auto& value = curve.y[k];
    if (value.n == 0 || !std::isfinite(value.mean)) {
      gap = !series.x.empty();
      continue;
    }
    if (gap) {  // no line across it
      series.x.push_back(curve.x[k - 1]);
      series.y.push_back(std::numeric_limits<double>::quiet_NaN());
      series.sem.push_back(0);
      gap = false;
    }
    series.x.push_back(curve.x[k]);
    series.y.push_back(factor * value.mean);
    series.sem.push_back(factor * value.sem.value_or(0));
  }
  return series;
}

Series with_look(Series series, bool coarse) {
  series.title = coarse ? "coarse" : "smooth";
  series.colour = coarse ? colour::vermilion : colour::blue;
  series.point = coarse ? 1 : 6;
  return series;
}

Series with_look_of_place(Series series, std::size_t place) {
  struct Look {
    const char* colour;
    int point;
  };
  static constexpr std::array<Look, 5> looks{
      {{"#202020", 1}, {"#0072B2", 6}, {"#56B4E9", 8}, {"#E69F00", 4}, {"#D55E00", 10}}};
  const auto& look = looks[place % looks.size()];
  series.colour = look.colour;
  series.point = look.point;
  return series;
}

bool draw_panels(const PanelSheet& sheet, const std::string& stem) {
  std::vector<const Panel*> panels;
  for (const auto& panel : sheet.panels)
    if (!empty(panel)) panels.push_back(&panel);
  if (panels.empty()) return false;
  const auto key = key_of(panels);
  const Layout layout = layout_of(sheet, panels, key);
  const Range shared = y_range(sheet, panels);

  std::string blocks, plots;
  for (std::size_t p = 0; p < panels.size(); ++p) {
    std::string parts;
    if (sheet.level)
      parts = ", " + number_text(*sheet.level) +
              " with lines dashtype 2 linewidth 0.8 linecolor '" + colour::grey + "'";
    for (std::size_t s = 0; s < panels[p]->series.size(); ++s) {
      const auto& series = panels[p]->series[s];
      if (series.x.empty()) continue;
      const std::string name = "d" + std::to_string(p) + "_" + std::to_string(s);
      blocks += datablock(name, {series.x, series.y, series.sem});
      parts += ", " + plot_of(series, "$" + name, sheet.errors);
    }
    plots += edges_of(sheet, *panels[p]) +
             axes_of(sheet, *panels[p], layout, static_cast<int>(p),
                     static_cast<int>(panels.size()), shared) +
             "plot " + parts.substr(2) + "\nunset label\nunset object\nunset arrow\n";
  }
  const std::string tics = sheet.x_tics.empty() ? "" : "set xtics " + sheet.x_tics + "\n";
  draw_figure(stem, layout.width() / layout.height(),
              blocks + "set multiplot\n" + sheet_labels(sheet, layout) + key_plot(key, layout) +
                  "unset key\nunset label\n" + tics + plots + "unset multiplot\n",
              layout.width() * em);
  return true;
}

}  // namespace rodpack
