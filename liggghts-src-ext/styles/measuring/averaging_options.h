// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_AVERAGING_OPTIONS_H
#define RODPACK_AVERAGING_OPTIONS_H

#include <memory>
#include <vector>
#include "lammps.h"
#include "rodpack/averaging/coarse_graining.h"

namespace LAMMPS_NS {

/// What `compute stress/goldhirsch` is told: kernel, places, and how to integrate.
struct AveragingOptions {
  std::unique_ptr<rodpack::AveragingKernel> kernel;
  rodpack::Grid grid;
  std::vector<rodpack::Vector> points;  // in place of the grid if there are any
  rodpack::CoarseGrainingOptions averaging;

  /// A fresh set of sums at the places.
  rodpack::CoarseGraining start() const;
};

/// Reads the words after the style's name. Stops with one line that names keyword, value and what
/// was expected.
AveragingOptions read_averaging_options(LAMMPS* lmp, int narg, char** arg, int first);

}  // namespace LAMMPS_NS

#endif
