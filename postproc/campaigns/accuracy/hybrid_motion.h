// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CAMPAIGNS_ACCURACY_HYBRID_MOTION_H
#define RODPACK_CAMPAIGNS_ACCURACY_HYBRID_MOTION_H

#include <cstddef>
#include <vector>

namespace rodpack {

// How the references are integrated; for the sources of this room only.

/// A motion y' = rate(y) that is smooth between events, such as the touch of two spheres.
class HybridSystem {
 public:
  using State = std::vector<double>;

  virtual ~HybridSystem() = default;
  /// y' into `dy`, which has the size of `y`, in the present mode.
  virtual void rate(const State& y, State& dy) const = 0;
  /// Values into `g`, never negative in the present mode: an event is where one falls below 0.
  virtual void guards(const State& y, std::vector<double>& g) const = 0;
  /// Takes the event of one guard: changes the mode, and `y` where it jumps.
  virtual void pass(std::size_t guard, State& y) = 0;
};

enum class Scheme {
  runge_kutta_4,    // the classical one
  dormand_prince_5  // the fifth-order weights of Dormand and Prince (1980), fixed steps
};

/// Advances `y` by `time` in steps of at most `step`; events are found to rounding, and the steps
/// end there. @throws std::runtime_error when events pile up at one moment.
void integrate(HybridSystem& system, HybridSystem::State& y, double time, double step,
               Scheme scheme);

}  // namespace rodpack

#endif
