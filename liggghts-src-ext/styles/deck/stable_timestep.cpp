// SPDX-License-Identifier: GPL-2.0-or-later
#include "stable_timestep.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "comm.h"
#include "input.h"
#include "rodpack/contact/contact_law.h"
#include "rodpack/contact/power_law.h"
#include "rodpack/geometry/mass_properties.h"
#include "rodpack/contact/dashpot_relaxation.h"
#include "rodpack/motion/mass_scaling.h"
#include "stop_run.h"
#include "style_arguments.h"
#include "variable.h"

using namespace LAMMPS_NS;

namespace {

const char* const a_variable = "letters, digits and _";

/// The largest number of three digits that is not above the step.
std::string rounded_down(double step) {
  const double digit = std::pow(10.0, std::floor(std::log10(step)) - 2.0);
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", std::floor(step / digit) * digit);
  return text;
}

std::string text_of(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string variable_name(StyleArguments& arguments) {
  const std::string name = arguments.word("NAME", a_variable);
  if (!std::all_of(name.begin(), name.end(),
                   [](unsigned char c) { return std::isalnum(c) || c == '_'; }))
    arguments.reject("NAME", a_variable, name);
  return name;
}

}  // namespace

void StableTimestep::report(const std::string& line) const {
  if (comm->me != 0) return;
  for (FILE* out : {screen, logfile})
    if (out) std::fputs(line.c_str(), out);
}

void StableTimestep::command(int narg, char** arg) {
  StyleArguments arguments(lmp, "stable_timestep", narg, arg, 0);
  const std::string name = variable_name(arguments);
  rodpack::PackingLaw law = {};
  rodpack::ChainShape shape = {};
  double scaling = 0.0, density = 0.0, fraction = 0.9, fewest = 12.0, relaxation = 0.0;
  int order = 0;
  while (arguments.more()) {
    const std::string keyword = arguments.new_keyword();
    const auto number = [&](const char* expected) { return arguments.number(keyword, expected); };
    if (keyword == "order")
      order = arguments.integer(keyword, "a whole number in [0, 4], 0 for leapfrog");
    else if (keyword == "mass_scaling")
      scaling = number("a ratio of frequencies in [1, 1000]");
    else if (keyword == "stiffness")
      law.stiffness = number("a stiffness (N/m) in (0, 1e15]");
    else if (keyword == "damping_ratio")
      law.damping_ratio = number("a ratio in [0, 1)");
    else if (keyword == "relaxation_steps")
      relaxation = number("a number of steps in [0, 1000], 0 for none");
    else if (keyword == "aspect_ratio")
      shape.aspect_ratio = number("a ratio in [1, 1000]");
    else if (keyword == "diameter")
      shape.diameter = shape.nominal_diameter = number(a_length);
    else if (keyword == "density")
      density = number("a density (kg/m^3) in (0, 1e15]");
    else if (keyword == "fraction")
      fraction = number("a fraction in (0, 1]");
    else if (keyword == "steps_per_collision")
      fewest = number("a number of steps in [2, 1e9]");
    else
      arguments.reject_keyword(keyword,
                               "order, mass_scaling, stiffness, damping_ratio, relaxation_steps, "
                               "aspect_ratio, diameter, density, fraction or "
                               "steps_per_collision");
  }
  arguments.require({"order", "mass_scaling", "stiffness", "damping_ratio", "aspect_ratio",
                     "diameter", "density"});
  if (relaxation > 0.0 && order > 0)
    arguments.fail("relaxation_steps is '" + text_of(relaxation) + "' with order " +
                   std::to_string(order) + ", expected 0, or order 0");
  law.dashpot_share = rodpack::share_in_fastest_motion(relaxation, 1.0);
  double limit = 0.0;
  try {
    law.lightest_mass =
        rodpack::mass_properties(shape, density, rodpack::MassRule::reference, false).mass;
    limit = rodpack::mass_scaled_timestep_limit(order, scaling, law);
  } catch (const std::invalid_argument& reason) {
    arguments.fail(reason.what());
  }
  if (!(limit > 0.0))
    arguments.fail("no step of order " + std::to_string(order) +
                   " is stable without damping, expected damping_ratio > 0, or order 3 or 4");
  const double effective = 0.5 * law.lightest_mass;
  const double damping = rodpack::damping_coefficient(law.damping_ratio, effective, law.stiffness);
  const double collision = rodpack::half_period(law.stiffness, damping, effective);
  const std::string value = rounded_down(std::min(fraction * limit, collision / fewest));
  report("stable_timestep: " + value + " s, " + text_of(std::stod(value) / limit) +
         " of the limit " + text_of(limit) + " s of order " + std::to_string(order) +
         " under mass scaling " + text_of(scaling) + "; " + text_of(collision / std::stod(value)) +
         " steps per collision\n");
  std::string words[] = {name, "string", value};
  char* set[] = {&words[0][0], &words[1][0], &words[2][0]};
  input->variable->set(3, set);
}
