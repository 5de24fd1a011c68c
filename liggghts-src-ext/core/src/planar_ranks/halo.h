// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_HALO_H
#define RODPACK_PLANAR_HALO_H

#include <vector>

#include "rodpack/planar/ranks.h"
#include "rodpack/planar/scene.h"

namespace rodpack {

class PlanarBodyStates;
class PlanarDependencies;
class PlanarEvents;
class PlanarGhosts;

/// Keeps ghosts, copies of other ranks' bodies, behind the bodies of a rank: all that an own body
/// may touch before ghosts are chosen anew. A contact with a ghost is evaluated on both ranks, from
/// the same numbers in the same order, so that its history is the same on both.
///
/// Ghosts are chosen by the box around the own bodies, widened by the reach of both bodies and by
/// the distance that two of them may go meanwhile. When a body has gone most of that distance,
/// all ranks choose anew. That is asked after as many steps as the fastest point of all bodies
/// needs at least, at twice its speed.
class PlanarHalo {
 public:
  /// Collective, as renew() and update() are. All that is given has to outlive it.
  /// @param longest_reach  of the bodies of all ranks, m
  PlanarHalo(PlanarRanks& ranks, const PlanarSettings& settings, double longest_reach,
             const PlanarBodyStates& bodies, PlanarEvents& events, PlanarGhosts& ghosts);

  /// Chooses the ghosts, and brings all of them to this step; once before the first update().
  /// Ghosts that have to be listed anew are appended to `to_list`.
  void renew(std::vector<int>& to_list);

  /// After the bodies have moved: brings ghosts to this step, or chooses them anew, and returns
  /// whether it did. Ghosts that have to be listed anew are appended to `to_list`.
  /// @throws std::runtime_error naming a body that went farther than it could have been followed
  bool update(std::vector<int>& to_list);

  /// The number of updates before the next one that may choose the ghosts anew, for which all
  /// bodies have to be at the same step. The same on all ranks.
  int quiet_updates() const { return patience_ > 1 ? patience_ - 1 : 0; }

  /// Lets the parts of the own bodies that are sent wait for the last part, with which they are.
  void hold_back_sent(PlanarDependencies& dependencies) const;

  /// Throws as update() if a contact may have been missed so far; not collective.
  void check() const { checked_distance(); }

  /// Whether a body has gone nearly as far as settings.farthest since the scene began.
  bool far_away() const { return far_away_; }

  /// The number of ghosts that were brought to a step, in all.
  long ghosts_brought() const { return ghosts_brought_; }
  /// The bytes that were sent for that, in all.
  long bytes_sent() const { return bytes_sent_; }

 private:
  struct Pose {
    double x, y, cosine, sine;
  };
  /// The own bodies that are sent to a rank, and the ghosts that come from it.
  struct Partner {
    std::vector<int> sent, received;
  };

  std::vector<Pose> own_poses() const;
  double checked_distance() const;
  bool ask();
  double distance_left(int body) const;
  std::vector<std::vector<double>> choose(std::vector<std::vector<int>>& chosen) const;
  std::vector<std::vector<int>> receive(const std::vector<std::vector<double>>& messages,
                                        std::vector<int>& to_list);
  void connect(const std::vector<std::vector<int>>& chosen,
               const std::vector<std::vector<int>>& ghosts);
  void pack(const Partner& partner, PlanarLink& link) const;
  void unpack(const Partner& partner, const PlanarLink& link, std::vector<int>& to_list);

  PlanarRanks& ranks_;
  const PlanarSettings& settings_;
  const PlanarBodyStates& bodies_;
  PlanarEvents& events_;
  PlanarGhosts& ghosts_;
  const double reserve_;   // distance that each body may go before ghosts are chosen anew, m
  const bool is_limited_;  // bodies may not go anywhere
  int patience_ = 0;       // steps until the next question
  bool far_away_ = false;
  std::vector<Pose> begun_, chosen_at_;  // of own bodies at first, and when ghosts were chosen
  std::vector<PlanarLink> links_;
  std::vector<Partner> partners_;  // of each link
  long ghosts_brought_ = 0, bytes_sent_ = 0;
};

}  // namespace rodpack

#endif
