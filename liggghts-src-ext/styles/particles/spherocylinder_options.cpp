// SPDX-License-Identifier: GPL-2.0-or-later
#include "spherocylinder_options.h"

#include <cmath>
#include <stdexcept>

#include "atom.h"
#include "force.h"
#include "lammps.h"
#include "rodpack/geometry/pi.h"
#include "style_arguments.h"

namespace LAMMPS_NS {

namespace {

using Options = SpherocylinderOptions;

double read_overlap(StyleArguments& arguments) {
  const std::string surface = arguments.word("surface", "coarse, smooth or overlap F");
  if (surface == "coarse") return 0;
  if (surface == "smooth") return 0.5;
  if (surface != "overlap") arguments.reject("surface", "coarse, smooth or overlap F", surface);
  return arguments.number("surface overlap", "a fraction in [0, 0.9999]");
}

void read_mass(StyleArguments& arguments, Options& options) {
  const char* expected = "reference, own or given M IXX IYY IZZ";
  const std::string rule = arguments.word("mass", expected);
  if (rule == "reference") {
    options.mass_rule = Options::Mass::reference;
  } else if (rule == "own") {
    options.mass_rule = Options::Mass::own;
  } else if (rule == "given") {
    options.mass_rule = Options::Mass::given;
    options.given_mass.mass = arguments.number("mass given M", "a mass (kg) in (0, 1e15]");
    double sum = 0;
    const std::string words = arguments.peek() + " " + arguments.peek(1) + " " + arguments.peek(2);
    for (double& moment : options.given_mass.inertia) {
      moment =
          arguments.number("mass given IXX IYY IZZ", "a moment of inertia (kg m^2) in (0, 1e15]");
      sum += moment;
    }
    for (double moment : options.given_mass.inertia)
      if (moment > 0.5 * sum * (1 + 1e-12))
        arguments.reject("mass given IXX IYY IZZ",
                         "three moments of which none exceeds the sum of the other two", words);
  } else {
    arguments.reject("mass", expected, rule);
  }
}

void read_keyword(StyleArguments& arguments, const std::string& keyword, Options& options) {
  if (keyword == "atom_type") {
    options.atom_type = arguments.integer(keyword, an_atom_type);
  } else if (keyword == "type") {
    options.body_type = arguments.integer(keyword, "a body type in [1, 2147483647]");
  } else if (keyword == "aspect_ratio") {
    options.shape.aspect_ratio = arguments.number(keyword, "a number in [1, 10000]");
  } else if (keyword == "diameter") {
    options.shape.nominal_diameter = arguments.number(keyword, "a length (m) in [1e-12, 1e6]");
  } else if (keyword == "surface") {
    options.shape.overlap = read_overlap(arguments);
  } else if (keyword == "curvature") {
    options.shape.curvature_angle =
        rodpack::pi / 180. * arguments.number(keyword, "an angle (degrees) in [0, 180]");
  } else if (keyword == "size_spread") {
    options.size_spread = arguments.number(keyword, "a fraction in [0, 1)");
  } else if (keyword == "density") {
    if (arguments.peek() == "constant") arguments.word(keyword, "constant");
    options.density = arguments.number(keyword, "a density (kg/m^3) in [1e-9, 1e9]");
  } else if (keyword == "mass") {
    read_mass(arguments, options);
  } else if (keyword == "follow_drawn_size") {
    options.follow_drawn_size = arguments.yes_or_no(keyword);
  } else if (keyword == "planar") {
    options.planar = arguments.yes_or_no(keyword);
  } else {
    arguments.reject_keyword(
        keyword,
        "one of atom_type, type, aspect_ratio, diameter, surface, curvature, size_spread, density, "
        "mass, follow_drawn_size, planar");
  }
}

}  // namespace

Spherocylinder SpherocylinderOptions::particle(double diameter) const {
  Spherocylinder one;
  one.shape = shape;
  one.shape.diameter = diameter;
  // Given numbers say nothing about where the centre of mass lies: it is that of the reference.
  const auto rule = mass_rule == Mass::own ? rodpack::MassRule::own : rodpack::MassRule::reference;
  one.centres = rodpack::sphere_centres(one.shape, rule);
  one.mass = mass_rule == Mass::given
                 ? given_mass
                 : rodpack::mass_properties(one.shape, density, rule, follow_drawn_size);
  one.volume = rodpack::union_volume(one.shape);
  one.area = rodpack::covered_area(one.shape);
  one.bounding_radius = rodpack::bounding_radius(one.shape, rule);
  return one;
}

SpherocylinderOptions read_spherocylinder_options(LAMMPS* lmp, int narg, char** arg) {
  StyleArguments arguments(lmp, narg, arg);
  Options options;
  options.seed = arguments.integer("SEED", a_count);
  while (arguments.more()) {
    const std::string keyword = arguments.new_keyword();
    read_keyword(arguments, keyword, options);
  }
  arguments.require({"type", "aspect_ratio", "diameter", "surface"});
  const bool given = options.mass_rule == Options::Mass::given;
  if (!given) arguments.require({"density"});
  if (given && options.follow_drawn_size)
    arguments.fail("follow_drawn_size yes contradicts mass given, which fixes mass and inertia");
  if (options.atom_type > lmp->atom->ntypes)
    arguments.reject(
        "atom_type",
        "at most " + std::to_string(lmp->atom->ntypes) + ", the number of atom types in create_box",
        std::to_string(options.atom_type));
  if (lmp->force->cg(options.atom_type) != 1.) arguments.fail("does not work with coarsegraining");
  options.shape.diameter = options.shape.nominal_diameter;
  try {
    for (double draw : {0., 0.5, 1.}) {
      rodpack::ChainShape drawn = options.shape;
      drawn.diameter = options.diameter(draw);
      rodpack::validate(drawn);
    }
  } catch (const std::invalid_argument& problem) {
    arguments.fail(problem.what());
  }
  if (given && !arguments.given("density"))
    options.density = options.given_mass.mass / rodpack::union_volume(options.shape);
  return options;
}

}  // namespace LAMMPS_NS
