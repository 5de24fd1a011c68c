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
#include "plain_scene.h"
#include "rodpack/contact/contact_law.h"

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

// A slide all through an impact has mu times the impulse of the normal force, dashpot included, to
// rounding whatever the step, since every event of that force is one of the friction too: a disc
// loses mu times what it gains along the normal. Its own tangential force turns it.
TEST(PlanarScene, UnderTheCapOfTheWholeForceASlideHasMuTimesTheNormalImpulse) {
  for (const int order : {2, 3, 4}) {
    PlanarSettings settings = settings_of({1000.0, 500.0, 0.3, 0.3, 0.3});
    settings.order = order;
    settings.slots = 4;
    settings.total_force_cap = true;
    settings.walls = {{1, 0.0, 0}};
    PlanarScene scene(settings, {moving(rod(1, 0, 0.5 * diameter + 1.7e-5, 0), 3.0, -0.5)});
    scene.evaluate();
    scene.run(200);
    const PlanarBody body = scene.body(0);
    EXPECT_NEAR(body.velocity[1] / 0.5, restitution_coefficient(0.3), 0.02);
    EXPECT_NEAR(3.0 - body.velocity[0], 0.3 * (body.velocity[1] + 0.5), 1e-13) << order;
    EXPECT_LT(body.velocity[2], -100) << order;
  }
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

// Orders, both caps of friction, mass scaling, and dashpots that relax.
TEST(PlanarScene, MatchesAPlainLoopOverAllSpheres) {
  const struct {
    int order;
    bool total_force_cap;
    double mass_scaling, dashpot_relaxation;
  } methods[] = {{1, false, 0, 0},  {2, true, 0, 0},     {3, false, 0, 0},
                 {4, true, 0, 0},   {2, false, 1.2, 0},  {0, false, 0, 0},
                 {0, true, 1.2, 0}, {0, false, 0, 2e-5}, {0, true, 0, 2e-5}};
  for (const auto& method : methods) {
    const int order = method.order;
    PlanarSettings settings = box(5);
    settings.order = order;
    settings.total_force_cap = method.total_force_cap;
    settings.mass_scaling = method.mass_scaling;
    settings.dashpot_relaxation = method.dashpot_relaxation;
    settings.events = false;
    const std::vector<PlanarBody> start = heap(9, 5);
    const int steps = 4000;
    PlainScene plain(settings, start);
    plain.run(steps);
    ASSERT_GT(plain.touched(), 12u);
    if (method.mass_scaling > 0) {
      ASSERT_GT(plain.largest_factor(), 3);
    }
    PlanarScene scene(settings, start);
    scene.evaluate();
    scene.run(steps);
    for (int b = 0; b < scene.size(); ++b) {
      const PlanarBody body = scene.body(b);
      const PlanarMotion& expected = plain.motion(b);
      for (int d = 0; d < 2; ++d) {
        EXPECT_NEAR(body.position[d], expected.position[d], 1e-11) << order << ' ' << b;
        EXPECT_NEAR(body.velocity[d], expected.velocity[d], 1e-9) << order << ' ' << b;
      }
      EXPECT_NEAR(body.velocity[2], expected.angular_velocity, 1e-6) << order << ' ' << b;
    }
  }
}

// A disc between two that hold still, 0.3 mm from each, bounces to and fro at v without loss: it
// never is more than 0.3 mm away from where it was listed, but has to be looked for at each turn.
// Between two touches it goes 0.6 mm, and each touch takes half a period of its spring.
TEST(PlanarScene, WhatGoesToAndFroWithinItsSkinIsNotMissed) {
  for (const PlanarInstructions instructions :
       {PlanarInstructions::automatic, PlanarInstructions::baseline}) {
    PlanarSettings settings = settings_of({1000.0, 500.0, 0.0, 0.0, 0.0});
    settings.instructions = instructions;
    settings.dt = paper_step / 4;
    settings.min_skin = settings.max_skin = 1e-3;
    const double gap = 3e-4, speed = 0.1;
    std::vector<PlanarBody> bodies = {rod(1, 0, 0, 0),
                                      moving(rod(1, diameter + gap, 0, 0), speed, 0),
                                      rod(1, 2 * (diameter + gap), 0, 0)};
    bodies[0].prescribed = bodies[2].prescribed = true;
    const double turn = M_PI * std::sqrt(bodies[1].mass / 1000.0);
    PlanarScene scene(settings, bodies);
    scene.evaluate();
    const int turns = 5;
    scene.run(std::lround((turns * 2 * gap / speed + turns * turn) / settings.dt));
    const PlanarBody body = scene.body(1);
    EXPECT_NEAR(body.velocity[0], -speed, 1e-3 * speed);
    EXPECT_NEAR(body.position[0], diameter + gap, 0.02 * gap);
    EXPECT_EQ(scene.statistics().listings, 0);
  }
}

// A rod's end strikes another rod: a contact or two, of weight 3 at most each, below S^2. Under a
// scaling that these contacts reach they rebound otherwise.
TEST(PlanarScene, MassScalingLeavesFreeCollisionsAsTheyAre) {
  for (const bool events : {false, true}) {
    const auto after = [&](double mass_scaling) {
      PlanarSettings settings = settings_of();
      settings.order = 2;
      settings.events = events;
      settings.mass_scaling = mass_scaling;
      PlanarScene scene(settings,
                        {rod(5, 0, 0, 0.1), moving(rod(5, 2e-3, 9.1e-3, 1.5), 0.1, -0.5, 3)});
      scene.evaluate();
      scene.run(500);
      return state_of(scene);
    };
    EXPECT_EQ(difference(after(4), after(0)), 0) << events;
    EXPECT_GT(difference(after(1), after(0)), 1e-3) << events;
  }
}

// Loads of a heap that moves and of one that rests, and forces of its contacts, after some steps
// from the same state; measured by the largest normal force. The origin is in the middle of the
// heap: a position is exact to half a unit in its last place, which a stiff spring turns into a
// difference of forces: 3.5e-18 m at 5 cm, times 1500 N/m, 5e-15 N for each of the some 16 contacts
// of a rod. Ten times the weight makes this rounding small beside the bound, of 1.5e-13 N.
TEST(PlanarScene, AllInstructionsGiveTheSameForces) {
  for (const bool events : {false, true})
    for (const int order : {2, 3, 4}) {
      PlanarSettings settings = box(5);
      settings.types = 2;
      settings.laws.assign(4, paper);
      settings.laws[3].kn *= 1.5;  // by type, so that the lanes of a register differ
      settings.events = events;
      settings.order = order;
      settings.total_force_cap = order == 4;
      settings.mass_scaling = order == 2 ? 1.5 : 0.0;
      settings.slots = 4;
      settings.gravity[1] *= 10.0;
      std::vector<PlanarBody> start = heap(23, 5, 2.0);
      const double middle = 0.5 * settings.walls[2].position;
      for (std::size_t k = 0; k < start.size(); ++k) {
        start[k].type = k % 2;
        start[k].position[0] -= middle;
      }
      for (const int side : {1, 2}) settings.walls[side].position -= middle;
      for (const long before : {8000L, 60000L}) {
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
                c.history.viscoelastic, c.constants.kt * c.history.spring};
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
    EXPECT_THAT(error.what(),
                testing::HasSubstr("instructions is 'sse9', expected auto, baseline"));
  }
}

// Everything that the next step needs is in body() and contacts().
TEST(PlanarScene, GoesOnFromItsBodiesAndContacts) {
  for (const bool events : {false, true}) {
    PlanarSettings settings = box(5);
    settings.events = events;
    settings.total_force_cap = events;
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
              testing::HasSubstr("order is 5.000000, expected 0, 1, 2, 3 or 4"));
  settings.order = 3;
  settings.dashpot_relaxation = 2;
  EXPECT_THAT(message(settings, {}),
              testing::HasSubstr("dashpot_relaxation is 2.000000, expected 0, or a time > 0 (s) "
                                 "with order 0"));
  settings.dashpot_relaxation = 0;
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
