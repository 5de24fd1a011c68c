// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_SCENE_DATA_H
#define RODPACK_PLANAR_SCENE_DATA_H

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "aligned_vector.h"
#include "blocks.h"
#include "contact.h"
#include "events.h"
#include "forces.h"
#include "rodpack/planar/scene.h"
#include "rodpack/contact/tangential_history.h"

namespace rodpack {

/// What is constant about a body.
struct PlanarBodyInfo {
  int type;
  double mass, moment, radius;
  int first, count;  // of its spheres
};

/// Chains of bodies in a grid of cells, by the positions at which they were listed.
class PlanarGrid {
 public:
  void build(const AlignedVector<PlanarListed>& bodies, double cell);
  void move(int body, double x, double y);
  void add(int body, double x, double y);
  void remove(int body);
  /// Calls visit(other) for all bodies of the cells around that of (x, y).
  template <class Visit>
  void around(double x, double y, Visit visit) const {
    const int cx = column(x), cy = row(y);
    for (int iy = cy > 0 ? cy - 1 : 0; iy <= cy + 1 && iy < ny_; ++iy)
      for (int ix = cx > 0 ? cx - 1 : 0; ix <= cx + 1 && ix < nx_; ++ix)
        for (int body = head_[iy * nx_ + ix]; body >= 0; body = next_[body]) visit(body);
  }

 private:
  // Bodies beyond the edge go into the cells of the edge, which keeps neighbours neighbours.
  static int clamped(double place, int count) {
    return place > 0.0 ? (place < count ? static_cast<int>(place) : count - 1) : 0;
  }
  int column(double x) const { return clamped((x - x0_) * inverse_, nx_); }
  int row(double y) const { return clamped((y - y0_) * inverse_, ny_); }
  void link(int body, int cell);
  void unlink(int body);

  double x0_ = 0.0, y0_ = 0.0, inverse_ = 1.0;
  int nx_ = 1, ny_ = 1;
  std::vector<int> head_, next_, previous_, cell_;
};

class PlanarHalo;

constexpr int steps_in_sweep = 8;  // at most
/// What is found next to a body when it is listed anew may be some steps ahead of it, and must not
/// touch it before. So a body is listed when it is about to leave its skin in what is left of the
/// sweep, and this much before, for what the forces of these steps may add.
constexpr double before_its_skin = 0.98;

struct PlanarScene::Data {
  Data(const PlanarSettings& settings, const std::vector<PlanarBody>& bodies);
  ~Data();

  // planar_sweep.cpp
  void sweep(int steps);
  void step(int stage);
  void move(int part, int steps_ahead);
  PlanarMotions motions();
  void make_missed_motion(int body);
  void fill_past(int body);
  void apply_events(int part);
  void begin_forces();
  // planar_scene.cpp
  void set_reach(int body);
  void resize(int bodies);
  /// Whether i is the first of the two in a block, on every rank.
  bool comes_first(int i, int j) const { return tags[i] < tags[j]; }
  // planar_lists.cpp
  void make_lists();  // if there are none yet
  void list_all();    // without an order of blocks
  void mark_listed(int body);
  void renew_lists();
  void list(int body);
  void list_near(int body, int end);
  void list_pair(int i, int j);
  void list_walls(int i);
  double way_in_step(int body) const;
  struct Coefficients {  // of a block
    int law;
    double gamma[2];
  };
  Coefficients coefficients(int i, int j) const;
  /// Two spheres that may touch, and the gap between them where their bodies were listed (m).
  struct Candidate {
    double gap;
    int sphere_i, sphere_j;
  };
  void add_blocks(PlanarBlockPool& pool, int i, int j, std::vector<Candidate>& candidates);
  // planar_blocks.cpp
  void sort_blocks();
  void completes(const PlanarBlockHead& head, int part);
  // planar_forces.cpp
  void evaluate_forces(int part);
  PlanarForces forces_of(PlanarBlockPool& pool, int part);
  void evaluate_general(PlanarBlockPool& pool, int entries);
  void evaluate_lane(PlanarBlockPool& pool, int place, int lane);
  bool outlast_jump(PlanarBlockPool& pool, int place, int lane, const PlanarContact& contact);
  bool place_lane(const PlanarBlockPool& pool, int place, int lane, PlanarContact& contact) const;
  void apply(const PlanarContact& contact, double normal, const double (&tangential)[3]);

