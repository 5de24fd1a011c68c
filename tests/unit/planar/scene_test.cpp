// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/planar/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "heap.h"
#include "rodpack/contact/contact_law.h"
#include "rodpack/motion/multistep.h"

namespace rodpack {
namespace {

// Two discs head-on; returns the relative speed after over that before.
double restitution(double eta, double dt, bool events, int order = 3) {
  PlanarSettings settings = settings_of({1000.0, 500.0, eta, 0.0, 0.0});
  settings.dt = dt;
  settings.events = events;
  settings.order = order;
  PlanarScene scene(settings, {moving(rod(1, 0, 0, 0), 0.5, 0),
                               moving(rod(1, diameter + 1.23e-5, 0, 0), -0.5, 0)});
  scene.evaluate();
  scene.run(std::lround(2e-3 / dt));
  return scene.body(1).velocity[0] - scene.body(0).velocity[0];
}

}  // namespace

// The dashpot's own closed form, restitution_coefficient(): also checks the cut at zero force.
TEST(PlanarScene, HeadOnCollisionHasTheClosedFormsRestitution) {
  for (const double eta : {0.0, 0.2, 0.5})
    EXPECT_NEAR(restitution(eta, paper_step / 4, true), restitution_coefficient(eta), 2e-5) << eta;
}

TEST(PlanarScene, CollisionsAreOfThirdOrderWithEventsAndOfFirstWithout) {
  const double exact = restitution_coefficient(0.2);
  const auto error = [&](double dt, bool events) {
    // over several phases of the moment of touch within the step
    double sum = 0;
    for (const double phase : {1.0, 1.013, 1.029, 1.041, 1.057})
      sum += std::fabs(restitution(0.2, dt * phase, events) - exact);
    return sum;
  };
  EXPECT_GT(std::log2(error(8e-6, true) / error(1e-6, true)) / 3, 2.6);
  EXPECT_LT(std::log2(error(8e-6, false) / error(1e-6, false)) / 3, 1.5);
}

// Weight over the number of spheres is carried by each spring: delta = m g / (n k).
TEST(PlanarScene, RodAtRestOnTheFloorPressesEachSphereIntoItByItsShare) {
  PlanarSettings settings = box(5);
  PlanarScene scene(settings, {rod(5, 0.02, 0.5 * diameter, 0)});
  scene.evaluate();
  scene.run(40000);
  const PlanarBody body = scene.body(0);
  const double overlap = body.mass * 9.81 / (9 * paper.kn);
  EXPECT_NEAR(0.5 * diameter - body.position[1], overlap, 1e-9 * overlap);
  EXPECT_NEAR(body.velocity[1], 0, 1e-12);
  EXPECT_EQ(scene.contacts().size(), 9u);
}

// Forces come in opposite pairs; so do the impulses of events.
TEST(PlanarScene, MomentumOfAClosedSceneIsConservedToRounding) {
  for (const bool events : {false, true}) {
    PlanarSettings settings = settings_of();
    settings.events = events;
    std::vector<PlanarBody> bodies = heap(12, 5);
    for (PlanarBody& body : bodies) {  // all of them towards the middle
      body.velocity[0] = 8 * (0.025 - body.position[0]);
      body.velocity[1] = 8 * (0.04 - body.position[1]);
    }
    PlanarScene scene(settings, bodies);
    scene.evaluate();
    double before[2] = {}, after[2] = {}, scale = 0;
    for (int k = 0; k < scene.size(); ++k)
      for (int d = 0; d < 2; ++d) {
        before[d] += bodies[k].mass * bodies[k].velocity[d];
        scale += bodies[k].mass * std::fabs(bodies[k].velocity[d]);
      }
    scene.run(20000);
    EXPECT_GT(scene.statistics().general, 100);
    for (int k = 0; k < scene.size(); ++k) {
      const PlanarBody body = scene.body(k);
      // what events have missed in the last step is added in the next
      for (int d = 0; d < 2; ++d)
        after[d] += body.mass * (body.velocity[d] + body.missed_velocity[d]);
    }
    for (int d = 0; d < 2; ++d) EXPECT_NEAR(after[d], before[d], 1e-12 * scale) << events;
  }
}

// The lists decide what is looked at, not what happens. The times are short enough for rounding
// errors not to grow to 1e-12.
TEST(PlanarScene, ListsDoNotChangeTheMotion) {
  for (const double curvature : {0.0, 2.0}) {
    PlanarSettings settings = box(5);
    const auto end = [&](double least, double most, double steps) {
      settings.min_skin = least;
      settings.max_skin = most;
      settings.skin_steps = steps;
      PlanarScene scene(settings, heap(15, 5, curvature));
      scene.evaluate();
      scene.run(4000);
      EXPECT_GT(scene.statistics().general, 100);
      return std::make_pair(state_of(scene), scene.statistics().listings);
    };
    const auto everything = end(0.1, 0.1, 1), narrow = end(1e-5, 1e-5, 1),
               usual = end(1e-4, 1e-3, 80);
    EXPECT_LT(difference(everything.first, narrow.first), 1e-12);
    EXPECT_LT(difference(everything.first, usual.first), 1e-12);
    EXPECT_GT(narrow.second, 10 * usual.second);
  }
}

// A pass goes on with a part of the bodies while others wait; steps that are asked for one by one
// are made one by one.
TEST(PlanarScene, StepsAtOnceAreStepsOneByOne) {
  PlanarSettings settings = box(5);
  settings.walls.pop_back();
  const std::vector<PlanarBody> in_order = row_of_heaps(60, settings);
  std::vector<PlanarBody> mixed = in_order;
  for (std::size_t k = 0; k < mixed.size(); ++k)
    std::swap(mixed[k], mixed[k * 7919 % mixed.size()]);
  for (const std::vector<PlanarBody>& bodies : {in_order, mixed})
    for (const bool relists : {false, true}) {
      settings.min_skin = relists ? 1e-4 : 8e-3;
      settings.max_skin = relists ? 1e-3 : 8e-3;
      PlanarScene at_once(settings, bodies), one_by_one(settings, bodies);
      for (PlanarScene* scene : {&at_once, &one_by_one}) scene->evaluate();
      const int steps = 501;
      at_once.run(steps);
      for (int k = 0; k < steps; ++k) one_by_one.run(1);
      EXPECT_GT(at_once.statistics().general, 1000);
      EXPECT_EQ(at_once.statistics().steps, steps);
      EXPECT_EQ(at_once.statistics().listings > 0, relists);
      const double worst = difference(state_of(at_once), state_of(one_by_one));
      if (relists)  // blocks may come to lie in another order
        EXPECT_LT(worst, 1e-12);
      else
        EXPECT_EQ(worst, 0.0);
    }
}

// In a pass, parts that nothing holds back are steps ahead. What flies at one of their bodies must
// be listed with it before, so that both meet in the same step, however narrow the skins.
TEST(PlanarScene, WhatIsFoundInAPassIsNotAhead) {
  std::vector<PlanarBody> bodies;
  for (int k = 0; k < 300; ++k) bodies.push_back(rod(1, 0.02 * k, 0, 0));
  PlanarSettings settings = settings_of();
  const double speed = 6.2, way = speed * settings.dt;
  for (const double skin : {1.5 * diameter / 150, 1.5 * diameter / 15, 0.3 * diameter}) {
    settings.min_skin = skin / 10;
    settings.max_skin = skin;
    for (int phase = 0; phase < 20; ++phase) {  // of the collision in the pass
      const double x = bodies[10].position[0] + diameter + 2e-3 + 0.4 * phase * way;
      bodies[299] = moving(rod(1, x, 0, 0), -speed, 0);
      PlanarScene at_once(settings, bodies), one_by_one(settings, bodies);
      for (PlanarScene* scene : {&at_once, &one_by_one}) scene->evaluate();
      const int steps = 64;
      at_once.run(steps);
      for (int k = 0; k < steps; ++k) one_by_one.run(1);
      EXPECT_LT(one_by_one.body(10).velocity[0], -0.1 * speed);
      EXPECT_LT(difference(state_of(at_once), state_of(one_by_one)), 1e-12) << skin << " " << phase;
    }
  }
}

// Even the motion of what blows up ends.
TEST(PlanarScene, AnAngleBeyondAllNumbersEnds) {
  PlanarScene scene(settings_of(), {moving(rod(5, 0, 0, 0), 0, 0, 1e308 * 1e10)});
  scene.evaluate();
  EXPECT_EQ(scene.run(3), 3);
}

// The same law, without events, written down once more: all spheres against all, body by body, with
// the integrator and the law of the core for single bodies.
TEST(PlanarScene, MatchesAPlainLoopOverAllSpheres) {
  for (const int order : {1, 2, 3, 4}) {
    PlanarSettings settings = box(5);
    settings.order = order;
    settings.events = false;
    const std::vector<PlanarBody> start = heap(9, 5);
    const int steps = 4000, bodies = static_cast<int>(start.size());

    struct History {
      double spring;
      std::vector<double> velocities;  // newest first
      int known, step;
    };
    std::map<std::array<int, 4>, History> histories;
    std::vector<PlanarMotion> motions;
    std::vector<std::vector<PlanarRates>> past(bodies, std::vector<PlanarRates>(order));
    std::vector<std::array<double, 3>> loads(bodies);
    for (const PlanarBody& body : start) {
      const double angle = std::atan2(body.sine, body.cosine);
      motions.push_back({{body.position[0], body.position[1]},
                         {body.velocity[0], body.velocity[1]},
                         body.velocity[2],
                         {std::cos(0.5 * angle), 0, 0, std::sin(0.5 * angle)}});
    }
    const auto arm = [&](int b, int s) {
      const double* q = motions[b].quaternion;
      const double c = q[0] * q[0] - q[3] * q[3], n = 2 * q[0] * q[3];
      const PlanarSphere& sphere = start[b].spheres[s];
      return std::array<double, 2>{c * sphere.x - n * sphere.y, n * sphere.x + c * sphere.y};
    };
    // normal from j to i, lever of i and j from their centres of mass to the contact
    const auto contact = [&](std::array<int, 4> key, int step, const double* normal, double overlap,
                             std::array<double, 2> lever_i, std::array<double, 2> lever_j,
                             double mass, double touch_since) {
      const int i = key[0], j = key[2];
      double v[2];
      const auto surface = [&](int b, const std::array<double, 2>& lever, double sign) {
        v[0] += sign * (motions[b].velocity[0] - motions[b].angular_velocity * lever[1]);
        v[1] += sign * (motions[b].velocity[1] + motions[b].angular_velocity * lever[0]);
      };
      v[0] = v[1] = 0;
      surface(i, lever_i, 1);
      if (j >= 0) surface(j, lever_j, -1);
      const double tangent[2] = {-normal[1], normal[0]};
      const double vn = v[0] * normal[0] + v[1] * normal[1];
      const double vt = v[0] * tangent[0] + v[1] * tangent[1];
      const auto fn =
          normal_force(paper.kn, damping_coefficient(paper.eta_n, mass, paper.kn), overlap, vn);
      History& history = histories[key];
      if (history.velocities.empty() || history.step != step - 1) {
        history = {std::isnan(touch_since) ? 0.0 : touch_since, {}, 0, step};
        if (vn < 0) history.spring = std::min(paper_step, -overlap / vn) * vt;
        if (j >= 0) history.spring = touch_since;
      } else {
        const auto& weights = multistep_weights(order, std::min(history.known, order + 1));
        for (int k = 0; k < std::min<int>(order, history.velocities.size()); ++k)
          history.spring += paper_step * weights[k] * history.velocities[k];
      }
      history.step = step;
      ++history.known;
      history.velocities.insert(history.velocities.begin(), vt);
      history.velocities.resize(std::min<std::size_t>(history.velocities.size(), order));
      double spring[1] = {history.spring}, velocity[1] = {vt}, ft[1];
      tangential_force(paper.kt, damping_coefficient(paper.eta_t, mass, paper.kt),
                       paper.friction * fn.elastic, spring, velocity, ft);
      history.spring = spring[0];
      const double f[2] = {fn.total * normal[0] + ft[0] * tangent[0],
                           fn.total * normal[1] + ft[0] * tangent[1]};
      const auto add = [&](int b, const std::array<double, 2>& lever, double sign) {
        loads[b][0] += sign * f[0];
        loads[b][1] += sign * f[1];
        loads[b][2] += sign * (lever[0] * f[1] - lever[1] * f[0]);
      };
      add(i, lever_i, 1);
      if (j >= 0) add(j, lever_j, -1);
    };
    const auto forces = [&](int step) {
      for (int b = 0; b < bodies; ++b) loads[b] = {0, -9.81 * start[b].mass, 0};
      const double r = 0.5 * diameter;
      for (int i = 0; i < bodies; ++i)
        for (int a = 0; a < 9; ++a) {
          const auto arm_i = arm(i, a);
          const double x[2] = {motions[i].position[0] + arm_i[0],
                               motions[i].position[1] + arm_i[1]};
          for (int w = 0; w < 3; ++w) {
            const PlanarWall& wall = settings.walls[w];
            const double distance = x[wall.axis] - wall.position, overlap = r - std::fabs(distance);
            if (overlap < 0) continue;
            double normal[2] = {0, 0};
            normal[wall.axis] = distance > 0 ? 1 : -1;
            const double length = r - 0.5 * overlap;
            contact({i, a, -1 - w, 0}, step, normal, overlap,
                    {arm_i[0] - length * normal[0], arm_i[1] - length * normal[1]}, {},
                    start[i].mass, NAN);
          }
          for (int j = i + 1; j < bodies; ++j)
            for (int b = 0; b < 9; ++b) {
              const auto arm_j = arm(j, b);
              double delta[2], distance;
              for (int d = 0; d < 2; ++d) delta[d] = x[d] - motions[j].position[d] - arm_j[d];
              distance = std::hypot(delta[0], delta[1]);
              const double overlap = 2 * r - distance;
              if (overlap <= 0) continue;
              const double normal[2] = {delta[0] / distance, delta[1] / distance};
              const double length = r - 0.5 * overlap;
              // The spring since touch: mean of the tangential velocities then and now, with
              // constant velocities of the centres and spins, over the time since.
              double u[2];
              const double wi = motions[i].angular_velocity, wj = motions[j].angular_velocity;
              u[0] =
                  motions[i].velocity[0] - wi * arm_i[1] - motions[j].velocity[0] + wj * arm_j[1];
              u[1] =
                  motions[i].velocity[1] + wi * arm_i[0] - motions[j].velocity[1] - wj * arm_j[0];
              const double approach = delta[0] * u[0] + delta[1] * u[1];
              const double square = u[0] * u[0] + u[1] * u[1];
              const double closed = 4 * r * r - distance * distance;
              const double since =
                  std::min(paper_step,
                           (approach + std::sqrt(approach * approach + square * closed)) / square);
              const double n0[2] = {(delta[0] - since * u[0]), (delta[1] - since * u[1])};
              const double l0 = std::hypot(n0[0], n0[1]);
              const double then = (u[1] * n0[0] - u[0] * n0[1]) / l0 - r * (wi + wj);
              const double now = u[1] * normal[0] - u[0] * normal[1] - length * (wi + wj);
              contact({i, a, j, b}, step, normal, overlap,
                      {arm_i[0] - length * normal[0], arm_i[1] - length * normal[1]},
                      {arm_j[0] + length * normal[0], arm_j[1] + length * normal[1]},
                      0.5 * start[i].mass, 0.5 * since * (then + now));
            }
        }
    };
    forces(0);
    int touched = 0;
    for (int step = 1; step <= steps; ++step) {
      for (int b = 0; b < bodies; ++b) {
        std::rotate(past[b].begin(), past[b].begin() + 1, past[b].end());
        past[b].back() = {{motions[b].velocity[0], motions[b].velocity[1]},
                          motions[b].angular_velocity,
                          {loads[b][0] / start[b].mass, loads[b][1] / start[b].mass},
                          loads[b][2] / start[b].moment};
        if (step == 1) fill_kinematic_history(past[b].data(), order, paper_step);
        advance(motions[b], past[b].data(), order, std::min(step, order + 1), paper_step);
      }
      forces(step);
      touched = static_cast<int>(histories.size());
    }
    ASSERT_GT(touched, 12);
    PlanarScene scene(settings, start);
    scene.evaluate();
    scene.run(steps);
    for (int b = 0; b < bodies; ++b) {
      const PlanarBody body = scene.body(b);
      for (int d = 0; d < 2; ++d) {
        EXPECT_NEAR(body.position[d], motions[b].position[d], 1e-11) << order << ' ' << b;
        EXPECT_NEAR(body.velocity[d], motions[b].velocity[d], 1e-9) << order << ' ' << b;
      }
      EXPECT_NEAR(body.velocity[2], motions[b].angular_velocity, 1e-6) << order << ' ' << b;
    }
  }
}

// Loads of a heap that moves and of one that rests, and forces of its contacts, after some steps
// from the same state; measured by the largest normal force. The origin is in the middle of the
// heap: a position is exact to half a unit in its last place, which a stiff spring turns into a
// difference of forces, so that far from the origin rounding alone comes near the bound (3.5e-18 m
// at 5 cm, times 1500 N/m, 5e-15 N of 1.8e-14 N).
TEST(PlanarScene, AllInstructionsGiveTheSameForces) {
  for (const bool events : {false, true})
    for (const int order : {2, 3, 4}) {
      PlanarSettings settings = box(5);
      settings.types = 2;
      settings.laws.assign(4, paper);
      settings.laws[3].kn *= 1.5;  // by type, so that the lanes of a register differ
      settings.events = events;
      settings.order = order;
      settings.remembered = 4;
      std::vector<PlanarBody> start = heap(23, 5, 2.0);
      const double middle = 0.5 * settings.walls[2].position;
      for (std::size_t k = 0; k < start.size(); ++k) {
        start[k].type = k % 2;
        start[k].position[0] -= middle;
      }
      for (const int side : {1, 2}) settings.walls[side].position -= middle;
      for (const long before : {9000L, 60000L}) {
        PlanarScene scene(settings, start);
        scene.evaluate();
        scene.run(before);
        std::vector<PlanarBody> bodies;
        for (int k = 0; k < scene.size(); ++k) bodies.push_back(scene.body(k));
        std::vector<double> expected;
        for (const PlanarInstructions instructions : available_planar_instructions()) {
          settings.instructions = instructions;
          PlanarScene one(settings, bodies);
          one.set_contacts(scene.contacts());
          one.run(50);
          std::vector<double> forces;
          for (int k = 0; k < one.size(); ++k)
            for (int d = 0; d < 3; ++d)
              forces.push_back(one.body(k).load[d] / (d < 2 ? 1.0 : diameter));
          std::map<std::array<int, 4>, std::array<double, 2>> contacts;
          double largest = 0;
          for (const PlanarContactState& c : one.contacts()) {
            contacts[{c.body_i, c.sphere_i, c.body_j, c.sphere_j}] = {
                c.history.viscoelastic, c.constants[1] * c.history.spring};
            largest = std::max(largest, std::fabs(c.history.viscoelastic));
          }
          for (const auto& contact : contacts)
            forces.insert(forces.end(), contact.second.begin(), contact.second.end());
          EXPECT_GT(contacts.size(), before > 10000 ? 20u : 5u);
          if (instructions == PlanarInstructions::baseline) expected = forces;
          ASSERT_EQ(forces.size(), expected.size());
          EXPECT_LT(difference(expected, forces), 1e-12 * largest)
              << name_of(instructions) << ' ' << order << ' ' << before;
        }
        settings.instructions = PlanarInstructions::automatic;
      }
    }
}

TEST(PlanarScene, InstructionsAreKnownByName) {
  const auto sets = available_planar_instructions();
  ASSERT_FALSE(sets.empty());
  EXPECT_EQ(sets.front(), PlanarInstructions::baseline);
  EXPECT_EQ(chosen(PlanarInstructions::automatic), sets.back());
  for (const PlanarInstructions set : sets) EXPECT_EQ(planar_instructions(name_of(set)), set);
  EXPECT_EQ(planar_instructions("auto"), PlanarInstructions::automatic);
  for (const char* name : {"baseline", "avx2", "avx512"}) {
    const bool there = std::any_of(sets.begin(), sets.end(), [&](PlanarInstructions set) {
      return std::string(name_of(set)) == name;
    });
    if (!there) {
      EXPECT_THROW(planar_instructions(name), std::invalid_argument);
    }
  }
  try {
    planar_instructions("sse9");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("instructions is sse9, expected auto, baseline"));
  }
}

