// SPDX-License-Identifier: GPL-2.0-or-later
#include "line_options.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <string>

#include "domain.h"
#include "fix_template_sphere.h"
#include "lammps.h"
#include "modify.h"
#include "style_arguments.h"

namespace LAMMPS_NS {

namespace {

const std::set<std::string> keywords = {"template", "per_line", "x",      "y",
                                        "z",        "total",    "fall",   "interval",
                                        "velocity", "angle",    "gravity"};

std::string list_of_keywords() {
  std::string list;
  for (const std::string& known : keywords) list += (list.empty() ? "" : ", ") + known;
  return list;
}

void read_templates(LAMMPS* lmp, StyleArguments& arguments, LineOptions& options) {
  do {
    const std::string name =
        arguments.word("template", "the id of a fix particletemplate and its fraction");
    const int index = lmp->modify->find_fix(name.c_str());
    auto* particles = index < 0 ? NULL : dynamic_cast<FixTemplateSphere*>(lmp->modify->fix[index]);
    if (!particles) arguments.reject("template", "the id of a fix particletemplate", name);
    for (const LineOptions::Part& other : options.parts)
      if (other.particles == particles) arguments.fail("template " + name + " is given twice");
    options.parts.push_back(
        {particles, arguments.number("template " + name, "a fraction in (0, 1e15]")});
  } while (arguments.more() && !keywords.count(arguments.peek()));
}

void read_keyword(LAMMPS* lmp, StyleArguments& arguments, const std::string& keyword,
                  LineOptions& options) {
  if (keyword == "template") {
    read_templates(lmp, arguments, options);
  } else if (keyword == "per_line") {
    options.per_line = arguments.integer(keyword, a_count);
  } else if (keyword == "total") {
    options.total = arguments.integer(keyword, a_count);
  } else if (keyword == "x") {
    arguments.pair(keyword, a_position, options.x_low, options.x_high, true);
  } else if (keyword == "y") {
    options.y = arguments.number(keyword, a_position);
  } else if (keyword == "z") {
    options.z = arguments.number(keyword, a_position);
  } else if (keyword == "fall") {
    options.fall = arguments.number(keyword, a_length);
  } else if (keyword == "interval") {
    options.interval = arguments.number(keyword, "a time (s) in (0, 1e15]");
  } else if (keyword == "gravity") {
    options.gravity = arguments.number(keyword, "an acceleration (m/s^2) in (0, 1e15]");
  } else if (keyword == "velocity") {
    arguments.pair(keyword, "a velocity (m/s) in [-1e15, 1e15]", options.velocity_low,
                   options.velocity_high);
  } else if (keyword == "angle") {
    arguments.pair(keyword, "an angle (degrees) in [-1e15, 1e15]", options.angle_low,
                   options.angle_high);
    options.angle_low *= rodpack::pi / 180.;
    options.angle_high *= rodpack::pi / 180.;
  } else {
    arguments.reject_keyword(keyword, "one of " + list_of_keywords());
  }
}

void check_room(const Domain& domain, const StyleArguments& arguments, const LineOptions& options) {
  char text[256];
  const double cell = (options.x_high - options.x_low) / options.per_line;
  for (const LineOptions::Part& part : options.parts) {
    const double width = 2. * part.particles->max_r_bound();
    if (width <= cell * (1. + 1e-9)) continue;
    std::snprintf(
        text, sizeof text,
        "particles of template %s are %g m wide at some angle and do not fit: per_line %d "
        "from x = %g to %g leaves each a cell of %g m",
        part.particles->id, width, options.per_line, options.x_low, options.x_high, cell);
    arguments.fail(text);
  }
  const double low[3] = {options.x_low, options.y, options.z};
  const double high[3] = {options.x_high, options.y, options.z};
  for (int d = 0; d < 3; ++d) {
    const int shrink_wrapped = 2;  // Domain::boundary from this value on
    const bool below = domain.boundary[d][0] < shrink_wrapped && low[d] < domain.boxlo[d];
    const bool above = domain.boundary[d][1] < shrink_wrapped && high[d] > domain.boxhi[d];
    if (!below && !above) continue;
    std::snprintf(text, sizeof text, "%c is '%.15g', expected a position in the box, %g to %g m",
                  "xyz"[d], below ? low[d] : high[d], domain.boxlo[d], domain.boxhi[d]);
    arguments.fail(text);
  }
  // LIGGGHTS deletes a body, without a word, when one of its spheres is outside a fixed boundary.
  for (const LineOptions::Part& part : options.parts) {
    const double reach = part.particles->max_r_bound() - part.particles->min_rad();
    const int fixed = 1;  // Domain::boundary
    const bool below = domain.boundary[1][0] == fixed && options.y - reach < domain.boxlo[1];
    const bool above = domain.boundary[1][1] == fixed && options.y + reach > domain.boxhi[1];
    if (!below && !above) continue;
    std::snprintf(text, sizeof text,
                  "y is '%.15g', expected room for particles of template %s, whose spheres reach "
                  "%g m from their centre, in the box, %g to %g m",
                  options.y, part.particles->id, reach, domain.boxlo[1], domain.boxhi[1]);
    arguments.fail(text);
  }
}

}  // namespace

std::vector<int> LineOptions::numbers() const {
  double sum = 0;
  for (const Part& part : parts) sum += part.fraction;
  std::vector<int> numbers;
  std::vector<std::pair<double, std::size_t>> remainders;  // negative: largest first when sorted
  int missing = total;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const double exact = total * parts[i].fraction / sum;
    numbers.push_back(static_cast<int>(exact));
    missing -= numbers.back();
    remainders.push_back({numbers.back() - exact, i});
  }
  std::sort(remainders.begin(), remainders.end());
  for (int i = 0; i < missing; ++i) ++numbers[remainders[i].second];
  return numbers;
}

LineOptions read_line_options(LAMMPS* lmp, int narg, char** arg) {
  StyleArguments arguments(lmp, narg, arg);
  LineOptions options;
  options.seed = arguments.integer("SEED", a_count);
  while (arguments.more()) {
    const std::string keyword = arguments.new_keyword();
    read_keyword(lmp, arguments, keyword, options);
  }
  arguments.require({"template", "per_line", "x", "y", "total"});
  if (arguments.given("fall") == arguments.given("interval"))
    arguments.fail("expected either fall H or interval T");
  if (lmp->domain->dimension != 3)
    arguments.reject("dimension", "3", std::to_string(lmp->domain->dimension));
  if (lmp->domain->triclinic) arguments.fail("does not work with a triclinic box");
  check_room(*lmp->domain, arguments, options);
  return options;
}

}  // namespace LAMMPS_NS
