// SPDX-License-Identifier: GPL-2.0-or-later
// Contacts and what is told of them, for tests of the formulas that take any `Contact` and
// `Events`.
#ifndef RODPACK_TESTS_CONTACT_SAMPLE_CONTACT_H
#define RODPACK_TESTS_CONTACT_SAMPLE_CONTACT_H

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "rodpack/contact/event_correction.h"

namespace rodpack {

/// The members that contact_motion.h asks for.
struct SampleContact {
  bool is_wall = false;
  double radi = 0, radj = 0, radsum = 0, rsq = 0, r = 0, rinv = 0, deltan = 0, cri = 0, crj = 0;
  double delta[3] = {0, 0, 0}, en[3] = {0, 0, 0};
  double v_i[3] = {0, 0, 0}, v_j[3] = {0, 0, 0};
  double omega_i[3] = {0, 0, 0}, omega_j[3] = {0, 0, 0};
  double vn = 0, vtr1 = 0, vtr2 = 0, vtr3 = 0;
  double kn = 1000, kt = 500, gamman = 0, gammat = 0;

  /// Sets what follows from radii, delta, velocities and spins.
  void complete() {
    rsq = dot(delta, delta);
    radsum = radi + (is_wall ? 0 : radj);
    r = std::sqrt(rsq);
    complete_contact(*this);
  }
};

/// A sphere of radius 1 mm on the wall y = 0, pressed in by `overlap`, that moves at (vx, vy).
inline SampleContact on_floor(double overlap, double vx, double vy) {
  SampleContact contact;
  contact.is_wall = true;
  contact.radi = 1e-3;
  contact.delta[1] = contact.radi - overlap;
  contact.v_i[0] = vx;
  contact.v_i[1] = vy;
  contact.complete();
  return contact;
}

/// Keeps what contacts report, and tells them of a jump of their bodies if there was one.
struct RecordedEvents {
  struct Event {
    ForceChange on_i;
    bool jumps;
  };
  std::vector<Event> events;
  bool moved = false;
  ContactJump jump = {};

  template <class Contact>
  void add(const Contact&, const ForceChange& on_i, bool jumps) {
    events.push_back({on_i, jumps});
  }
  template <class Contact>
  bool motion_changed(const Contact&, ContactJump& result) const {
    result = jump;
    return moved;
  }
};

/// A change has this component along `axis`, to the relative error.
inline void expect_component(const ForceChange& change, int axis, double error, double now,
                             double rate, double impulse, double integral) {
  EXPECT_NEAR(change.now[axis], now, error * std::fabs(now));
  EXPECT_NEAR(change.rate[axis], rate, error * std::fabs(rate));
  EXPECT_NEAR(change.impulse[axis], impulse, error * std::fabs(impulse));
  EXPECT_NEAR(change.impulse_integral[axis], integral, error * std::fabs(integral));
}

}  // namespace rodpack

#endif
