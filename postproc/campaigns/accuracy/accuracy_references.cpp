// SPDX-License-Identifier: GPL-2.0-or-later
#include "campaigns/accuracy/accuracy_references.h"

#include <cmath>
#include <stdexcept>

namespace rodpack {
namespace {

/// A contact with its mode. delta: overlap; vn: normal velocity, > 0 separating; vt: tangential
/// velocity of the surface; s: its integral.
class ReferenceContact {
 public:
  ReferenceContact(const ReferenceLaw& law, double effective_mass)
      : kn_(law.kn),
        kt_(law.kt),
        cn_(2 * law.eta_n * std::sqrt(effective_mass * law.kn)),
        ct_(2 * law.eta_t * std::sqrt(effective_mass * law.kt)),
        mu_(law.mu) {}

  static constexpr std::size_t guards = 3;
  bool touching() const { return touching_; }

  double normal(double delta, double vn) const {
    return touching_ && !cut_ ? kn_ * delta - cn_ * vn : 0;
  }
  double tangential(double delta, double vt, double s) const {
    if (!touching_) return 0;
    return slides_ == 0 ? -(kt_ * s + ct_ * vt) : -slides_ * mu_ * kn_ * delta;
  }
  double spring_rate(double vt) const { return touching_ && slides_ == 0 ? vt : 0; }

  void guard(double delta, double vn, double vt, double s, double* g) const {
    g[0] = touching_ ? delta : -delta;
    g[1] = g[2] = 0;
    if (!touching_) return;
    const double viscoelastic = kn_ * delta - cn_ * vn;
    g[1] = cut_ ? -viscoelastic : viscoelastic;
    g[2] = slides_ != 0 ? goes_on_sliding(slides_, vn, vt)
                        : mu_ * kn_ * delta - std::fabs(kt_ * s + ct_ * vt);
  }

  void pass(std::size_t guard, double delta, double vn, double vt, double& s) {
    const double cap = mu_ * kn_ * delta;
    if (guard == 0) {
      touching_ = !touching_;
      cut_ = false;
      s = 0;
      slides_ = 0;
      if (touching_ && vt != 0) start_sliding(vt > 0 ? 1 : -1, vn, vt);
    } else if (guard == 1) {
      cut_ = !cut_;
    } else if (slides_ != 0) {
      s = slides_ * cap * inside / kt_;
      slides_ = 0;
    } else {
      const int sign = kt_ * s + ct_ * vt > 0 ? 1 : -1;
      // The spring is shortened, as the law says, even where the dashpot then lets the contact
      // stick.
      s = sign * cap * inside / kt_;
      start_sliding(sign, vn, vt);
    }
  }

 private:
  // A sliding spring carries the cap alone. With a dashpot it slides as long as the dashpot pulls
  // the same way; without, as long as the spring would grow faster than the cap.
  double goes_on_sliding(int sign, double vn, double vt) const {
    return ct_ > 0 ? sign * vt : kt_ * sign * vt + mu_ * kn_ * vn;
  }
  void start_sliding(int sign, double vn, double vt) {
    if (goes_on_sliding(sign, vn, vt) > 0) slides_ = sign;
  }

  static constexpr double inside = 1 - 1e-15;  // so that rounding is no event

  double kn_, kt_, cn_, ct_, mu_;
  bool touching_ = false;
  bool cut_ = false;  // the dashpot would pull: no normal force
  int slides_ = 0;    // sign of the sliding velocity, 0: sticks
};

// The left sphere relative to the right one, as if of mass m/2; omega: sum of both spins.
class PairMotion : public HybridSystem {
 public:
  enum { X, Y, U, V, OMEGA, S, SIZE };

  explicit PairMotion(const SpherePair& pair) : pair_(pair), contact_(pair.law, 0.5 * pair.mass) {}
  bool touching() const { return contact_.touching(); }

  void rate(const State& y, State& dy) const override {
    const View v = view(y);
    const double fn = contact_.normal(v.delta, v.vn);
    const double ft = contact_.tangential(v.delta, v.vt, y[S]);
    const double reduced = 0.5 * pair_.mass;
    const double inertia = 0.4 * pair_.mass * pair_.radius * pair_.radius;
    dy[X] = y[U];
    dy[Y] = y[V];
    dy[U] = (fn * v.nx - ft * v.ny) / reduced;
    dy[V] = (fn * v.ny + ft * v.nx) / reduced;
    dy[OMEGA] = -2 * v.arm * ft / inertia;
    dy[S] = contact_.spring_rate(v.vt);
  }
  void guards(const State& y, std::vector<double>& g) const override {
    g.resize(ReferenceContact::guards);
    const View v = view(y);
    contact_.guard(v.delta, v.vn, v.vt, y[S], g.data());
  }
  void pass(std::size_t guard, State& y) override {
    const View v = view(y);
    contact_.pass(guard, v.delta, v.vn, v.vt, y[S]);
  }

 private:
  struct View {
    double nx, ny, arm, delta, vn, vt;
  };
  View view(const State& y) const {
    const double r = std::hypot(y[X], y[Y]);
    const double nx = y[X] / r, ny = y[Y] / r, arm = 0.5 * r;
    // The velocity along (-ny, nx) of the point of the surface, which lies against the normal.
    const double vt = -y[U] * ny + y[V] * nx - arm * y[OMEGA];
    return {nx, ny, arm, 2 * pair_.radius - r, y[U] * nx + y[V] * ny, vt};
  }

