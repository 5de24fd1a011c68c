// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_SCENE_H
#define RODPACK_PLANAR_SCENE_H

#include <memory>
#include <vector>

#include "instructions.h"
#include "../contact/event_correction.h"
#include "../motion/rigid_motion.h"

namespace rodpack {

class PlanarRanks;

// A planar packing of rigid chains of spheres between straight walls, advanced by Adams-Bashforth
// steps with the contact law of contact_law.h: the physics of the sphere-level styles
// multisphere/ab and spring_dashpot at three degrees of freedom per body. SI units throughout.

/// Contact constants of a pair of types, as property/global peratomtypepair has them.
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
  /// 1 or -1: it pushes to that side of the axis, however deep a sphere is; 0: to the side of the
  /// sphere's centre.
  int free_side = 0;
  /// Side on which a centre at this distance along the axis is pushed.
  int side_of(double distance) const {
    return free_side != 0 ? free_side : distance > 0.0 ? 1 : -1;
  }
};

struct PlanarSettings {
  double dt;
  int order = 3;  // 1..4
  /// Tangential velocities that a contact remembers, order .. 4: multistepOrder of the styles,
  /// whose friction looks back up to three steps where there are so many.
  int remembered = 3;
  bool events = true;  // follow the events of contacts (force_change.h); ignored at order 1
  double gravity[2] = {0.0, 0.0};
  int types = 1;
  std::vector<PlanarLaw> laws;  // types x types, row by row, symmetric
  std::vector<PlanarWall> walls;
  /// A body is listed anew before a point of it has moved by its skin: the way it goes in
  /// `skin_steps` steps at its present speed, within [min_skin, max_skin]. Contacts that part by
  /// more than both skins in a step lose the correction of their end: see close_factor.
  double skin_steps = 80.0, min_skin = 1e-4, max_skin = 1e-3;
  /// Pairs that part are followed in a step up to this times the sum of the radii, as LIGGGHTS's
  /// contact distance factor: what parts faster loses the correction of its end.
  double close_factor = 1.02;
  /// With several ranks: a run ends before a point of a body has gone this far along x or y, m.
  double farthest[2] = {1e300, 1e300};
  PlanarInstructions instructions = PlanarInstructions::automatic;
};

struct PlanarSphere {
  double x, y;  // of its centre in the frame of the body, origin in the centre of mass
  int tag = 0;  // by which the caller knows it
};

typedef PlanarJump PlanarMotionChange;

/// A body between two steps. Vectors of three: x, y and rotation about z.
struct PlanarBody {
  int tag = -1;                       // >= 0, the same on all ranks; -1: its index
  int type = 0;                       // 0 .. types-1
  double mass = 0.0, moment = 0.0;    // kg; kg m^2 about the centre of mass
  double radius = 0.0;                // of all its spheres
  std::vector<PlanarSphere> spheres;  // at most 65535
  double position[2] = {0.0, 0.0};
  double cosine = 1.0, sine = 0.0;
  double velocity[3] = {0.0, 0.0, 0.0};
  double load[3] = {0.0, 0.0, 0.0};  // force and torque of the last evaluation, gravity included
  /// Evaluations of the forces since birth, capped at order + 1; 0: at birth.
  int evaluations = 0;
  PlanarRates past[max_multistep_order - 1] = {};   // past[k]: k + 1 steps back
  double missed_displacement[3] = {0.0, 0.0, 0.0};  // of events in the last step, not yet made
  double missed_velocity[3] = {0.0, 0.0, 0.0};
  bool jumped = false;  // in the last step; then:
  PlanarMotionChange change = {};
};

/// A contact that was evaluated in the last step. Scalars along the tangent z x n, n from j to i.
struct PlanarContactState {
  int body_i, sphere_i;
  int body_j, sphere_j;                  // a wall: -1 - its index, and 0
  double spring;                         // m
  double velocity[max_multistep_order];  // of the last steps, newest first, m/s
  int count;                 // velocities known, at most order + 1; negative while sliding
  double since;              // time from touch to the end of its step, s
  double uncut, touch_rate;  // as in NormalHistory
  bool fresh;
  // those of contacts():
  double constants[3];  // mu k_n (N/m), k_t (N/m), tangential dashpot (kg/s)
  double normal[2];     // from j to i, unit length
};

class PlanarScene {
 public:
  /// With `ranks`, which have to outlive it: the part of one rank, collective as evaluate() and
  /// run() then are; each body is given to one rank, with a tag. Runs fastest if bodies that are
  /// near each other are near in `bodies` too, all of them (order_by_place()).
  /// @throws std::invalid_argument naming a value that is out of range.
  PlanarScene(const PlanarSettings& settings, const std::vector<PlanarBody>& bodies,
              PlanarRanks* ranks = nullptr);
  ~PlanarScene();

  /// The contacts at present, for forces that were evaluated elsewhere; before the first step.
  /// @throws std::invalid_argument for one whose spheres are not close.
  void set_contacts(const std::vector<PlanarContactState>& contacts);
  std::vector<PlanarContactState> contacts() const;

  /// Evaluates the forces at the present positions, as the first evaluation of new contacts.
  void evaluate();
  /// Advances by `steps` steps, or by fewer if a body has gone too far for its rank; returns how
  /// many. Forces must be known: loads that were given, or evaluate().
  /// @throws std::runtime_error naming a body whose contacts with other ranks may have been missed
  long run(long steps);

  int size() const;
  PlanarBody body(int index) const;  // 0 .. size()-1
  /// Copies of other ranks' bodies have the indices from size() on, in contacts too; of those that
  /// are in use here: 0 spheres otherwise.
  int size_with_ghosts() const;
  int spheres(int body) const;
  int sphere_tag(int body, int sphere) const;

  struct Statistics {
    long steps, listings;  // steps, and listings of single bodies
    long general;          // of all steps: sphere pairs in contact on the general path
    long ghosts, sent;     // of all steps: ghosts brought to it, and bytes sent for that
    int blocks;            // of candidate pairs at present
  };
  Statistics statistics() const;

  struct Data;  // for the sources of the engine

 private:
  std::unique_ptr<Data> data_;
};

}  // namespace rodpack

#endif