// Everything that the next step needs is in body() and contacts().
TEST(PlanarScene, GoesOnFromItsBodiesAndContacts) {
  for (const bool events : {false, true}) {
    PlanarSettings settings = box(5);
    settings.events = events;
    PlanarScene whole(settings, heap(15, 5));
    whole.evaluate();
    whole.run(3000);
    std::unique_ptr<PlanarScene> parts(new PlanarScene(settings, heap(15, 5)));
    parts->evaluate();
    for (const int steps : {1, 999, 1301, 1, 698}) {  // 3000
      parts->run(steps);
      std::vector<PlanarBody> bodies;
      for (int k = 0; k < parts->size(); ++k) bodies.push_back(parts->body(k));
      const auto contacts = parts->contacts();
      parts.reset(new PlanarScene(settings, bodies));
      parts->set_contacts(contacts);
      EXPECT_EQ(parts->contacts().size(), contacts.size());
    }
    EXPECT_LT(difference(state_of(whole), state_of(*parts)), 1e-12) << events;
  }
}

// A heap of many rods of all kinds comes to rest without anything flying off.
TEST(PlanarScene, HeapComesToRestUnderItsWeight) {
  for (const bool events : {false, true}) {
    PlanarSettings settings = box(3);
    settings.events = events;
    PlanarScene scene(settings, heap(12, 3));
    scene.evaluate();
    scene.run(100000);
    double weight = 0, carried = 0;
    for (int k = 0; k < scene.size(); ++k) {
      const PlanarBody body = scene.body(k);
      EXPECT_LT(std::hypot(body.velocity[0], body.velocity[1]), 1e-4);
      weight += 9.81 * body.mass;
      carried += body.load[1];  // what is left: 0
    }
    EXPECT_NEAR(carried / weight, 0, 1e-3);
  }
}

