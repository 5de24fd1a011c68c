// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_SPHEROCYLINDER_OPTIONS_H
#define RODPACK_SPHEROCYLINDER_OPTIONS_H

#include <string>
#include <vector>

#include "rodpack/geometry/mass_properties.h"

namespace LAMMPS_NS {

class LAMMPS;

/// One chain with everything that follows from its drawn diameter; SI units.
struct Spherocylinder {
  rodpack::ChainShape shape;
  std::vector<std::array<double, 2>> centres;  // body frame, about the centre of mass, m
  rodpack::MassProperties mass;
  double volume;           // of the union of the spheres, m^3
  double area;             // covered area, m^2
  double bounding_radius;  // about the centre of mass, m
};

/// The parameters of one fix particletemplate/multisphere/spherocylinder.
struct SpherocylinderOptions {
  enum class Mass { reference, own, given };

  int seed = 0;
  int atom_type = 1;
  int body_type = 0;
  rodpack::ChainShape shape = {};  // of nominal diameter
  double size_spread = 0;          // S: diameters are drawn from nominal (1 - S) to nominal (1 + S)
  double density = 0;              // kg/m^3
  Mass mass_rule = Mass::reference;
  rodpack::MassProperties given_mass = {};
  bool follow_drawn_size = false;
  bool planar = false;

  /// Diameter for a draw from [0, 1).
  double diameter(double draw) const {
    return shape.nominal_diameter * (1. + size_spread * (2. * draw - 1.));
  }
  Spherocylinder particle(double diameter) const;
};

/// Reads and checks the arguments of the fix; ends the run with a message if they are wrong.
SpherocylinderOptions read_spherocylinder_options(LAMMPS* lmp, int narg, char** arg);

}  // namespace LAMMPS_NS

#endif
