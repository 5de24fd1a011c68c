// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_RANKS_H
#define RODPACK_PLANAR_RANKS_H

#include <vector>

namespace rodpack {

/// What goes to another rank in every step, and what comes from it.
struct PlanarLink {
  int rank;
  std::vector<double> out, in;  // in: as large as the largest message that may come; 0: none does
  int out_count;                // values of `out` to send; 0: no message
};

/// Messages between the ranks that share a packing, each with a scene of its own. All functions but
/// rank() and count() are collective: every rank calls them in the same order.
class PlanarRanks {
 public:
  virtual ~PlanarRanks() = default;

  virtual int rank() const = 0;
  virtual int count() const = 0;

  /// The values of all ranks, one rank after the other; each gives as many.
  virtual std::vector<double> gather(const std::vector<double>& own) = 0;
  /// Puts the largest over the ranks in the place of each value.
  virtual void largest(double* values, int count) = 0;
  /// Sends to[r] to rank r; from[r] becomes what came from it. This is for what happens seldom.
  virtual void exchange(const std::vector<std::vector<double>>& to,
                        std::vector<std::vector<double>>& from) = 0;
  /// Sends and receives what the links say, between ranks that both know of their link; in every
  /// step.
  virtual void swap(std::vector<PlanarLink>& links) = 0;
};

}  // namespace rodpack

#endif
