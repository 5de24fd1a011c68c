// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_TESTS_COLLISION_REFERENCE_H
#define RODPACK_TESTS_COLLISION_REFERENCE_H

#include <algorithm>
#include <array>
#include <cmath>

namespace rodpack::test {

// Two equal spheres of inputs/verification/collision, integrated on their own: Runge-Kutta of
// fourth order with steps of at most 30 ns and 1/100000 of a contact, started exactly at first
// touch. It shares no code with the program. SI units.
struct CollisionReference {
  double kn = 1000, kt = 500, eta_n = 0.2, eta_t = 0.2, mu = 0.3;
  double speed = 0.5, offset = 0, spin = 0, gap = 1e-4;

  static constexpr double radius = 1.5e-3;
  static double mass() { return 2500 * 4.0 / 3.0 * M_PI * radius * radius * radius; }

  // x, y: of sphere 1 relative to sphere 2; omega: sum of both spins; s: tangential spring
  enum { X, Y, U, V, OMEGA, S, SIZE };
  using State = std::array<double, SIZE>;

  /// Time of first touch after the start of the deck.
  double touch_time() const {
    const double y = offset;
    const double x = std::sqrt(4 * radius * radius - y * y);
    return (2 * radius + gap - x) / (2 * speed);
  }

  State at_touch() const {
    const double y = -offset;
    return {-std::sqrt(4 * radius * radius - y * y), y, 2 * speed, 0, spin, 0};
  }

  double overlap(const State& a) const { return 2 * radius - std::hypot(a[X], a[Y]); }

  /// State at `time` of the deck, or at the end of the contact if that comes first.
  State at(double time) const {
    State a = at_touch();
    const double meff = mass() / 2;
    const double h = std::min(3e-8, M_PI * std::sqrt(meff / kn) / 1e5);
    double left = time - touch_time();
    while (left > 0) {
      a = step(a, std::min(h, left));
      left -= h;
      if (overlap(a) < 0) break;
    }
    return a;
  }

 private:
  struct Forces {
    double nx, ny, fn, trial, cap, vt;
  };

  Forces forces(const State& a) const {
    const double meff = mass() / 2;
    const double r = std::hypot(a[X], a[Y]);
    const double nx = a[X] / r, ny = a[Y] / r;
    const double delta = 2 * radius - r;
    const double vn = a[U] * nx + a[V] * ny;
    // Tangent (-ny, nx); each surface moves with its spin at the lever arm r/2.
    const double vt = -a[U] * ny + a[V] * nx - 0.5 * r * a[OMEGA];
    return {nx,
            ny,
            std::max(0.0, kn * delta - 2 * eta_n * std::sqrt(meff * kn) * vn),
            -kt * a[S] - 2 * eta_t * std::sqrt(meff * kt) * vt,
            mu * kn * std::max(0.0, delta),
            vt};
  }

  State rate(const State& a) const {
    const Forces f = forces(a);
    const double ft = std::clamp(f.trial, -f.cap, f.cap);
    const double meff = mass() / 2;
    const double inertia = 0.4 * mass() * radius * radius;
    const double arm = 0.5 * std::hypot(a[X], a[Y]);
    return {a[U],
            a[V],
            (f.fn * f.nx - ft * f.ny) / meff,
            (f.fn * f.ny + ft * f.nx) / meff,
            -2 * arm * ft / inertia,
            f.vt};
  }

  State step(const State& a, double h) const {
    const auto plus = [](const State& b, double factor, const State& c) {
      State sum = b;
      for (int k = 0; k < SIZE; ++k) sum[k] += factor * c[k];
      return sum;
    };
    const State k1 = rate(a);
    const State k2 = rate(plus(a, h / 2, k1));
    const State k3 = rate(plus(a, h / 2, k2));
    const State k4 = rate(plus(a, h, k3));
    State next = a;
    for (int k = 0; k < SIZE; ++k) next[k] += h / 6 * (k1[k] + 2 * k2[k] + 2 * k3[k] + k4[k]);
    const Forces f = forces(next);
    if (std::fabs(f.trial) > f.cap) next[S] = -std::copysign(f.cap, f.trial) / kt;
    return next;
  }
};

}  // namespace rodpack::test

#endif
