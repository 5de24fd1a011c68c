// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_SCENE_H
#define RODPACK_PLANAR_SCENE_H

#include <memory>
#include <vector>

#include "instructions.h"
#include "../contact/event_correction.h"
#include "../contact/planar_history.h"
#include "../motion/rigid_motion.h"

namespace rodpack {

class PlanarRanks;

// The planar engine: a planar packing of rigid chains of spheres between straight walls, advanced
// by Adams-Bashforth or leapfrog steps with the contact law of contact_law.h, at three degrees of
// freedom per body. SI units throughout.

/// Contact constants of two types.
struct PlanarLaw {
  double kn, kt;        // stiffness of the contact, N/m, > 0
  double eta_n, eta_t;  // damping ratios, 0 <= eta < 1
  double friction;      // mu >= 0
};

/// A wall x = position (axis 0) or y = position (axis 1), of infinite mass.
struct PlanarWall {
  int axis;
  double position;
  int type;
  /// 1 or -1: it pushes to that side of the axis, however deep a sphere is; 0: to the side where
  /// the sphere's centre is.
  int free_side = 0;
  /// Side on which a centre at this distance along the axis is pushed.
  int side_of(double distance) const {
    return free_side != 0 ? free_side : distance > 0.0 ? 1 : -1;
  }
};

struct PlanarSettings {
  double dt;
  int order = 3;  // 1..4; 0: leapfrog (rigid_motion.h)
  /// Tangential velocities that a contact remembers, order .. 4; friction looks back up to three
  /// steps where there are so many.
  int slots = 3;
  bool events = true;  // correct for the events of contacts (force_change.h); ignored below order 2
  /// Friction up to mu times the whole normal force, dashpot included, in place of mu k_n times the
  /// overlap (friction_cap.h).
  bool total_force_cap = false;
  double mass_scaling = 0.0;        // S of mass_scaling.h, >= 1; 0: none
  double dashpot_relaxation = 0.0;  // tau of dashpot_relaxation.h, s; 0: none; order 0 alone
  double gravity[2] = {0.0, 0.0};
  int types = 1;
  std::vector<PlanarLaw> laws;  // types x types, row by row, symmetric
  std::vector<PlanarWall> walls;
  /// The neighbour list of a body is made anew before a point of it has moved by the body's skin:
  /// its displacement in `skin_steps` steps at its present speed, within [min_skin, max_skin] (m).
  /// The end of a contact is not corrected if the spheres part by more than both skins in a step.
  double skin_steps = 80.0, min_skin = 1e-4, max_skin = 1e-3;
  /// With several ranks: a run ends before a point of a body has gone this far along x or y, m.
  double farthest[2] = {1e300, 1e300};
  PlanarInstructions instructions = PlanarInstructions::automatic;
};

struct PlanarSphere {
  double x, y;  // of its centre in the frame of the body, origin in the centre of mass, m
  int tag = 0;  // by which the caller knows it
};

/// A body between two steps. Vectors of three have x, y and the rotation about z.
struct PlanarBody {
  int tag = -1;                       // >= 0, the same on all ranks; -1: its index
  int type = 0;                       // 0 .. types-1
  double mass = 0.0, moment = 0.0;    // kg; kg m^2 about the centre of mass
  bool prescribed = false;            // no force changes its velocities; to others it is as a wall
  double radius = 0.0;                // of all its spheres
  std::vector<PlanarSphere> spheres;  // at most 65535
  double position[2] = {0.0, 0.0};
  double cosine = 1.0, sine = 0.0;
  double velocity[3] = {0.0, 0.0, 0.0};
  double load[3] = {0.0, 0.0, 0.0};  // force and torque of the last evaluation, gravity included
  double contact_weight = 0.0;  // of its contacts then (mass_scaling.h); 0 without mass scaling
  /// Evaluations of its forces since its birth, at most order + 1; 0: it has not moved yet, and its
  /// past follows from its load.
  int evaluations = 0;
  PlanarRates past[max_multistep_order - 1] = {};  // past[k]: k + 1 steps back
  // The motion that events in the last step have found to be missing, and that the next step adds.
  double missed_displacement[3] = {0.0, 0.0, 0.0};
  double missed_velocity[3] = {0.0, 0.0, 0.0};
  bool jumped = false;  // whether an event let its acceleration jump in the last step; then:
  PlanarJump jump = {};
};

/// A contact that was evaluated in the last step, and its history.
struct PlanarContactState {
  int body_i, sphere_i;
  int body_j, sphere_j;  // a wall: -1 - its index, and 0
  PlanarHistory history;
  // Set by contacts(), ignored by set_contacts():
  struct Constants {
    double kn, kt;          // stiffnesses, N/m
    double gamman, gammat;  // dashpots, kg/s
    double friction;        // mu k_n (N/m) or, under the cap of the whole normal force, mu
  } constants;
  double normal[2];  // from j to i, unit length
};

class PlanarScene {
 public:
  /// With `ranks`, which have to outlive it: the part of the scene that one rank has. The
  /// constructor, evaluate() and run() are collective then; each body is given to one rank, with a
  /// tag. Runs fastest if bodies that are near each other are near each other in `bodies`
  /// (order_by_place()).
  /// @throws std::invalid_argument naming a value that is out of range.
  PlanarScene(const PlanarSettings& settings, const std::vector<PlanarBody>& bodies,
              PlanarRanks* ranks = nullptr);
  ~PlanarScene();

  /// Sets the contacts and their histories, for forces that were evaluated elsewhere; before the
  /// first step. @throws std::invalid_argument for one whose spheres are not close or not there.
  void set_contacts(const std::vector<PlanarContactState>& contacts);
  std::vector<PlanarContactState> contacts() const;

  /// Evaluates the forces at the present positions, where each contact is a new one.
  void evaluate();
  /// Advances by `steps` steps, or by fewer if a body has gone too far for its rank; returns how
  /// many. Forces must be known: loads that were given, or evaluate().
  /// @throws std::runtime_error naming a body whose contacts with other ranks may have been missed
  long run(long steps);

  int size() const;
  PlanarBody body(int index) const;  // 0 .. size()-1
  /// Ghosts, copies of other ranks' bodies, have the indices from size() on, in contacts too. One
  /// that is out of use has 0 spheres.
  int size_with_ghosts() const;
  int spheres(int body) const;
  int sphere_tag(int body, int sphere) const;

  struct Statistics {
    long steps, listings;  // steps, and neighbour lists of single bodies that were made anew
    long general;          // contact evaluations on the general path
    long ghosts, sent;     // ghosts brought to a step, and bytes sent for that
    int blocks;            // blocks of candidate pairs at present
  };
  Statistics statistics() const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace rodpack

#endif
