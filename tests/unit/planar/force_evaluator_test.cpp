// SPDX-License-Identifier: GPL-2.0-or-later
// The ways of one contact through the force evaluator: the fast path, with and without a jump of
// its bodies in the step before, and the general path. Where both know a contact they have to
// agree.
#include "planar/force_evaluator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "heap.h"
#include "planar/bodies.h"
#include "planar_lists/neighbours.h"

namespace rodpack {
namespace {

const int slots = 3;
const double overlap = 2e-5;

/// Contacts to which nothing happens: stuck far below the cap, or sliding on.
enum Branch { stuck, sliding };

/// Two parallel rods side by side, the lower one on the floor, both turned and in motion a little,
/// with contacts that last: the spheres of rods that lie face to face, and those at the floor.
struct Contacts {
  PlanarSettings settings;
  PlanarParts parts = {2, 4};
  PlanarKernel kernel;
  PlanarBodyStates bodies;
  PlanarBlocks blocks;
  PlanarEvents events = PlanarEvents(parts);
  PlanarDependencies dependencies = PlanarDependencies(parts);
  PlanarNeighbours neighbours = {settings, bodies, parts, blocks, dependencies};
  PlanarForceEvaluator evaluator = {settings, kernel, bodies, neighbours, blocks, events};

  static PlanarSettings settings_for(int order, PlanarInstructions instructions, bool total_cap) {
    PlanarSettings settings = settings_of();
    settings.order = order;
    if (order == 0) settings.dashpot_relaxation = 1.5 * settings.dt;
    settings.total_force_cap = total_cap;
    settings.instructions = instructions;
    settings.walls = {{1, 0.0, 0}};
    return settings;
  }
  static std::vector<PlanarBody> rods(Branch branch) {
    const double slip = branch == stuck ? 1e-3 : 0.2;
    const double y = 0.5 * diameter - overlap;
    return {moving(rod(5, 0, y, 1e-4), 0.5 * slip, -2e-3, 0.1),
            moving(rod(5, 1e-6, y + diameter - overlap, -2e-4), 2 * slip, 1e-3, -0.2)};
  }

  Contacts(Branch branch, int order, PlanarInstructions instructions, bool total_cap)
      : settings(settings_for(order, instructions, total_cap)),
        kernel(planar_kernel(instructions, total_cap)),
        bodies(settings, parts, rods(branch)),
        blocks(2, slots, {total_cap, settings.dashpot_relaxation > 0.0}) {
    events.resize(2);
    neighbours.set_longest_reach(bodies.longest_reach());
    neighbours.list_all();
    for (PlanarBlockPool* pool : {&blocks.pairs(), &blocks.at_walls()}) fill(*pool, branch);
    blocks.sort(parts, dependencies);
    bodies.begin_loads();
  }

  /// Gives every sphere pair that overlaps another history of its branch.
  void fill(PlanarBlockPool& pool, Branch branch) {
    for (int place = 0; place < pool.size(); ++place)
      for (int lane = 0; lane < planar_lanes; ++lane) {
        if (!(pool.head(place).used & 1 << lane)) continue;
        PlanarLaneState state;
        pool.save(place, lane, state);
        if (pool.head(place).j >= 0 && state.sphere_i != state.sphere_j) continue;
        PlanarHistory& history = state.history;
        const double other = 1.0 + 0.1 * state.sphere_i, cap = paper.friction * paper.kn * overlap;
        // Along z x n, with the normal n from j to i: the lower rod, i of the pairs, stays behind
        // the upper one along x, and slides on the floor along x; with n along -y and y.
        const double direction = -1.0;
        history.known = evaluator.full_count();
        history.sliding = branch == sliding;
        history.spring = direction * (branch == stuck ? 1e-7 * other : cap / paper.kt);
        for (int k = 0; k < slots; ++k)
          history.velocity[k] =
              direction * other * (branch == stuck ? 1e-3 : 0.1) * (1.0 + 0.01 * k);
        history.viscoelastic = paper.kn * overlap * other;
        if (settings.total_force_cap) history.earlier = 0.9 * history.viscoelastic;
        history.relaxes = settings.dashpot_relaxation > 0.0;
        history.felt_velocity = 1e-3 * other;
        state.full_history = true;
        pool.restore(place, lane, state);
      }
  }

