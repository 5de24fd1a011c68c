// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_LINE_OPTIONS_H
#define RODPACK_LINE_OPTIONS_H

#include <vector>

#include "rodpack/geometry/pi.h"

namespace LAMMPS_NS {

class FixTemplateSphere;
class LAMMPS;

/// The parameters of one fix insert/line; SI units, angles in rad.
struct LineOptions {
  struct Part {
    FixTemplateSphere* particles;
    double fraction;  // of the total number, not normalised
  };

  int seed = 0;
  std::vector<Part> parts;
  int per_line = 0, total = 0;
  double x_low = 0, x_high = 0, y = 0, z = 0;
  double fall = 0, interval = 0, gravity = 0;  // 0 where not given
  double velocity_low = 0, velocity_high = 0;
  double angle_low = 0, angle_high = 2 * rodpack::pi;

  /// Numbers of particles of the parts, by largest remainders, so that they add up to the total.
  std::vector<int> numbers() const;
};

/// Reads and checks the arguments of the fix, also that the line lies in the box and its particles
/// fit their cells; ends the run with a message if they are wrong.
LineOptions read_line_options(LAMMPS* lmp, int narg, char** arg);

}  // namespace LAMMPS_NS

#endif
