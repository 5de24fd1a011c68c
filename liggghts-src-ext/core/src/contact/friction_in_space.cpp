// SPDX-License-Identifier: GPL-2.0-or-later
// The friction of a contact that moves across its force: what the plane does not know.
#include <algorithm>
#include <cmath>
#include <limits>

#include "rodpack/contact/friction_step.h"

namespace rodpack {
namespace detail {
namespace {

/// What turns the spring at one moment.
struct SlideState {
  double stiffness, damping, cap, along, across;
  /// Rate of the angle of the spring from the beginning, and its derivative by the angle.
  void rate(double angle, double& rate, double& slope) const {
    const double c = std::cos(angle), s = std::sin(angle);
    const double with = along * c + across * s, aside = across * c - along * s;
    const double squared =
        cap * (cap + 2.0 * damping * with) + damping * damping * (along * along + across * across);
    const double load = std::sqrt(std::max(squared, std::numeric_limits<double>::min()));
    rate = stiffness * aside / load;
    slope = -stiffness * (with + cap * damping * aside * aside / (load * load)) / load;
  }
};

/// 2 cap u.v + c v^2, N m/s, `age` seconds ago, when the spring had the direction u: above 0 the
/// slider moves.
double slider_excess(const FrictionStep& step, double age, const double (&direction)[3]) {
  double velocity[3];
  slip_at(step, age, velocity);
  return 2.0 * cap_at(step, age) * dot(direction, velocity) +
         step.damping * dot(velocity, velocity);
}

/// Time since `excess`(age), a function of the time before now (s) in 0..dt, was 0.
template <class Excess>
double time_since_change(const Excess& excess, double dt) {
  double late = 0.0, early = dt, at_late = excess(late), at_early = excess(early);
  if ((at_late > 0.0) == (at_early > 0.0)) return time_since_zero(at_early, at_late, dt);
  double since = late;
  for (int k = 0; k < 60; ++k) {
    // Regula falsi; an end that stays for a second time counts half.
    const double before = since;
    since = (late * at_early - early * at_late) / (at_early - at_late);
    const double value = excess(since);
    if (value == 0.0 || (k > 0 && std::fabs(since - before) < 1e-14 * dt)) break;
    if ((value > 0.0) == (at_late > 0.0)) {
      if (since > before) at_early *= 0.5;
      late = since;
      at_late = value;
    } else {
      if (since < before) at_late *= 0.5;
      early = since;
      at_early = value;
    }
  }
  return since;
}

/// The way of the surfaces since `age` seconds ago, m.
void slip_since(const FrictionStep& step, double age, double (&way)[3]) {
  double then[3], halfway[3];
  slip_at(step, age, then);
  slip_at(step, 0.5 * age, halfway);
  for (int d = 0; d < 3; ++d)
    way[d] = age / 6.0 * (then[d] + 4.0 * halfway[d] + step.velocity[0][d]);
}

/// The slide of a contact that slid one step ago already.
SlideTurning go_on_sliding(const FrictionStep& step) {
  double direction[3], velocity[3];
  const bool touched = step.since_touch > 0.0 && step.known > 1;
  if (!touched && direction_of(step.spring_before, direction) > 0.0)
    return SlideTurning(step, direction, step.dt);
  // The spring of the first evaluation began at touch, along the velocity of then, as one does
  // where there was no cap.
  const double age = touched ? step.dt + step.since_touch : step.known > 1 ? step.dt : 0.0;
  slip_at(step, age, velocity);
  direction_of(velocity, direction);
  return SlideTurning(step, direction, age);
}

/// The slide of a contact that has begun `since` seconds ago with the trial force `trial` (N), and
/// moved at `velocity` then: the force goes on from it, or, where the dashpot of what the velocity
/// has across alone carries more than the cap, or the slider would not move, jumps.
SlideTurning begin_to_slide(const FrictionStep& step, double since, const double (&velocity)[3],
                            const double (&trial)[3]) {
  double direction[3];
  direction_of(trial, direction);
  for (double& component : direction) component = -component;
  const double cap = cap_at(step, since), along = dot(velocity, direction);
  const double damped = step.damping * step.damping;
  const double room = cap * cap - damped * (dot(velocity, velocity) - along * along);
  const double load = step.damping * along + std::sqrt(std::max(0.0, room));
  if (room > 0.0 && load > cap)
    for (int d = 0; d < 3; ++d)
      direction[d] = (load * direction[d] - step.damping * velocity[d]) / cap;
  return SlideTurning(step, direction, since);
}

/// The force (N) of a slide whose spring lies along the unit vector `direction` now; sets the
/// spring, m.
void slide_now(const FrictionStep& step, const double (&direction)[3], double (&spring)[3],
               double (&force)[3]) {
  const double length = carrying_spring(-std::max(0.0, step.cap), step.stiffness);
  for (int d = 0; d < 3; ++d) spring[d] = length * direction[d];
  slide_force(step.stiffness, step.damping, spring, step.velocity[0], step.normal, force);
}

/// By how much faster the force of spring and dashpot changes now than that of a slide, N/s.
void stuck_beyond_slide(const FrictionStep& step, const double (&direction)[3], double (&rate)[3]) {
  const double cap = std::max(0.0, step.cap);
  const double(&velocity)[3] = step.velocity[0];
  double load[3], acceleration[3], load_rate[3];
  for (int d = 0; d < 3; ++d) {
    load[d] = cap * direction[d] + step.damping * velocity[d];
    acceleration[d] = (velocity[d] - step.velocity[1][d]) / step.dt;
  }
  const double squared = dot(load, load), length = std::sqrt(squared);
  const double along = dot(velocity, direction);
  for (int d = 0; d < 3; ++d)
    load_rate[d] = step.cap_rate * direction[d] + step.damping * acceleration[d] +
                   cap * step.stiffness * (velocity[d] - along * direction[d]) / length;
  const double with = dot(load_rate, load) / squared;
  for (int d = 0; d < 3; ++d) {
    const double slide = step.cap_rate * load[d] + cap * (load_rate[d] - with * load[d]);
    rate[d] =
        trial_force(step.stiffness, velocity[d], step.damping, acceleration[d]) + slide / length;
  }
}

}  // namespace

SlideTurning::SlideTurning(const FrictionStep& step, const double (&begin)[3], double age)
    : step_(step), begin_(age) {
  std::copy(begin, begin + 3, along_);
  cross(step.normal, along_, across_);
}

void SlideTurning::at(double age, double (&direction)[3]) const {
  const double angle = angle_at(age), cosine = std::cos(angle), sine = std::sin(angle);
  for (int d = 0; d < 3; ++d) direction[d] = cosine * along_[d] + sine * across_[d];
}

// Radau's formula of third order: where the surfaces slip by many lengths of the spring in a step,
// its end follows the velocity of now, as it should.
double SlideTurning::angle_at(double age) const {
  const auto state = [&](double then) {
    double velocity[3];
    slip_at(step_, then, velocity);
    return SlideState{step_.stiffness, step_.damping, cap_at(step_, then), dot(velocity, along_),
                      dot(velocity, across_)};
  };
  const double h = begin_ - age;
  const SlideState middle = state(age + h * (2.0 / 3.0)), end = state(age);
  // Under a constant velocity, and load, the tangent of half the angle to it decays.
  const double towards = std::atan2(end.across, end.along);
  const double speed = std::hypot(end.across, end.along);
  const double load = end.cap + end.damping * speed;
  const double decay = load > 0.0 ? std::exp(-h * end.stiffness * speed / load) : 0.0;
  const double guess = towards - 2.0 * std::atan(decay * std::tan(0.5 * towards));
  double a = guess, b = guess;
  for (int k = 0; k < 12; ++k) {
    double f, g, df, dg;
    middle.rate(a, f, df);
    end.rate(b, g, dg);
    const double r = a - h * (5.0 * f - g) / 12.0, s = b - h * (3.0 * f + g) / 4.0;
    const double p = 1.0 - h * df * (5.0 / 12.0), q = h * dg / 12.0, t = -0.75 * h * df;
    const double u = 1.0 - 0.25 * h * dg, determinant = p * u - q * t;
    const double da = (u * r - q * s) / determinant, db = (p * s - t * r) / determinant;
    a -= da;
    b -= db;
    if (std::fabs(da) + std::fabs(db) < 1e-8) return b;  // Newton's next one would be its square
    if (!(std::fabs(a) + std::fabs(b) < 10.0)) return guess;
  }
  return guess;
}

FrictionForce begin_slide(const FrictionStep& step, const double (&stuck)[3], double (&spring)[3]) {
  FrictionForce result = {};
  result.slides = result.changed = true;
  double velocity[3], trial[3];
  const auto trial_at = [&](double age) {
    double way[3];
    slip_at(step, age, velocity);
    slip_since(step, age, way);
    for (int d = 0; d < 3; ++d)
      trial[d] = trial_force(step.stiffness, spring[d] - way[d], step.damping, velocity[d]);
  };
  result.since = time_since_change(
      [&](double age) {
        trial_at(age);
        return std::sqrt(dot(trial, trial)) - cap_at(step, age);
      },
      step.dt);
  trial_at(result.since);
  const SlideTurning turning = begin_to_slide(step, result.since, velocity, trial);
  double direction[3], jump[3];
  turning.at(result.since, direction);
  for (double& component : direction) component *= cap_at(step, result.since);
  slide_force(1.0, step.damping, direction, velocity, step.normal, jump);
  for (int d = 0; d < 3; ++d) jump[d] -= trial[d];
  result.jumps = dot(jump, jump) > 1e-6 * dot(trial, trial);

  turning.at(0.0, direction);
  slide_now(step, direction, spring, result.force);
  stuck_beyond_slide(step, direction, result.gain_rate);
  for (int d = 0; d < 3; ++d) {
    result.gain[d] = result.force[d] - stuck[d];
    result.gain_rate[d] *= -1.0;
  }
  return result;
}

FrictionForce go_on(const FrictionStep& step, double (&spring)[3]) {
  FrictionForce result = {};
  const SlideTurning turning = go_on_sliding(step);
  double direction[3], sliding[3];
  turning.at(0.0, direction);
  slide_now(step, direction, spring, sliding);
  result.slides = step.known < 2 || slider_excess(step, 0.0, direction) > 0.0;
  std::copy(sliding, sliding + 3, result.force);
  if (result.slides) return result;
  result.changed = true;
  result.since = time_since_change(
      [&](double age) {
        double then[3];
        turning.at(age, then);
        return slider_excess(step, age, then);
      },
      step.dt);
  stuck_beyond_slide(step, direction, result.gain_rate);
  double way[3];
  slip_since(step, result.since, way);
  turning.at(std::min(result.since, step.dt), direction);
  const double cap = std::max(0.0, step.cap);
  const double length = carrying_spring(-cap_at(step, result.since), step.stiffness);
  for (int d = 0; d < 3; ++d) spring[d] = length * direction[d] + way[d];
  for (double& component : direction) component = -component;
  stick_with(step, cap, direction, spring, result.force);
  for (int d = 0; d < 3; ++d) result.gain[d] = result.force[d] - sliding[d];
  return result;
}

}  // namespace detail

void turn_slide(const FrictionStep& step, double (&spring)[3]) {
  double direction[3];
  if (!(detail::direction_of(step.spring_before, direction) > 0.0) ||
      !detail::moves_across(step.velocity[0], direction, step.normal))
    return;
  const double length = std::sqrt(dot(spring, spring));
  detail::SlideTurning(step, direction, step.dt).at(0.0, direction);
  for (int d = 0; d < 3; ++d) spring[d] = length * direction[d];
}

}  // namespace rodpack
