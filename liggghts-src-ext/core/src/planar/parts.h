// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_PARTS_H
#define RODPACK_PLANAR_PARTS_H

#include <algorithm>

#include "../planar_simd/range.h"

namespace rodpack {

/// Division of the bodies of a rank into parts of `size` bodies, in the order of their indices. A
/// step is made part by part, so that the bodies of a part are still in the processor's cache when
/// their contact forces are evaluated. The last part holds the ghost bodies, which have the indices
/// from `owned` on.
struct PlanarParts {
  int owned, size;

  int count() const { return (owned + size - 1) / size + 1; }
  int last() const { return count() - 1; }
  /// The bodies of a part other than the last one.
  PlanarRange bodies(int part) const { return {part * size, std::min(owned, (part + 1) * size)}; }
  int of(int body) const { return body < owned ? body / size : last(); }
  /// The part after whose motion both bodies of a pair have moved; j < 0 is a wall.
  int of_pair(int i, int j) const { return of(std::max(i, j)); }
};

}  // namespace rodpack

#endif