  /// Lets the contacts of the rods have pulled with this force (N) when they were last evaluated.
  void pull(double force) {
    PlanarBlockPool& pool = blocks.pairs();
    for (int place = 0; place < pool.size(); ++place)
      for (int lane = 0; lane < planar_lanes; ++lane)
        if (pool.head(place).alive & 1 << lane)
          pool.mutable_values(place)[planar_viscoelastic + lane] = -force;
  }

  /// Leaves all contacts to the general path.
  void forget_full_history() {
    for (PlanarBlockPool* pool : {&blocks.pairs(), &blocks.at_walls()})
      for (int place = 0; place < pool->size(); ++place)
        for (int lane = 0; lane < planar_lanes; ++lane) {
          if (!(pool->head(place).alive & 1 << lane)) continue;
          PlanarLaneState state;
          pool->save(place, lane, state);
          state.full_history = false;
          pool->restore(place, lane, state);
        }
  }

  void evaluate() {
    for (int part = 0; part < parts.count(); ++part) evaluator.evaluate(part, 7);
    blocks.age(1);
  }

  std::size_t count() const { return blocks.pairs().contacts() + blocks.at_walls().contacts(); }
};

/// To 1e-12 of `scale`.
void expect_near(double a, double b, double scale, const char* what) {
  EXPECT_NEAR(a, b, 1e-12 * scale) << what;
}

/// `velocities`: how many of them matter.
void expect_same_lanes(const PlanarBlockPool& a, const PlanarBlockPool& b, int velocities,
                       Branch branch) {
  ASSERT_EQ(a.size(), b.size());
  for (int place = 0; place < a.size(); ++place)
    for (int lane = 0; lane < planar_lanes; ++lane) {
      PlanarLaneState state, other;
      a.save(place, lane, state);
      b.save(place, lane, other);
      ASSERT_EQ(a.head(place).alive, b.head(place).alive);
      if (!(a.head(place).alive & 1 << lane)) continue;
      EXPECT_TRUE(state.full_history && other.full_history);
      EXPECT_EQ(state.history.sliding, branch == sliding);
      EXPECT_EQ(other.history.sliding, branch == sliding);
      EXPECT_EQ(state.history.known, other.history.known);
      expect_near(state.history.spring, other.history.spring, overlap, "spring");
      for (int k = 0; k < velocities; ++k)
        expect_near(state.history.velocity[k], other.history.velocity[k], 1.0, "velocity");
      expect_near(state.history.viscoelastic, other.history.viscoelastic, 0.02, "normal force");
      expect_near(state.history.felt_velocity, other.history.felt_velocity, 1.0, "felt velocity");
      expect_near(state.history.earlier, other.history.earlier, 0.02, "earlier normal force");
    }
}

void expect_same_changes(const PlanarChangeSums& a, const PlanarChangeSums& b) {
  const double dt = paper_step;
  for (int d = 0; d < 3; ++d) {
    const double scale = d < 2 ? 0.1 : 0.1 * diameter;  // of the forces, N, and torques, N m
    expect_near(a.now.d[d], b.now.d[d], scale, "change");
    expect_near(a.rate.d[d], b.rate.d[d], scale / dt, "rate");
    expect_near(a.impulse.d[d], b.impulse.d[d], scale * dt, "impulse");
    expect_near(a.impulse_integral.d[d], b.impulse_integral.d[d], scale * dt * dt, "integral");
  }
}

/// Bodies whose forces have changed, none of which by a jump.
std::vector<int> changed_bodies(const PlanarEvents& events) {
  std::vector<int> bodies;
  events.each_changed(0, [&](int body, bool jumps) {
    EXPECT_FALSE(jumps);
    bodies.push_back(body);
  });
  return bodies;
}

void expect_same(const Contacts& a, const Contacts& b, Branch branch) {
  for (int body : {0, 1})
    for (int d = 0; d < 3; ++d)
      expect_near(a.bodies.state(body, 7).load[d], b.bodies.state(body, 7).load[d],
                  d < 2 ? 0.1 : 0.1 * diameter, "load");
  const int velocities = a.settings.order == 0 ? 1 : slots;
  expect_same_lanes(a.blocks.pairs(), b.blocks.pairs(), velocities, branch);
  expect_same_lanes(a.blocks.at_walls(), b.blocks.at_walls(), velocities, branch);
  const std::vector<int> changed = changed_bodies(a.events);
  ASSERT_EQ(changed, changed_bodies(b.events));
  for (const int body : changed)
    expect_same_changes(a.events.changes(body), b.events.changes(body));
}

}  // namespace

TEST(PlanarForceEvaluator, FastAndGeneralPathAgree) {
  for (const PlanarInstructions instructions : available_planar_instructions())
    for (const int order : {0, 1, 2, 3})
      for (const bool total_cap : {false, true})
        for (const Branch branch : {stuck, sliding}) {
          Contacts fast(branch, order, instructions, total_cap),
              general(branch, order, instructions, total_cap);
          ASSERT_EQ(fast.count(), 18u) << "nine spheres with each other and with the floor";
          general.forget_full_history();
          for (Contacts* contacts : {&fast, &general}) contacts->evaluate();
          EXPECT_EQ(fast.evaluator.general_contacts(), 0);
          EXPECT_EQ(general.evaluator.general_contacts(), 18);
          EXPECT_GT(std::fabs(fast.bodies.state(1, 7).load[0]), 1e-4);
          EXPECT_TRUE(changed_bodies(fast.events).empty());
          expect_same(fast, general, branch);
        }
}

// One rod, the other, or both have jumped in the step before. The fast path (kernel_jumps.h) does
// along normal and tangent what the general path does in space, also for the contacts of the lower
// rod with the floor. Slides under the cap of the whole normal force, which the dashpot changes,
// take the general path.
TEST(PlanarForceEvaluator, FastPathAfterAJumpAgreesWithTheGeneralOne) {
  for (const PlanarInstructions instructions : available_planar_instructions())
    for (const int order : {2, 3})
      for (const bool total_cap : {false, true})
        for (const Branch branch : {stuck, sliding})
          for (const int jumped : {1, 2, 3}) {  // a bit for each rod
            Contacts fast(branch, order, instructions, total_cap),
                general(branch, order, instructions, total_cap);
            general.forget_full_history();
            for (Contacts* contacts : {&fast, &general}) {
              for (const int body : {0, 1}) {
                const PlanarKinematics& of = contacts->bodies.kinematics(body);
                const double sign = body == 0 ? -0.7 : 1.0;
                if (jumped & 1 << body)
                  contacts->events.set_jumped(body, {{sign * 3, -2, sign * 200},
                                                     {sign * 1e-4, -2e-4, 0.01},
                                                     {1e-9, -sign * 2e-9, sign * 1e-7},
                                                     of.cosine,
                                                     of.sine});
              }
              contacts->evaluate();
            }
            // The lower rod, body 0, has nine contacts more, with the floor.
            const int touched = jumped == 2 ? 9 : 18;
            EXPECT_EQ(fast.evaluator.general_contacts(),
                      total_cap && branch == sliding ? touched : 0);
            EXPECT_EQ(general.evaluator.general_contacts(), 18);
            EXPECT_EQ(changed_bodies(fast.events).size(), 2u) << "the dashpots learn of the jump";
            expect_same(fast, general, branch);
          }
}

// At the last evaluation the contacts of the rods pulled a little, so that their normal force was
// cut off; had they known of the jump, they would have pushed, as they do now. The force has come
// back within the step, which is an event, whatever the jump has made of the record.
TEST(PlanarForceEvaluator, AJumpDoesNotHideThatAForceComesBack) {
  for (const PlanarInstructions instructions : available_planar_instructions())
    for (const bool total_cap : {false, true}) {
      Contacts fast(stuck, 3, instructions, total_cap), general(stuck, 3, instructions, total_cap);
      for (Contacts* contacts : {&fast, &general}) {
        contacts->pull(5e-6);
        const PlanarKinematics& upper = contacts->bodies.kinematics(1);
        contacts->events.set_jumped(
            1, {{0, -20, 0}, {0, -2e-4, 0}, {0, -1e-9, 0}, upper.cosine, upper.sine});
      }
      general.forget_full_history();
      for (Contacts* contacts : {&fast, &general}) contacts->evaluate();
      EXPECT_EQ(fast.evaluator.general_contacts(), 9);
      expect_same(fast, general, stuck);
      // Nine springs have begun to push the lower rod down; their dashpots make 2 % of it.
      const double springs = 9 * paper.kn * overlap;
      EXPECT_NEAR(fast.events.changes(0).now.d[1], -springs, 0.03 * springs);
    }
}

}  // namespace rodpack