TEST(PlanarScene, RefusesValuesOutOfRange) {
  const auto message = [](const PlanarSettings& settings, const std::vector<PlanarBody>& bodies) {
    try {
      PlanarScene scene(settings, bodies);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  PlanarSettings settings = settings_of();
  EXPECT_EQ(message(settings, {rod(5, 0, 0, 0)}), "");
  settings.order = 5;
  EXPECT_THAT(message(settings, {}),
              testing::HasSubstr("order is 5.000000, expected 1, 2, 3 or 4"));
  settings.order = 3;
  settings.laws[0].eta_n = 1.0;
  EXPECT_THAT(message(settings, {}), testing::HasSubstr("eta_n is 1.0"));
  PlanarBody body = rod(5, 0, 0, 0);
  body.moment = 0;
  EXPECT_THAT(message(settings_of(), {body}), testing::HasSubstr("moment of inertia is 0.0"));
}

TEST(PlanarScene, RefusesContactsOfSpheresThatAreFarOrNotThere) {
  PlanarSettings settings = box(5);
  PlanarScene scene(settings, {rod(5, 0.02, 0.5 * diameter, 0), rod(5, 0.02, 0.03, 0)});
  const auto message = [&](int body_i, int sphere_i, int body_j, int sphere_j) {
    PlanarContactState contact = PlanarContactState();
    contact.body_i = body_i;
    contact.sphere_i = sphere_i;
    contact.body_j = body_j;
    contact.sphere_j = sphere_j;
    try {
      scene.set_contacts({contact});
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message(0, 3, -1, 0), "") << "on the floor";
  EXPECT_THAT(message(0, 3, 1, 3), testing::HasSubstr("expected spheres that are close"));
  EXPECT_THAT(message(0, 65536 + 3, -1, 0), testing::HasSubstr("sphere of a contact is 65539"));
  EXPECT_THAT(message(0, 3, 1, -1), testing::HasSubstr("sphere of a contact is -1"));
  EXPECT_THAT(message(2, 0, -1, 0), testing::HasSubstr("one of a body of the scene"));
  EXPECT_THAT(message(0, 3, -4, 0), testing::HasSubstr("wall of a contact is 3"));
}

}  // namespace rodpack
