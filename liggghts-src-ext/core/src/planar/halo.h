// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_HALO_H
#define RODPACK_PLANAR_HALO_H

#include <unordered_map>
#include <vector>

#include "rodpack/planar/ranks.h"
#include "scene_data.h"

namespace rodpack {

/// Keeps copies of other ranks' bodies behind the own ones of a scene, its ghosts: all that an own
/// body may touch before they are chosen anew. A contact with a ghost is evaluated on both ranks,
/// from the same numbers in the same order, so that its history is the same on both.
///
/// Ghosts are chosen by the box around the own bodies, widened by the reach of both bodies and by
/// the way that two of them may go meanwhile. When somebody has gone most of that way, all ranks
/// choose anew. That is asked after as many steps as the fastest point of all bodies needs at
/// least, at twice its speed.
class PlanarHalo {
 public:
  /// Collective; chooses the ghosts.
  PlanarHalo(PlanarRanks& ranks, PlanarScene::Data& scene);

  /// After the integration: brings ghosts to this step, and lists those that have moved.
  /// @throws std::runtime_error naming a body that went farther than it could have been followed
  void update(PlanarScene::Data& scene);

  /// Updates before the next one that may choose the ghosts anew: where all bodies have to be at
  /// the same step. The same on all ranks.
  int quiet_updates() const { return patience_ > 1 ? patience_ - 1 : 0; }

  /// Lets the parts of the own bodies that are sent wait for the last one, in which they are.
  void hold_back_sent(PlanarScene::Data& scene) const;

  /// Whether no contact can have been missed so far; not collective.
  /// @throws as update()
  void check(const PlanarScene::Data& scene) const { checked_way(scene); }

  /// Whether a body has gone nearly settings.farthest since the scene began.
  bool far_away() const { return far_away_; }

 private:
  struct Place {
    double x, y, cosine, sine;
  };
  /// What is sent to a rank and what comes from it: own bodies, ghosts.
  struct Partner {
    std::vector<int> sent, received;
  };

  double checked_way(const PlanarScene::Data& scene) const;
  bool ask(const PlanarScene::Data& scene);
  double room(const PlanarScene::Data& scene, int body) const;
  void renew(PlanarScene::Data& scene);
  std::vector<std::vector<double>> choose(PlanarScene::Data& scene,
                                          std::vector<std::vector<int>>& chosen);
  void receive(PlanarScene::Data& scene, const std::vector<std::vector<double>>& records);
  void drop(PlanarScene::Data& scene, int ghost);
  int place_for_ghost(PlanarScene::Data& scene);
  void connect(const std::vector<std::vector<int>>& chosen,
               const std::vector<std::vector<int>>& ghosts);
  void pack(const PlanarScene::Data& scene, const Partner& partner, PlanarLink& link) const;
  void unpack(PlanarScene::Data& scene, const Partner& partner, const PlanarLink& link) const;
  void list_if_moved(PlanarScene::Data& scene, int ghost) const;

  PlanarRanks& ranks_;
  double way_;        // that each body may go before ghosts are chosen anew, m
  int patience_ = 0;  // steps until the next question
  bool is_limited_;   // bodies may not go anywhere
  bool far_away_ = false;
  std::vector<Place> renewed_, begun_;  // own bodies when ghosts were chosen, and at first
  std::vector<PlanarLink> links_;
  std::vector<Partner> partners_;  // of each link
  std::unordered_map<int, int> ghost_of_tag_;
  std::vector<int> unused_;  // places of ghosts
};

}  // namespace rodpack

#endif