  SpherePair pair_;
  ReferenceContact contact_;
};

class RodMotion : public HybridSystem {
 public:
  enum { X, Y, ANGLE, VX, VY, OMEGA, S };

  explicit RodMotion(const RodOnFloor& rod)
      : rod_(rod), contacts_(rod.places.size(), ReferenceContact(rod.law, rod.mass)) {}

  void rate(const State& y, State& dy) const override {
    double fx = 0, fy = -rod_.mass * rod_.gravity, torque = 0;
    const double c = std::cos(y[ANGLE]), s = std::sin(y[ANGLE]);
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      dy[S + i] = 0;
      if (!contacts_[i].touching()) continue;
      const View v = view(y, i, c, s);
      const double fn = contacts_[i].normal(v.delta, v.vn);
      const double ft = contacts_[i].tangential(v.delta, v.vt, y[S + i]);
      fx += ft;
      fy += fn;
      torque += rod_.places[i] * (c * fn - s * ft) + v.arm * ft;
      dy[S + i] = contacts_[i].spring_rate(v.vt);
    }
    dy[X] = y[VX];
    dy[Y] = y[VY];
    dy[ANGLE] = y[OMEGA];
    dy[VX] = fx / rod_.mass;
    dy[VY] = fy / rod_.mass;
    dy[OMEGA] = torque / rod_.inertia;
  }
  void guards(const State& y, std::vector<double>& g) const override {
    g.resize(ReferenceContact::guards * contacts_.size());
    const double c = std::cos(y[ANGLE]), s = std::sin(y[ANGLE]);
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const View v = view(y, i, c, s);
      contacts_[i].guard(v.delta, v.vn, v.vt, y[S + i], &g[ReferenceContact::guards * i]);
    }
  }
  void pass(std::size_t guard, State& y) override {
    const std::size_t i = guard / ReferenceContact::guards;
    const View v = view(y, i, std::cos(y[ANGLE]), std::sin(y[ANGLE]));
    contacts_[i].pass(guard % ReferenceContact::guards, v.delta, v.vn, v.vt, y[S + i]);
  }

 private:
  struct View {
    double arm, delta, vn, vt;
  };
  View view(const State& y, std::size_t i, double c, double s) const {
    const double place = rod_.places[i];
    const double delta = rod_.radius - (y[Y] + place * s);
    const double arm = rod_.radius - 0.5 * delta;
    return {arm, delta, y[VY] + place * c * y[OMEGA], y[VX] + (arm - place * s) * y[OMEGA]};
  }

  RodOnFloor rod_;
  std::vector<ReferenceContact> contacts_;
};

std::array<double, 4> product(const std::array<double, 4>& a, const std::array<double, 4>& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
          a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
          a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

}  // namespace

PairOutcome collide(const SpherePair& pair, double step, Scheme scheme) {
  const double contact = 4 * pair.radius * pair.radius - pair.offset * pair.offset;
  if (!(contact > 0)) throw std::runtime_error("the spheres do not meet");
  PairMotion motion(pair);
  HybridSystem::State y(PairMotion::SIZE);
  y[PairMotion::X] = -std::sqrt(contact) * (1 + 1e-6);
  y[PairMotion::Y] = -pair.offset;
  y[PairMotion::U] = 2 * pair.speed;
  y[PairMotion::OMEGA] = pair.spin;
  const double period = std::sqrt(0.5 * pair.mass / pair.law.kn);
  integrate(motion, y, period, step, scheme);
  if (!motion.touching()) throw std::runtime_error("the spheres do not meet");
  for (int guard = 0; motion.touching() && guard < 100; ++guard)
    integrate(motion, y, period, step, scheme);
  return {y[PairMotion::U], y[PairMotion::V], y[PairMotion::OMEGA]};
}

PlanarState move(const RodOnFloor& rod, const PlanarState& start, double time, double step,
                 Scheme scheme) {
  RodMotion motion(rod);
  HybridSystem::State y = {start.x, start.y, start.angle, start.vx, start.vy, start.omega};
  y.resize(RodMotion::S + rod.places.size());
  integrate(motion, y, time, step, scheme);
  return {y[0], y[1], y[2], y[3], y[4], y[5]};
}

std::array<double, 4> symmetric_top(const std::array<double, 4>& start,
                                    const std::array<double, 3>& omega, double along, double across,
                                    double time) {
  const auto& [w, x, y, z] = start;
  const double axis[3] = {w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y)};
  const double spin = axis[0] * omega[0] + axis[1] * omega[1] + axis[2] * omega[2];
  double momentum[3], squared = 0;
  for (int d = 0; d < 3; ++d) {
    momentum[d] = across * omega[d] + (along - across) * spin * axis[d];
    squared += momentum[d] * momentum[d];
  }
  const double size = std::sqrt(squared);
  const double about_momentum = 0.5 * size / across * time;
  const double about_axis = 0.5 * spin * (1 - along / across) * time;
  const double s = size > 0 ? std::sin(about_momentum) / size : 0;
  return product(
      product({std::cos(about_momentum), s * momentum[0], s * momentum[1], s * momentum[2]}, start),
      {std::cos(about_axis), std::sin(about_axis), 0, 0});
}

}  // namespace rodpack
