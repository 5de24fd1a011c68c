// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging_options.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include "atom.h"
#include "domain.h"
#include "style_arguments.h"

namespace LAMMPS_NS {

namespace {

// The settings as they are read, before one is held against another.
struct Words {
  double scale = 0.0;
  double spacing = 0.0;
  double cutoff = 0.0;
  double tolerance = 1e-6;
  int dimension = 2;
  std::string kernel = "gaussian", line = "auto";
  std::vector<double> box;  // lo, hi of each axis
  std::vector<rodpack::Vector> points;
  bool couple = false;
};

rodpack::Vector read_point(StyleArguments& arguments, int dimension) {
  rodpack::Vector point{{0.0, 0.0, 0.0}};
  for (int d = 0; d < dimension; ++d) point[d] = arguments.number("point", a_position);
  return point;
}

void read_points(const StyleArguments& arguments, const std::string& name, Words& words) {
  std::ifstream file(name);
  if (!file) arguments.reject("points", "a file that can be read", name);
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    std::istringstream row(line.substr(0, line.find('#')));
    std::vector<double> values;
    bool numbers = true;
    for (std::string text; row >> text;) {
      values.push_back(0.0);
      numbers = read_number(text, values.back()) && numbers;
    }
    if (values.empty()) continue;
    if (!numbers || static_cast<int>(values.size()) != words.dimension)
      arguments.fail("points: " + name + ":" + std::to_string(number) + ": expected " +
                     std::to_string(words.dimension) + " coordinates (m), found '" + line + "'");
    rodpack::Vector point{{0.0, 0.0, 0.0}};
    std::copy(values.begin(), values.end(), point.begin());
    words.points.push_back(point);
  }
  if (words.points.empty()) arguments.fail("points: " + name + " holds no place");
}

void read_keyword(StyleArguments& arguments, const std::string& keyword, Words& words) {
  if (keyword == "scale") {
    words.scale = arguments.number(keyword, a_length);
    if (arguments.peek() != "times") return;
    arguments.word(keyword, "times");
    words.scale *= arguments.number("scale ... times", a_length);
  } else if (keyword == "dimension") {
    words.dimension = arguments.choice(keyword, {"2", "3"}) + 2;
    if (!words.box.empty() || !words.points.empty())
      arguments.fail("dimension has to come before box and point");
  } else if (keyword == "kernel") {
    words.kernel = arguments.word(keyword, "gaussian, lucy or heaviside");
  } else if (keyword == "line") {
    words.line = arguments.word(keyword, "auto, exact, 1, 2, 3 or 4");
  } else if (keyword == "tolerance") {
    words.tolerance = arguments.number(keyword, "a number in (0, 1)");
  } else if (keyword == "cutoff") {
    words.cutoff = arguments.number(keyword, "a number of scales in (0, 1e15]");
  } else if (keyword == "spacing") {
    words.spacing = arguments.number(keyword, a_length);
  } else if (keyword == "box") {
    for (int k = 0; k < 2 * words.dimension; ++k)
      words.box.push_back(arguments.number(keyword, a_position));
  } else if (keyword == "point") {
    words.points.push_back(read_point(arguments, words.dimension));
  } else if (keyword == "points") {
    read_points(arguments, arguments.word(keyword, "a file"), words);
  } else if (keyword == "couple") {
    words.couple = arguments.yes_or_no(keyword);
  } else {
    arguments.reject_keyword(keyword,
                             "scale, dimension, kernel, line, tolerance, cutoff, spacing, box, "
                             "point, points or couple");
  }
}

rodpack::Grid grid_of(const StyleArguments& arguments, const Words& words, const Domain& domain) {
  rodpack::Vector low{{0.0, 0.0, 0.0}}, high{{0.0, 0.0, 0.0}};
  for (int d = 0; d < words.dimension; ++d) {
    low[d] = words.box.empty() ? domain.boxlo[d] : words.box[2 * d];
    high[d] = words.box.empty() ? domain.boxhi[d] : words.box[2 * d + 1];
    if (low[d] > domain.boxhi[d] || high[d] < domain.boxlo[d])
      arguments.fail(std::string("box: ") + "xyz"[d] + " from " + std::to_string(low[d]) + " to " +
                     std::to_string(high[d]) + " m is outside the simulation box, " +
                     std::to_string(domain.boxlo[d]) + " to " + std::to_string(domain.boxhi[d]));
  }
  return rodpack::filling_grid(words.dimension, low, high,
                               words.spacing > 0.0 ? words.spacing : 0.25 * words.scale);
}

}  // namespace

rodpack::CoarseGraining AveragingOptions::start() const {
  if (points.empty()) return rodpack::CoarseGraining(*kernel, grid, averaging);
  return rodpack::CoarseGraining(*kernel, points, averaging);
}

AveragingOptions read_averaging_options(LAMMPS* lmp, int narg, char** arg, int first) {
  StyleArguments arguments(lmp, narg, arg, first, "Compute");
  const Domain& domain = *lmp->domain;
  arguments.require_group_all("averages all particles");
  if (!lmp->atom->sphere_flag) arguments.fail("requires atom style sphere");
  Words words;
  while (arguments.more()) {
    const std::string keyword = arguments.new_keyword("point");
    read_keyword(arguments, keyword, words);
  }
  arguments.require({"scale"});
  if (!words.points.empty() && (!words.box.empty() || words.spacing > 0.0))
    arguments.fail("point and points exclude box and spacing");
  if (!domain.box_exist) arguments.fail("needs a simulation box: put it after create_box");
  if (domain.triclinic) arguments.fail("does not support a triclinic box");

  AveragingOptions options;
  try {
    const auto shape = rodpack::kernel_shape(words.kernel);
    const double cutoff = words.cutoff > 0.0
                              ? words.cutoff
                              : rodpack::gaussian_cutoff(words.tolerance, words.dimension);
    options.kernel.reset(new rodpack::AveragingKernel(shape, words.dimension, words.scale, cutoff));
    options.averaging.line = rodpack::LineRule::named(words.line, words.tolerance);
    options.averaging.couple_stress = words.couple;
    for (int d = 0; d < words.dimension; ++d)
      if (domain.periodicity[d]) options.averaging.period[d] = domain.prd[d];
    options.points = words.points;
    if (options.points.empty()) options.grid = grid_of(arguments, words, domain);
  } catch (const std::invalid_argument& wrong) {
    arguments.fail(wrong.what());
  }
  return options;
}

}  // namespace LAMMPS_NS
