// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_AVERAGING_OPTIONS_H
#define RODPACK_AVERAGING_OPTIONS_H

#include <memory>
#include <vector>
#include "lammps.h"
#include "rodpack/averaging/coarse_graining.h"

namespace LAMMPS_NS {

/// The settings of one `compute stress/goldhirsch`: kernel, places, and how to integrate.
struct AveragingOptions {
  std::unique_ptr<rodpack::AveragingKernel> kernel;
  rodpack::Grid grid;
  std::vector<rodpack::Vector> points;  // in place of the grid if there are any
  rodpack::CoarseGrainingOptions averaging;

  /// Returns averages with all sums at zero.
  rodpack::CoarseGraining start() const;
};

/// Reads the words from arg[first] on, those after the style's name; stops the run with one line
/// that names keyword, value and what was expected if they are wrong.
AveragingOptions read_averaging_options(LAMMPS* lmp, int narg, char** arg, int first);

}  // namespace LAMMPS_NS

#endif
