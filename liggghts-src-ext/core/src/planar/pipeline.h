// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_PIPELINE_H
#define RODPACK_PLANAR_PIPELINE_H

#include <vector>

#include "parts.h"

namespace rodpack {

constexpr int most_steps_in_pass = 8;

/// Which part of the bodies waits for which: the contact forces on the bodies of a part are
/// complete once the blocks of a certain part, its own or a later one, have been evaluated.
class PlanarDependencies {
 public:
  explicit PlanarDependencies(const PlanarParts& parts);

  /// Every part waits for itself alone.
  void clear();
  /// A contact between bodies i and j (negative: a wall) is evaluated with part `part`.
  void add_contact(int i, int j, int part);
  /// The part of this body waits for all others.
  void hold_back(int body) { completed_by_[parts_.of(body)] = parts_.last(); }
  /// The last part that has forces on the bodies of part `part`.
  int completed_by(int part) const { return completed_by_[part]; }

 private:
  PlanarParts parts_;
  std::vector<int> completed_by_;  // of each part
};

/// What a pipeline makes of a part in a step. Step 0 is the first of the pass.
class PlanarPartStep {
 public:
  virtual ~PlanarPartStep() = default;
  /// Moves the bodies of the part to the end of the step; returns whether some of them have to be
  /// listed anew, with new neighbours that the steps before this one must not meet.
  virtual bool move(int step, int part) = 0;
  /// Evaluates the forces of the contacts that the part completes.
  virtual void evaluate(int step, int part) = 0;
};

/// Makes several steps in one pass over the bodies (temporal blocking): a part goes on to the next
/// step as soon as the forces on all of its bodies are complete, while they are still in the cache.
/// Each step takes the parts in their order, so that the result is, but for the order of new
/// blocks, that of one step after the other.
class PlanarPipeline {
 public:
  PlanarPipeline(const PlanarParts& parts, const PlanarDependencies& dependencies)
      : parts_(parts), dependencies_(dependencies) {}

  /// Makes 1 .. most_steps_in_pass steps of all parts.
  void run(int steps, PlanarPartStep& part_step);

 private:
  void make_next_part(int step, PlanarPartStep& part_step);

  PlanarParts parts_;
  const PlanarDependencies& dependencies_;
  int made_[most_steps_in_pass];  // parts that each step of the pass has made
};

}  // namespace rodpack

#endif
