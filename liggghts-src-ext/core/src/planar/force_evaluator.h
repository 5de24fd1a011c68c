// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_FORCE_EVALUATOR_H
#define RODPACK_PLANAR_FORCE_EVALUATOR_H

#include <vector>

#include "../planar_simd/aligned_vector.h"
#include "blocks.h"
#include "contact.h"
#include "events.h"
#include "../planar_simd/arguments.h"
#include "rodpack/contact/tangential_history.h"

namespace rodpack {

class PlanarBodyStates;
class PlanarNeighbours;

/// Evaluates the contact forces of one part of the bodies at a time: adds them to the loads of the
/// bodies, brings the contact histories to the present step, and reports the contacts' events. Most
/// contacts take the SIMD loop; those to which something happens that it does not know are left to
/// the general path, one contact at a time by the formulas of contacts in space.
class PlanarForceEvaluator {
 public:
  /// All that is given has to outlive it.
  PlanarForceEvaluator(const PlanarSettings& settings, const PlanarKernel& kernel,
                       PlanarBodyStates& bodies, const PlanarNeighbours& neighbours,
                       PlanarBlocks& blocks, PlanarEvents& events);

  /// Evaluates the contacts that part `part` completes, at the positions of step `step`.
  void evaluate(int part, long step);
  /// All contacts, as the caller of a scene knows them.
  std::vector<PlanarContactState> contacts() const;
  /// Evaluations after which a contact is past its start-up, and all that events may look at is
  /// known.
  int full_count() const { return settings_.order == 0 ? 1 : slots_ + 1; }
  /// Whether events of contacts are followed.
  bool follows_events() const { return follows_; }
  /// Contacts that have taken the general path so far.
  long general_contacts() const { return general_contacts_; }

 private:
  PlanarForceArguments arguments(PlanarBlockPool& pool, int part);
  void evaluate_general(PlanarBlockPool& pool, int entries);
  void evaluate_lane(PlanarBlockPool& pool, int place, int lane);
  template <class Cap>
  TangentialForce friction_of(const PlanarContact& contact, TangentialHistory& history,
                              const Cap& cap);
  template <class Cap>
  void end(const PlanarContact& contact, const NormalHistory& normal, TangentialHistory& history,
           const Cap& cap);
  PlanarContactState contact_state(const PlanarBlockPool& pool, int place, int lane) const;
  bool place_lane(const PlanarBlockPool& pool, int place, int lane, PlanarContact& contact) const;
  void apply(const PlanarContact& contact, double normal, const double (&tangential)[3]);
  TangentialStep tangential_step() const { return {settings_.order, step_, settings_.dt, kept_}; }

  const PlanarSettings& settings_;
  const int slots_;  // tangential velocities that a contact remembers
  const bool follows_;
  const double kept_;  // of what dashpots felt one step ago (dashpot_relaxation.h)
  PlanarBodyStates& bodies_;
  const PlanarNeighbours& neighbours_;
  PlanarBlocks& blocks_;
  PlanarEvents& events_;
  const PlanarKernel& kernel_;
  AlignedVector<PlanarLawConstants> laws_;  // of each pair of types
  AlignedVector<PlanarWallLine> wall_lines_;
  long step_ = 0;  // the step that is evaluated
  long general_contacts_ = 0;

  // Memory that the SIMD loop works in.
  struct ForceWorkspace {
    std::vector<PlanarGeneralBlock> general;
    std::vector<int> awake, awake_jumped;
  };
  ForceWorkspace work_;
};

}  // namespace rodpack

#endif
