// SPDX-License-Identifier: GPL-2.0-or-later
// A packing of equal rods, advanced as plainly as can be: what the planar engine is compared with.
#ifndef RODPACK_TESTS_PLANAR_PLAIN_SCENE_H
#define RODPACK_TESTS_PLANAR_PLAIN_SCENE_H

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "heap.h"
#include "rodpack/contact/contact_law.h"
#include "rodpack/motion/multistep.h"
#include "rodpack/motion/rigid_motion.h"

namespace rodpack {

/// The law of the engine without events, written down once more: all spheres against all, body by
/// body, with the integrator and the law of the core for single bodies.
class PlainScene {
 public:
  PlainScene(const PlanarSettings& settings, const std::vector<PlanarBody>& start)
      : settings_(settings),
        start_(start),
        past_(start.size(), std::vector<PlanarRates>(std::max(1, settings.order))),
        loads_(start.size()),
        factors_(start.size(), 1) {
    for (const PlanarBody& body : start) {
      const double angle = std::atan2(body.sine, body.cosine);
      motions_.push_back({{body.position[0], body.position[1]},
                          {body.velocity[0], body.velocity[1]},
                          body.velocity[2],
                          {std::cos(0.5 * angle), 0, 0, std::sin(0.5 * angle)}});
    }
  }

  void run(int steps) {
    evaluate(0);
    for (int step = 1; step <= steps; ++step) {
      for (std::size_t b = 0; b < start_.size(); ++b) move(b, step);
      evaluate(step);
    }
  }

  const PlanarMotion& motion(int body) const { return motions_[body]; }
  /// The number of contacts that there have been.
  std::size_t touched() const { return histories_.size(); }
  /// By how much the inertia of a body has grown at most.
  double largest_factor() const { return largest_factor_; }

 private:
  using Vector = std::array<double, 2>;
  /// Bodies and spheres: i and a, j and b; a wall: -1 - its index, and 0.
  using Key = std::array<int, 4>;

  struct History {
    double spring;
    std::vector<double> velocities;  // newest first
    int known, step;
    Vector felt;  // by the dashpots, along the normal and the tangent
  };

  /// What is geometry about a contact: normal from j to i, levers of i and j from their centres of
  /// mass to the contact.
  struct Contact {
    Key key;
    Vector normal;
    double overlap;
    Vector lever_i, lever_j;
    double mass;  // effective mass, kg
  };

  static double cross(const Vector& a, const Vector& b) { return a[0] * b[1] - a[1] * b[0]; }
  static Vector along(const Vector& from, double length, const Vector& direction) {
    return {from[0] + length * direction[0], from[1] + length * direction[1]};
  }

  Vector arm(int b, int sphere) const {
    const double* q = motions_[b].quaternion;
    const double c = q[0] * q[0] - q[3] * q[3], n = 2 * q[0] * q[3];
    const PlanarSphere& at = start_[b].spheres[sphere];
    return {c * at.x - n * at.y, n * at.x + c * at.y};
  }
  Vector velocity_of(int b, const Vector& lever) const {
    const PlanarMotion& motion = motions_[b];
    return {motion.velocity[0] - motion.angular_velocity * lever[1],
            motion.velocity[1] + motion.angular_velocity * lever[0]};
  }

  void move(std::size_t b, int step) {
    const PlanarBody& body = start_[b];
    PlanarMotion& motion = motions_[b];
    std::vector<PlanarRates>& past = past_[b];
    const int order = settings_.order;
    std::rotate(past.begin(), past.begin() + 1, past.end());
    past.back() = {{motion.velocity[0], motion.velocity[1]},
                   motion.angular_velocity,
                   {loads_[b][0] / body.mass / factors_[b], loads_[b][1] / body.mass / factors_[b]},
                   loads_[b][2] / body.moment / factors_[b]};
    if (order == 0) {
      leap(motion, past.back(), step, settings_.dt);
      return;
    }
    if (step == 1) fill_kinematic_history(past.data(), order, settings_.dt);
    advance(motion, past.data(), order, std::min(step, order + 1), settings_.dt);
  }

