// SPDX-License-Identifier: GPL-2.0-or-later
#include "campaigns/accuracy/hybrid_motion.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace rodpack {
namespace {

using State = HybridSystem::State;

// A Butcher tableau: stage k starts from y + h sum_j a[k][j] slope_j.
struct Tableau {
  std::vector<std::vector<double>> a;
  std::vector<double> weights;
};

const Tableau& tableau(Scheme scheme) {
  static const Tableau classical = {{{}, {1. / 2}, {0, 1. / 2}, {0, 0, 1}},
                                    {1. / 6, 1. / 3, 1. / 3, 1. / 6}};
  static const Tableau dormand_prince = {
      {{},
       {1. / 5},
       {3. / 40, 9. / 40},
       {44. / 45, -56. / 15, 32. / 9},
       {19372. / 6561, -25360. / 2187, 64448. / 6561, -212. / 729},
       {9017. / 3168, -355. / 33, 46732. / 5247, 49. / 176, -5103. / 18656}},
      {35. / 384, 0, 500. / 1113, 125. / 192, -2187. / 6784, 11. / 84}};
  return scheme == Scheme::runge_kutta_4 ? classical : dormand_prince;
}

class Stepper {
 public:
  Stepper(const HybridSystem& system, Scheme scheme, std::size_t size)
      : system_(system),
        tableau_(tableau(scheme)),
        slopes_(tableau_.weights.size(), State(size)),
        stage_(size) {}

  /// State `h` after `from`, in the system's present mode.
  void step(const State& from, double h, State& to) {
    for (std::size_t k = 0; k < slopes_.size(); ++k) {
      add(from, h, tableau_.a[k], stage_);
      system_.rate(stage_, slopes_[k]);
    }
    add(from, h, tableau_.weights, to);
  }

  /// Guards that are negative at `y`, in order.
  const std::vector<std::size_t>& negative(const State& y) {
    system_.guards(y, guards_);
    negative_.clear();
    for (std::size_t k = 0; k < guards_.size(); ++k)
      if (guards_[k] < 0) negative_.push_back(k);
    return negative_;
  }

 private:
  void add(const State& from, double h, const std::vector<double>& factors, State& sum) const {
    sum = from;
    for (std::size_t j = 0; j < factors.size(); ++j)
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += h * factors[j] * slopes_[j][i];
  }

  const HybridSystem& system_;
  const Tableau& tableau_;
  std::vector<State> slopes_;
  State stage_;
  std::vector<double> guards_;
  std::vector<std::size_t> negative_;
};

}  // namespace

void integrate(HybridSystem& system, State& y, double time, double step, Scheme scheme) {
  constexpr int most_events_at_once = 1000;  // without a step of 1e-12 of the usual length between
  Stepper stepper(system, scheme, y.size());
  State next(y.size());
  const auto pass_all = [&] {
    int events = 0;
    for (auto crossed = stepper.negative(y); !crossed.empty(); crossed = stepper.negative(y)) {
      if (++events > most_events_at_once) throw std::runtime_error("events do not come to an end");
      system.pass(crossed.front(), y);
    }
  };
  pass_all();
  double done = 0;
  int crowded = 0;
  while (done < time) {
    const double h = std::min(step, time - done);
    stepper.step(y, h, next);
    if (stepper.negative(next).empty()) {
      std::swap(y, next);
      done += h;
      continue;
    }
    double before = 0, after = h;
    for (int bisection = 0; bisection < 60; ++bisection) {
      const double middle = 0.5 * (before + after);
      stepper.step(y, middle, next);
      (stepper.negative(next).empty() ? before : after) = middle;
    }
    crowded = after < 1e-12 * step ? crowded + 1 : 0;
    if (crowded > most_events_at_once) throw std::runtime_error("events pile up at one moment");
    stepper.step(y, after, next);
    std::swap(y, next);
    done += after;
    pass_all();
  }
}

}  // namespace rodpack