  /// Place in past_velocity and past_acceleration of the rates k + 1 steps back, a ring.
  int past(int k) const {
    const int count = settings.order - 1;
    return static_cast<int>((k - now % count + count) % count);
  }
  TangentialStep tangential_step() const { return {settings.order, now, settings.dt}; }
  /// Past the start-up, and all that events may look at is known.
  int full_count() const { return slots + 1; }

  PlanarSettings settings;
  int slots;     // tangential velocities that a contact keeps
  long now = 0;  // number of the step that is evaluated
  bool lists_exist = false;
  double longest = 0.0;  // reach of all bodies, of other ranks too
  int owned = 0;         // bodies of this rank; ghosts follow them
  PlanarParts parts;
  std::vector<int> completed_by;  // part with the last of the blocks of each part's bodies
  int made[steps_in_sweep];       // parts that each step of a sweep, its stage, has made
  int steps_of_sweep = 1;         // of this one
  // Steps in which no body goes its skin: at present, and of those listed since blocks were sorted.
  int longest_sweep = steps_in_sweep, next_longest_sweep = steps_in_sweep;
  std::unique_ptr<PlanarHalo> halo;
  PlanarKernel kernel;

  AlignedVector<PlanarFrame> frames;
  AlignedVector<PlanarVector> loads;
  AlignedVector<PlanarVector> inertia;  // 1/mass, 1/mass, 1/moment, mass
  AlignedVector<PlanarVector> past_velocity[max_multistep_order - 1];
  AlignedVector<PlanarVector> past_acceleration[max_multistep_order - 1];
  std::vector<std::int8_t> evaluations;
  AlignedVector<PlanarVector> missed_displacement, missed_velocity;
  std::vector<std::vector<int>> missed;   // bodies of each part with missed motion
  std::vector<std::vector<int>> newborn;  // without an evaluation yet
  std::vector<PlanarBodyInfo> info;
  std::vector<int> tags;
  std::vector<PlanarSphere> spheres;
  AlignedVector<PlanarListed> listed;
  AlignedVector<PlanarListedLanes> listed_lanes;
  AlignedVector<double> moved;  // since a body was listed, at most, m
  std::vector<PlanarLawConstants> laws;
  AlignedVector<PlanarWallLine> wall_lines;

  PlanarBlockPool pairs, at_walls;
  PlanarGrid grid;
  std::vector<int> to_list, near;
  using Placed = std::pair<std::uint64_t, int>;  // of a block: place in the order, present place
  std::vector<Placed> in_order;
  std::vector<int> order;
  std::vector<PlanarGeneral> general;
  std::vector<int> awake;  // blocks
  struct Saved {           // contacts of a body while it is listed anew
    int i, j;
    std::uint16_t sphere_i, sphere_j;
    bool sliding, mature, fresh;
    std::int8_t count;
    double spring, velocity[max_multistep_order], uncut, touch_rate, since;
  };
  std::vector<Saved> saved;

  PlanarEvents events;
  bool follows;  // events
  PlanarScene::Statistics statistics = {};
};

/// Moves a contact between a lane and a record of its own. `turned`: as after the next turn of the
/// velocities.
void save_lane(const PlanarBlockPool& pool, int place, int lane, PlanarScene::Data::Saved& saved);
void restore_lane(PlanarBlockPool& pool, int place, int lane, const PlanarScene::Data::Saved& saved,
                  bool turned = false);
void clear_lane(PlanarBlockPool& pool, int place, int lane);

}  // namespace rodpack

#endif