  void evaluate(int step) {
    const int bodies = static_cast<int>(start_.size());
    std::vector<double> weights(start_.size());
    weights_.swap(weights);
    for (int b = 0; b < bodies; ++b) loads_[b] = {0, settings_.gravity[1] * start_[b].mass, 0};
    for (int i = 0; i < bodies; ++i)
      for (int a = 0; a < static_cast<int>(start_[i].spheres.size()); ++a) {
        for (int w = 0; w < static_cast<int>(settings_.walls.size()); ++w)
          evaluate_wall(i, a, w, step);
        for (int j = i + 1; j < bodies; ++j)
          for (int b = 0; b < static_cast<int>(start_[j].spheres.size()); ++b)
            evaluate_pair({i, a, j, b}, step);
      }
    for (int b = 0; b < bodies; ++b) {
      factors_[b] = 1;
      const double stiff = settings_.mass_scaling * settings_.mass_scaling;
      if (stiff > 0 && weights_[b] > stiff) factors_[b] = weights_[b] / stiff;
      largest_factor_ = std::max(largest_factor_, factors_[b]);
    }
  }

  /// Mass scaling: m (1/m + (a^2 + R^2) / I) for a contact of a sphere a from the centre of mass.
  void count(int b, int sphere) {
    const PlanarBody& body = start_[b];
    const PlanarSphere& at = body.spheres[sphere];
    const double square = at.x * at.x + at.y * at.y + body.radius * body.radius;
    weights_[b] += body.mass * (1 / body.mass + square / body.moment);
  }

  void evaluate_wall(int i, int a, int w, int step) {
    const PlanarWall& wall = settings_.walls[w];
    const double r = start_[i].radius;
    const Vector arm_i = arm(i, a);
    const double distance = motions_[i].position[wall.axis] + arm_i[wall.axis] - wall.position;
    const double overlap = r - std::fabs(distance);
    if (overlap < 0) return;
    Contact contact = {};
    contact.key = {i, a, -1 - w, 0};
    contact.normal[wall.axis] = distance > 0 ? 1 : -1;
    contact.overlap = overlap;
    contact.lever_i = along(arm_i, -(r - 0.5 * overlap), contact.normal);
    contact.mass = start_[i].mass;
    // Touched at constant velocity, since which the tangential velocity was what it is now.
    const double vn = normal_velocity(contact), vt = tangential_velocity(contact);
    add_force(contact, vn < 0 ? std::min(settings_.dt, -overlap / vn) * vt : 0.0, step);
  }

  void evaluate_pair(const Key& key, int step) {
    const int i = key[0], j = key[2];
    const double r = start_[i].radius;
    const Vector arm_i = arm(i, key[1]), arm_j = arm(j, key[3]);
    Vector delta;
    for (int d = 0; d < 2; ++d)
      delta[d] = motions_[i].position[d] + arm_i[d] - motions_[j].position[d] - arm_j[d];
    const double distance = std::hypot(delta[0], delta[1]), overlap = 2 * r - distance;
    if (overlap <= 0) return;
    const Vector normal = {delta[0] / distance, delta[1] / distance};
    const double length = r - 0.5 * overlap;
    const Vector vi = velocity_of(i, arm_i), vj = velocity_of(j, arm_j);
    const Contact contact = {key,
                             normal,
                             overlap,
                             along(arm_i, -length, normal),
                             along(arm_j, length, normal),
                             0.5 * start_[i].mass};
    add_force(contact, spring_since_touch(i, j, delta, {vi[0] - vj[0], vi[1] - vj[1]}), step);
  }

  /// The spring of a contact that has touched within the step: mean of the tangential velocities
  /// then and now, with constant velocities of the centres, `u` apart, and spins, over the time
  /// since. `delta`: from the centre of j's sphere to that of i's.
  double spring_since_touch(int i, int j, const Vector& delta, const Vector& u) const {
    const double r = start_[i].radius, distance = std::hypot(delta[0], delta[1]);
    const double spins = motions_[i].angular_velocity + motions_[j].angular_velocity;
    const double approach = delta[0] * u[0] + delta[1] * u[1];
    const double square = u[0] * u[0] + u[1] * u[1], closed = 4 * r * r - distance * distance;
    const double since = std::min(
        settings_.dt, (approach + std::sqrt(approach * approach + square * closed)) / square);
    const Vector touch = along(delta, -since, u);
    const double then = cross(touch, u) / std::hypot(touch[0], touch[1]) - r * spins;
    const double now = cross(delta, u) / distance - 0.5 * distance * spins;
    return 0.5 * since * (then + now);
  }

