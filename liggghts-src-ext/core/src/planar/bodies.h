// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_BODIES_H
#define RODPACK_PLANAR_BODIES_H

#include <cstdint>
#include <vector>

#include "../planar_simd/aligned_vector.h"
#include "box.h"
#include "contact.h"
#include "../planar_simd/arguments.h"
#include "parts.h"
#include "rodpack/motion/mass_scaling.h"
#include "rodpack/planar/scene.h"

namespace rodpack {

class PlanarEvents;
class PlanarNeighbours;

/// What is constant about a body.
struct PlanarBodyInfo {
  int type;
  bool prescribed;
  double mass, moment, radius;
  double reach;  // of its farthest point from the centre of mass, m
  PlanarBox box;
  int first, count;  // of its spheres
};

/// State of the bodies: where they are, how they move, the loads on them, the rates of the last
/// steps that the multistep formula needs, and the motion that events have found to be missing. The
/// bodies of this rank come first; behind them lie the ghosts, copies of bodies of other ranks, of
/// which contacts need the kinematics alone.
class PlanarBodyStates {
 public:
  PlanarBodyStates(const PlanarSettings& settings, const PlanarParts& parts,
                   const std::vector<PlanarBody>& bodies);

  int owned() const { return parts_.owned; }
  int size() const { return static_cast<int>(info_.size()); }  // with ghosts
  int tag(int body) const { return tags_[body]; }
  const PlanarBodyInfo& info(int body) const { return info_[body]; }
  const PlanarSphere* spheres(int body) const { return spheres_.data() + info_[body].first; }
  /// Asks for the spheres of a body, so that they are in the cache soon.
  void prefetch_spheres(int body) const {
    const PlanarSphere* const first = spheres(body);
    for (int k = 0; k < info_[body].count; k += 64 / static_cast<int>(sizeof(PlanarSphere)))
      __builtin_prefetch(first + k);
  }
  const PlanarKinematics& kinematics(int body) const { return kinematics_[body]; }
  /// The largest distance from a centre of mass to a point of its body, m.
  double longest_reach() const;
  /// Displacement in a step, at its present speed, of the point of the body that moves fastest, m,
  /// relative to a frame that goes (x, y), m, in a step.
  double step_displacement(int body, double x = 0.0, double y = 0.0) const;
  /// Of a contact of the body, for its inertia; with mass scaling alone.
  const ContactWeight& weight(int body) const { return weights_[body]; }
  /// Whether body i is the first of the two in a block; the same on every rank.
  bool comes_first(int i, int j) const { return tags_[i] < tags_[j]; }
  /// Constants, position and velocity of a body, ghosts too.
  PlanarBody present(int body) const;
  /// All that is known of a body of this rank before step `step`, but for the last event.
  PlanarBody state(int body, long step) const;

  // One step, which leads from `step` to step + 1, for the bodies of a part.

  /// Makes the motion that events have found to be missing, and a past for bodies that have none.
  void prepare(int part, long step, PlanarNeighbours& neighbours);
  /// Advances the part from `step`. Sets `to_list` to the bodies that have left their skins, or are
  /// about to do so in `steps_ahead` further steps.
  void advance(int part, long step, const PlanarKernel& kernel, PlanarNeighbours& neighbours,
               int steps_ahead, std::vector<int>& to_list);
  /// Corrects the past of bodies whose contacts had events in the step before `step`, and keeps the
  /// motion that they have missed.
  void apply_events(int part, long step, PlanarEvents& events);
  /// Sets the loads to the weights of the bodies, as if they had no contacts.
  void begin_loads();

  /// Sets what the SIMD loop needs of the bodies to add the forces of contacts to their loads.
  void set_arguments(PlanarForceArguments& arguments);
  /// Counts a contact of a body at the offset `offset` (m, in its frame) of one of its spheres.
  void add_contact(int body, const double (&offset)[2]) {
    if (settings_.mass_scaling > 0.0)
      loads_[body].d[3] +=
          contact_weight(weights_[body], offset[0] * offset[0] + offset[1] * offset[1]);
  }
  /// Adds a force, N, and a torque about the centre of mass, N m, to the load on a body.
  void add_load(int body, Vector2<double> force, double torque) {
    double* const load = loads_[body].d;
    load[0] += force.x;
    load[1] += force.y;
    load[2] += torque;
  }

  // Ghosts, with the indices from owned() on.

  /// Makes room for `bodies` bodies in all.
  void resize(int bodies);
  /// Forgets the spheres of all ghosts, until set_ghost() gives them again.
  void forget_ghost_spheres();
  void set_ghost(int ghost, const PlanarBody& body);
  /// The ghost is out of use until it is set again.
  void clear_ghost(int ghost) { info_[ghost].count = 0; }
  /// Gives a ghost the position, orientation and velocity of `moved`.
  void move_ghost(int ghost, const PlanarKinematics& moved);

 private:
  void add(int body, const PlanarBody& from);
  void set_info(int body, const PlanarBody& from);
  void make_missed_motion(int body);
  /// By how much the body answers to forces less than its inertia says (mass_scaling.h); <= 1.
  double answer(int body) const;
  PlanarAdvanceArguments arguments(int part, long step);
  void fill_past(int body, long step);
  /// Index into past_velocity and past_acceleration, ring buffers, of the rates k + 1 steps back.
  int past(int k, long step) const {
    const int count = settings_.order - 1;
    return static_cast<int>((k - step % count + count) % count);
  }

  const PlanarSettings& settings_;
  const PlanarParts parts_;
  AlignedVector<PlanarKinematics> kinematics_;
  AlignedVector<PlanarVector> loads_;    // with mass scaling, the fourth: its contacts' weights
  AlignedVector<PlanarVector> inertia_;  // 1/mass, 1/mass, 1/moment (0 if prescribed), mass
  AlignedVector<PlanarVector> past_velocity_[max_multistep_order - 1];
  AlignedVector<PlanarVector> past_acceleration_[max_multistep_order - 1];
  std::vector<ContactWeight> weights_;  // of a contact of each body, with mass scaling alone
  std::vector<std::int8_t> evaluations_;
  AlignedVector<PlanarVector> missed_displacement_, missed_velocity_;
  std::vector<std::vector<int>> missed_;   // bodies of each part with missed motion
  std::vector<std::vector<int>> newborn_;  // bodies of each part that have not moved yet
  std::vector<PlanarBodyInfo> info_;
  std::vector<int> tags_;
  std::vector<PlanarSphere> spheres_;
};

}  // namespace rodpack

#endif
