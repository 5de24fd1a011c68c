// SPDX-License-Identifier: GPL-2.0-or-later
#include "timestep/head_on_collision.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "rodpack/contact/contact_law.h"
#include "rodpack/contact/contact_motion.h"
#include "rodpack/contact/dashpot_relaxation.h"
#include "rodpack/contact/friction_cap.h"
#include "rodpack/contact/normal_history.h"
#include "rodpack/motion/multistep.h"

namespace rodpack {
namespace {

constexpr int moments = 12;

/// A sphere of mass 1 on a wall, spring constant 1; its radius is large against the overlap. The
/// members are those that contact_motion.h asks for.
struct WallContact {
  bool is_wall = true;
  double radi = 1e3, radj = 0, radsum = 1e3, r = 0, rinv = 0, deltan = 0, cri = 0, crj = 0;
  double delta[3] = {0, 0, 0}, en[3] = {0, 0, 0};
  double v_i[3] = {0, 0, 0}, v_j[3] = {0, 0, 0};
  double omega_i[3] = {0, 0, 0}, omega_j[3] = {0, 0, 0};
  double vn = 0, vtr1 = 0, vtr2 = 0, vtr3 = 0;
  double kn = 1, kt = 0, gamman = 0, gammat = 0;

  WallContact(double gap, double velocity, double damping) : gamman(damping) {
    r = radi + gap;
    delta[0] = r;
    v_i[0] = velocity;
    complete_contact(*this);
  }
};

/// The sphere's gap to the wall and its velocity, over time.
struct Flight {
  double gap, velocity;
};

/// What follow_velocity() asks for.
struct ClosingContact {
  double vn;
};

/// `felt`: the velocity that the dashpot feels.
double force_at(double gap, double felt, double damping) {
  return gap < 0 ? normal_force(1, damping, -gap, felt).total : 0;
}

/// Velocity Verlet as LIGGGHTS has it: the force sees the velocity of half a step before. The
/// dashpot keeps the share `kept` of what it felt a step ago.
double rebound_with_verlet(Flight flight, double damping, double kept, double dt, long steps) {
  double force = 0;
  NormalHistory history;
  bool touching = false;
  for (long i = 0; i < steps; ++i) {
    flight.velocity += 0.5 * dt * force;
    flight.gap += dt * flight.velocity;
    const ClosingContact contact = {flight.velocity};
    force = force_at(flight.gap, follow_velocity(contact, history, touching, kept), damping);
    touching = flight.gap < 0;
    flight.velocity += 0.5 * dt * force;
  }
  return flight.velocity;
}

/// Adams-Bashforth of position and velocity, with the corrections of events where asked for, as in
/// fix multisphere/ab.
double rebound_with_adams_bashforth(int order, bool follows, Flight flight, double damping,
                                    double dt, long steps) {
  const MultistepWeights& weights = adams_bashforth_weights(order);
  std::array<Flight, max_multistep_order> rates;  // velocity in `gap`, force in `velocity`
  rates.fill({flight.velocity, 0});
  NormalHistory history;
  NormalChanges last;
  bool touching = false;
  for (long i = 0; i < steps; ++i) {
    NormalChanges events;
    if (last.any) {
      flight.gap += last.sum.impulse_integral[0];
      flight.velocity += last.sum.impulse[0];
      for (int k = 0; k < order; ++k) {
        rates[k].gap += last.sum.past_momentum(0, k * dt);
        // The force of now was evaluated on the new branch.
        if (k > 0) rates[k].velocity += last.sum.past_force(0, k * dt);
      }
      events.moved = last.jumps;
      events.jump.acceleration[0] = last.sum.now[0];
      events.jump.velocity[0] = last.sum.impulse[0];
      events.jump.displacement[0] = last.sum.impulse_integral[0];
    }
    flight.gap += multistep_increment(weights, order, dt, [&](int k) { return rates[k].gap; });
    flight.velocity +=
        multistep_increment(weights, order, dt, [&](int k) { return rates[k].velocity; });
    if (follows) {
      const WallContact contact(flight.gap, flight.velocity, damping);
      if (flight.gap < 0)
        follow_normal_force(contact, history,
                            viscoelastic_force(1.0, contact.deltan, damping, contact.vn), touching,
                            dt, &events);
      else if (touching)
        end_normal_force(contact, history, dt, events);
      touching = flight.gap < 0;
    }
    std::rotate(rates.rbegin(), rates.rbegin() + 1, rates.rend());
    rates[0] = {flight.velocity, force_at(flight.gap, flight.velocity, damping)};
    last = events;
  }
  return flight.velocity + (last.any ? last.sum.impulse[0] : 0);
}

}  // namespace

const std::vector<Integrator>& integrators() {
  static const std::vector<Integrator> all = {
      {"leapfrog", "multisphere/ab order 0", 0, false},
      {"builtin", "multisphere", 0, false},
      {"relaxed", "multisphere/ab order 0", 0, false, 1},
      {"ab1", "multisphere/ab order 1 events no", 1, false},
      {"ab2", "multisphere/ab order 2 events no", 2, false},
      {"ab2e", "multisphere/ab order 2 events yes", 2, true},
      {"ab3", "multisphere/ab order 3 events no", 3, false},
      {"ab3e", "multisphere/ab order 3 events yes", 3, true},
      {"ab4e", "multisphere/ab order 4 events yes", 4, true}};
  return all;
}

double Integrator::dashpot_share() const { return share_in_fastest_motion(relaxation_steps, 1); }

double rebound_error(const Integrator& integrator, double damping_ratio,
                     double steps_per_collision) {
  const double dt = std::acos(-1.0) / steps_per_collision, damping = 2 * damping_ratio;
  const double expected = restitution_coefficient(damping_ratio);
  const double kept = kept_in_step(integrator.relaxation_steps, 1);
  // The longest contact lasts 2 acos(eta) / sqrt(1 - eta^2) <= pi, critically damped 2.
  const long steps = static_cast<long>(std::ceil(1.3 * steps_per_collision)) + 8;
  double sum = 0;
  for (int m = 0; m < moments; ++m) {
    const Flight start = {(m + 0.5) / moments * dt, -1};
    const double rebound = integrator.order == 0
                               ? rebound_with_verlet(start, damping, kept, dt, steps)
                               : rebound_with_adams_bashforth(integrator.order, integrator.events,
                                                              start, damping, dt, steps);
    sum += (rebound / expected - 1) * (rebound / expected - 1);
  }
  const double error = std::sqrt(sum / moments);
  return std::isfinite(error) ? error : std::numeric_limits<double>::infinity();
}

}  // namespace rodpack