  Vector surface_velocity(const Contact& contact) const {
    Vector v = velocity_of(contact.key[0], contact.lever_i);
    if (contact.key[2] < 0) return v;
    return along(v, -1.0, velocity_of(contact.key[2], contact.lever_j));
  }
  double normal_velocity(const Contact& contact) const {
    const Vector v = surface_velocity(contact);
    return v[0] * contact.normal[0] + v[1] * contact.normal[1];
  }
  double tangential_velocity(const Contact& contact) const {
    return cross(contact.normal, surface_velocity(contact));
  }

  /// Brings the history to this step; `touch_spring` is the spring of a contact that is new.
  History& renewed_history(const Contact& contact, double touch_spring, int step) {
    const int order = settings_.order;
    History& history = histories_[contact.key];
    const Vector now = {normal_velocity(contact), tangential_velocity(contact)};
    if (history.velocities.empty() || history.step != step - 1) {
      history = {touch_spring, {}, 0, step, now};
    } else if (order == 0) {
      history.spring += settings_.dt * now[1];
    } else {
      const auto& weights = multistep_weights(order, std::min(history.known, order + 1));
      for (int k = 0; k < std::min<int>(order, history.velocities.size()); ++k)
        history.spring += settings_.dt * weights[k] * history.velocities[k];
    }
    history.step = step;
    ++history.known;
    history.velocities.insert(history.velocities.begin(), now[1]);
    history.velocities.resize(std::min<std::size_t>(history.velocities.size(), std::max(1, order)));
    const double tau = settings_.dashpot_relaxation;
    for (int d = 0; d < 2; ++d)
      history.felt[d] = tau > 0 && history.known > 1
                            ? now[d] + std::exp(-settings_.dt / tau) * (history.felt[d] - now[d])
                            : now[d];
    return history;
  }

  void add_force(const Contact& contact, double touch_spring, int step) {
    const PlanarLaw& law = settings_.laws[0];
    History& history = renewed_history(contact, touch_spring, step);
    const NormalForce normal =
        normal_force(law.kn, damping_coefficient(law.eta_n, contact.mass, law.kn), contact.overlap,
                     history.felt[0]);
    double spring[1] = {history.spring}, velocity[1] = {history.felt[1]}, tangential[1];
    tangential_force(law.kt, damping_coefficient(law.eta_t, contact.mass, law.kt),
                     law.friction * (settings_.total_force_cap ? normal.total : normal.elastic),
                     spring, velocity, tangential);
    history.spring = spring[0];
    const Vector& n = contact.normal;
    const Vector force = {normal.total * n[0] - tangential[0] * n[1],
                          normal.total * n[1] + tangential[0] * n[0]};
    count(contact.key[0], contact.key[1]);
    if (contact.key[2] >= 0) count(contact.key[2], contact.key[3]);
    add_load(contact.key[0], contact.lever_i, force, 1.0);
    if (contact.key[2] >= 0) add_load(contact.key[2], contact.lever_j, force, -1.0);
  }

  void add_load(int b, const Vector& lever, const Vector& force, double sign) {
    loads_[b][0] += sign * force[0];
    loads_[b][1] += sign * force[1];
    loads_[b][2] += sign * cross(lever, force);
  }

  const PlanarSettings settings_;
  const std::vector<PlanarBody> start_;
  std::vector<PlanarMotion> motions_;
  std::vector<std::vector<PlanarRates>> past_;
  std::vector<std::array<double, 3>> loads_;
  std::map<Key, History> histories_;
  std::vector<double> weights_, factors_;  // of mass scaling
  double largest_factor_ = 1;
};

}  // namespace rodpack

#endif
