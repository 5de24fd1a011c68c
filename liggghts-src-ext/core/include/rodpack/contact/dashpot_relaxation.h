// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CONTACT_DASHPOT_RELAXATION_H
#define RODPACK_CONTACT_DASHPOT_RELAXATION_H

#include <cmath>

namespace rodpack {

// Dashpots with a relaxation time tau: a spring stands in series with each, so that it feels, in
// place of the velocity v of the surfaces, a velocity u that follows it,
//   tau du/dt = v - u,  u = v at touch.
// Motions slower than tau are damped as without; fast ones are held by the spring in series, of the
// stiffness c / tau, in place of being damped (the standard linear solid, or Zener's model). That
// is for the many contacts of a rod in a bed, whose dashpots together are stiffer to integrate than
// their springs: u of a step is known beforehand, but for what v changes within it,
//   u_n = v_n + exp(-dt/tau) (u_{n-1} - v_n).
// SI units; tau = 0: none, u = v.

/// exp(-dt/tau): the share that u_n keeps of u_{n-1}.
inline double kept_in_step(double relaxation, double dt) {
  return relaxation > 0.0 ? std::exp(-dt / relaxation) : 0.0;
}

/// Share of a dashpot's constant that the fastest motion of a network feels, one that changes its
/// sign from step to step: u of v_n = (-1)^n is tanh(dt / (2 tau)) v. That motion alone sets the
/// limit of the step under leapfrog, so that dashpots count this much in it (theory.md, "Dashpots
/// with a relaxation time").
inline double share_in_fastest_motion(double relaxation, double dt) {
  return relaxation > 0.0 ? std::tanh(0.5 * dt / relaxation) : 1.0;
}

}  // namespace rodpack

#endif
