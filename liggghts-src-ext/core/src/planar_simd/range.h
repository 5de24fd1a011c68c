// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_RANGE_H
#define RODPACK_PLANAR_RANGE_H

namespace rodpack {

/// Indices from `first` up to, but without, `end`.
struct PlanarRange {
  int first, end;
};

}  // namespace rodpack

#endif
