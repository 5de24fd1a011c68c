// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_NEIGHBOURS_H
#define RODPACK_PLANAR_NEIGHBOURS_H

#include <vector>

#include "../planar_simd/aligned_vector.h"
#include "candidates.h"
#include "../planar_simd/arguments.h"
#include "frames.h"
#include "grid.h"
#include "../planar/lane_state.h"
#include "../planar/pipeline.h"

namespace rodpack {

class PlanarBlocks;
class PlanarBodyStates;

/// Neighbour lists of single bodies. A body is listed anew when a point of it has moved by its skin
/// since it was listed last, at its reference position. Two spheres are candidates for a contact if
/// they come closer than the skins of both bodies allow, measured between the reference positions;
/// so that no body has to be listed because another one moved. Candidates go into blocks.
///
/// Reference positions move with frames (PlanarFrames), and the motion of a body is measured from
/// there, with the strain between frames added. Frames of cells that are not next to each other may
/// move as they like: bodies of such cells are too far apart to touch, and on their way to each
/// other they pass through cells that are.
class PlanarNeighbours {
 public:
  /// All that is given has to outlive the lists, which change `blocks` and `dependencies`.
  PlanarNeighbours(const PlanarSettings& settings, const PlanarBodyStates& bodies,
                   const PlanarParts& parts, PlanarBlocks& blocks,
                   PlanarDependencies& dependencies);

  /// Makes room for so many bodies, ghosts too.
  void resize(int bodies);
  /// Sets the reach of the longest body of all ranks, m; before list_all().
  void set_longest_reach(double reach) { longest_reach_ = reach; }

  bool exist() const { return exist_; }
  /// Makes the first lists of all bodies.
  void list_all();
  /// Makes the lists of these bodies anew; their contacts keep their history.
  void list_anew(const std::vector<int>& bodies);

  /// Takes in a new ghost; it has to be listed with list_anew() if lists exist already.
  void add_ghost(int ghost);
  void remove_ghost(int ghost);
  /// Notes how far a ghost has moved in a step, before which it was at `before`; returns whether it
  /// has to be listed anew.
  bool follow_ghost(int ghost, const PlanarKinematics& before);

  /// The number of steps in which no body moves by more than its skin, at least 1.
  int steps_within_skins() const { return steps_within_skins_; }
  /// Lets steps_within_skins() forget the bodies that were not listed since the last call.
  void renew_steps_within_skins();

  /// Begins a pass of up to `most` steps, for which frames are renewed if they are too old; returns
  /// how many it may have.
  int begin_pass(int most);
  /// What follows is about the time so many steps after the pass has begun.
  void look_at(int step) { step_ = begun_ + step; }
  /// Sets what the SIMD loop needs to find the bodies that have left their skin, or will in
  /// `steps_ahead` further steps.
  void set_arguments(int steps_ahead, PlanarAdvanceArguments& arguments);
  /// Notes a displacement (m, m, rad) of a body beside that of its step.
  void add_path(int body, const double* displacement);
  /// Upper bounds on how far each body is from where it was listed, in its frame, m.
  const double* moved() const { return moved_.data(); }
  /// Upper bounds on the path on which each body has gone there, m.
  const double* travelled() const { return travelled_.data(); }
  /// The number of lists of single bodies that were made anew.
  long listings() const { return listings_; }

 private:
  void set_reference(int body);
  void set_lanes(int body, double strain, double strain_step);
  PlanarReference reference(int body) const;
  void renew_frames();
  void move_references();
  void list(int body);
  void find_near(int body, int end);
  void list_near(int body, int end);
  void list_pair(int i, int j, int other);
  void list_walls(int i);
  /// A block of the body that is being listed, and the other body or wall in it.
  struct ListedBlock {
    int other, place;
    int earlier;  // in the list: the one before it with the same other, -1: none
  };
  /// The last block in the list with `other`, a body or -1 - a wall; -1: none.
  int& newest_listed(int other) { return work_.newest[settings_.walls.size() + other]; }
  void set_blocks(int i, int j, int other);
  bool renew_gaps(int j);
  PlanarChain chain(int body) const;
  void add_blocks(int i, int j);
  struct Coefficients {  // of the contacts of a block
    int law;             // index of the constants of both types
    double gamma[2];     // dashpots along the normal and the tangent, kg/s
  };
  Coefficients coefficients(int i, int j) const;

  const PlanarSettings& settings_;
  const PlanarBodyStates& bodies_;
  const PlanarParts parts_;
  PlanarBlocks& blocks_;
  PlanarDependencies& dependencies_;
  bool exist_ = false;
  double longest_reach_ = 0.0;
  int steps_within_skins_ = most_steps_in_pass;
  int steps_of_listed_ = most_steps_in_pass;  // of the bodies listed since the last renewal
  long listings_ = 0;
  PlanarGrid grid_;
  PlanarFrames frames_;
  // Counted from the step in which frames were renewed the last time: that in which the pass has
  // begun, and that which is looked at.
  int begun_ = 0, step_ = 0;
  // Where a body's reference position was when frames were renewed, and how it moves in a step.
  struct alignas(64) MovingReference {
    PlanarReference at;
    double step_x, step_y;
  };
  AlignedVector<MovingReference> references_;
  AlignedVector<PlanarReferenceLanes> reference_lanes_;
  AlignedVector<double> moved_, travelled_;

  // Memory that listing works in.
  struct ListingWorkspace {
    std::vector<int> leaving;                 // bodies that are about to leave their skins
    std::vector<int> near;                    // bodies that may have candidates with one
    std::vector<PlanarCandidate> candidates;  // of two bodies
    std::vector<ListedBlock> blocks;          // of a body
    std::vector<int> newest;                  // of these, by body; none has been looked at yet
    std::vector<int> of_pair;                 // places of those of two bodies
    std::vector<double> gaps;                 // of these
    std::vector<double> gap_of;               // of two spheres, if they are candidates
    std::vector<PlanarLaneState> contacts;    // of two bodies whose blocks are made anew
  };
  ListingWorkspace work_;
};

}  // namespace rodpack

#endif
