// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_MOTION_STABILITY_LIMIT_H
#define RODPACK_MOTION_STABILITY_LIMIT_H

namespace rodpack {

// Linear stability of the integrators on x'' = -omega^2 x - 2 eta omega v, a spring and dashpot in
// permanent contact (omega = sqrt(k/m), damping ratio eta >= 0; 1 is critical). `order` names the
// method:
//   1..4  Adams-Bashforth for position and velocity,
//         x_{n+1} = x_n + dt sum w_k v_{n-k},  v_{n+1} = v_n + dt sum w_k a_{n-k};
//   0     velocity Verlet as LIGGGHTS has it: the force at t_n sees the velocity of half a step
//         before, v_{n+1/2} = v_{n-1/2} + dt a(x_n, v_{n-1/2}),  x_{n+1} = x_n + dt v_{n+1/2}.
// All throw std::invalid_argument for an order outside 0..4 and for numbers that are negative or
// not finite.

/// Largest modulus of the method's amplification factors at the step omega dt: amplitudes grow by
/// this factor per step in the long run, or shrink when it is below 1.
///
/// Factors of Adams-Bashforth: both roots lambda of lambda^2 + 2 eta omega lambda + omega^2 = 0
/// have a characteristic polynomial of their own, z^p - z^(p-1) - lambda dt sum w_k z^(p-1-k) = 0
/// (p = order), whose roots are the eigenvalues of its companion matrix.
double amplification(int order, double damping_ratio, double omega_dt);

/// Largest omega dt up to which no amplitude grows. 0 for orders 1 and 2 without damping: they are
/// unstable at any step.
///
/// In closed form: velocity Verlet 2 (sqrt(1 + eta^2) - eta); order 1 2 eta up to eta = 1. On the
/// imaginary axis (eta = 0) order 3 0.7236, order 4 0.4300. Strongly damped (eta -> infinity) 2
/// eta omega dt tends to 2, 1, 6/11 and 3/10 for orders 1 to 4 and to 2 for velocity Verlet.
double stability_limit(int order, double damping_ratio);

/// What is known of all motions x of a network of linear contacts, M x'' + C x' + K x = 0: with
/// kappa = x.Kx / x.Mx and c = x.Cx / x.Mx, kappa <= stiffness, c <= damping and
/// delay_min <= c / kappa <= delay_max.
struct MotionBounds {
  double stiffness;  // square of the highest angular frequency, or a bound of it, 1/s^2, > 0
  double damping;    // 1/s
  // Smallest and largest ratio of dashpot constant to stiffness of a contact, s: c / k is
  // 2 eta sqrt(m_ij / k_ij).
  double delay_min, delay_max;
};

/// Time step (s) up to which no motion within these bounds grows; may be 0 for orders 1 and 2.
///
/// Each eigenmotion x obeys the scalar equation above with omega^2 = kappa and 2 eta omega = c, so
/// the least limit of all (kappa, c) allowed is safe. The limit falls with omega at a given delay;
/// at a given omega it falls with eta, or (orders 1 and 2) rises before it falls; at a given c it
/// falls with omega, or (overdamped) rises. So the least lies at one of three corners.
double timestep_limit(int order, const MotionBounds& bounds);

}  // namespace rodpack

#endif
