// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/contact_forces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <sstream>

#include "liggghts_run.h"
#include "analysis/force_chains.h"
#include "reading/scene/run_scene.h"
#include "synthetic_packing.h"

namespace {
using namespace rodpack;
using rodpack::test::frame_head;
using rodpack::test::fresh_folder;
using rodpack::test::put;
using testing::ElementsAre;
using testing::HasSubstr;

struct Contact {
  int i, j;  // bodies; j = 0: a wall
  std::array<double, 3> force, normal;
  std::array<double, 4> centres{0, 1, 0, 0};  // bix biy bjx bjy
};

Frame contacts_frame(const std::vector<Contact>& contacts, long timestep = 5) {
  std::ostringstream rows;
  rows.precision(16);
  int spheres = 0;  // each contact is one of two other spheres
  for (const auto& [i, j, f, n, b] : contacts) {
    spheres += 2;
    rows << i << ' ' << j << ' ' << spheres - 1 << ' ' << spheres << ' ' << (j == 0) << " 0 0 0 "
         << f[0] << ' ' << f[1] << ' ' << f[2] << ' ' << b[0] << ' ' << b[1] << " 0 " << b[2] << ' '
         << b[3] << " 0 1e-6 0 " << n[0] << ' ' << n[1] << ' ' << n[2] << '\n';
  }
  return last_frame({put(fresh_folder() / "c.dump",
                         frame_head(timestep, contacts.size(), 10, 10,
                                    "body_i body_j sphere_i sphere_j wall x y z fx fy fz bix biy "
                                    "biz bjx bjy bjz overlap_n overlap_t nx ny nz") +
                             rows.str())});
}

Frame bodies_frame(int count, long timestep = 5) {
  std::string rows;
  for (int id = 1; id <= count; ++id) rows += std::to_string(id) + "\n";
  const auto size = static_cast<std::size_t>(count);
  return last_frame(
      {put(fresh_folder() / "b.dump", frame_head(timestep, size, 10, 10, "id") + rows)});
}

// n = (0.6, 0.8, 0), tangent (0.8, -0.6, 0) and a part along z.
Contact oblique(int i, int j, double normal, double in_plane, double along_z = 0) {
  return {
      i, j, {0.6 * normal + 0.8 * in_plane, 0.8 * normal - 0.6 * in_plane, along_z}, {0.6, 0.8, 0}};
}

std::string error_of(const Frame& contacts, const Frame* bodies = nullptr,
                     const ContactForceOptions& options = {}) {
  try {
    measure_contact_forces(contacts, bodies, options);
  } catch (const DataError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ContactForces, NormalAndTangentialPartsOfKnownForces) {
  const auto frame = contacts_frame({oblique(1, 2, 2, 0.3, 0.4), oblique(2, 3, 4, -1.5)});
  const auto forces = measure_contact_forces(frame, nullptr, {});
  EXPECT_EQ(forces.carrying, 2U);
  EXPECT_NEAR(forces.normal.mean, 3, 1e-12);      // 2, 4
  EXPECT_NEAR(forces.tangential.mean, 1, 1e-12);  // hypot(0.3, 0.4), 1.5
  // f/<f>: 2/3 and 4/3; 1/2 and 3/2, the last in the bin from 1.5 (or a rounding error below it).
  EXPECT_THAT(forces.normal.count, testing::Contains(1).Times(2));
  EXPECT_EQ(forces.normal.count[2], 1);
  EXPECT_EQ(forces.normal.count[5], 1);
  EXPECT_NEAR(forces.normal.density[2], 0.5 / 0.25, 1e-12);
  EXPECT_NEAR(forces.normal.standard_error[2], std::sqrt(0.5 * 0.5 / 2) / 0.25, 1e-12);
}

TEST(ContactForces, WallsAndContactsWithoutForceAreCountedApart) {
  const auto frame =
      contacts_frame({oblique(1, 2, 2, 0), oblique(1, 2, 0, 0), oblique(1, 0, 8, 0)});
  auto forces = measure_contact_forces(frame, nullptr, {});
  EXPECT_EQ(forces.carrying, 1U);
  EXPECT_EQ(forces.not_carrying, 1U);
  EXPECT_EQ(forces.at_walls, 1U);
  EXPECT_NEAR(forces.normal.mean, 2, 1e-12);
  EXPECT_NEAR(forces.coordination.contacts, 2, 1e-12);
  ContactForceOptions options;
  options.walls_too = true;
  forces = measure_contact_forces(frame, nullptr, options);
  EXPECT_EQ(forces.carrying, 2U);
  EXPECT_EQ(forces.at_walls, 0U);
  EXPECT_NEAR(forces.normal.mean, 5, 1e-12);
  EXPECT_NEAR(forces.coordination.contacts, 2.5, 1e-12);
  EXPECT_NEAR(forces.coordination.touching_particles, 1, 1e-12);
  EXPECT_EQ(forces.tangential.mean, 0) << "a rounding error counts as force";
  for (const double density : forces.tangential.density) EXPECT_EQ(density, 0);
}

// P(x) = e^-x. The mean of a bin is (e^-a - e^-b)/(b - a).
TEST(ContactForces, ExponentialForcesGiveAnExponentialDistribution) {
  std::mt19937 random(7);
  std::exponential_distribution<double> exponential(1 / 3.0);
  std::vector<Contact> contacts;
  for (int k = 0; k < 20000; ++k)
    contacts.push_back(oblique(1, 2, exponential(random), exponential(random)));
  const auto frame = contacts_frame(contacts);
  ContactForceOptions options;
  for (const double width : {0.25, 0.5}) {
    options.bin_width = width;
    const auto forces = measure_contact_forces(frame, nullptr, options);
    for (const auto* each : {&forces.normal, &forces.tangential}) {
      EXPECT_NEAR(each->mean, 3, 4 * 3 / std::sqrt(20000));
      double integral = 0;
      for (std::size_t k = 0; k < each->density.size(); ++k) {
        integral += each->density[k] * width;
        EXPECT_NEAR(forces.force_over_mean[k], (k + 0.5) * width, 1e-12);
        if (each->count[k] < 10) continue;  // too few for a normal error
        const double from = k * width, to = from + width;
        EXPECT_NEAR(each->density[k], (std::exp(-from) - std::exp(-to)) / width,
                    4 * each->standard_error[k])
            << "f/<f> = " << from;
      }
      EXPECT_NEAR(integral, 1, 1e-9);
    }
  }
}

TEST(ContactForces, FrictionBinsAndWhatSlides) {
  ContactForceOptions options;
  options.friction.table = {{0.5}};
  const auto frame = contacts_frame({oblique(1, 2, 2, 0), oblique(1, 2, 2, 0.52),
                                     oblique(1, 2, 2, 0.9993), oblique(1, 2, 2, 1.1)});
  const auto forces = measure_contact_forces(frame, nullptr, options);
  ASSERT_TRUE(forces.friction);
  const auto& friction = *forces.friction;
  EXPECT_EQ(friction.lowest, 0.5);
  EXPECT_EQ(friction.highest, 0.5);
  EXPECT_TRUE(friction.by_type.empty());
  EXPECT_NEAR(friction.mean, (0 + 0.52 + 0.9993 + 1) / 4, 1e-12);  // beyond 1: at most 1
  EXPECT_EQ(friction.sliding_fraction, 0.5);
  EXPECT_EQ(friction.count.front(), 1);
  EXPECT_EQ(friction.count[10], 1);
  EXPECT_EQ(friction.count.back(), 2);
  EXPECT_NEAR(friction.density.back(), 0.5 / 0.05, 1e-12);
  EXPECT_NEAR(friction.centre[10], 0.525, 1e-12);
  EXPECT_FALSE(measure_contact_forces(frame, nullptr, {}).friction);
}

// 1 and 2 touch with three spheres, in either order; 2 and 3 with one; 4 lies on a wall; 5 is
// alone.
TEST(ContactForces, CoordinationCountsPairsOnceAndContactsEach) {
  const auto frame = contacts_frame({oblique(1, 2, 1, 0), oblique(2, 1, 1, 0), oblique(1, 2, 1, 0),
                                     oblique(3, 2, 1, 0), oblique(4, 0, 1, 0)});
  const auto bodies = bodies_frame(5);
  const auto known = measure_contact_forces(frame, &bodies, {}).coordination;
  EXPECT_EQ(known.particles, 5U);
  EXPECT_NEAR(known.touching_particles, 4.0 / 5, 1e-12);
  EXPECT_NEAR(known.contacts, 8.0 / 5, 1e-12);
  EXPECT_EQ(known.rattlers, 1U);
  EXPECT_THAT(known.number, ElementsAre(0, 1, 2, 3, 4));
  EXPECT_THAT(known.with_touching_particles, ElementsAre(2, 2, 1, 0, 0));
  EXPECT_THAT(known.with_contacts, ElementsAre(2, 1, 0, 1, 1));
  const auto seen = measure_contact_forces(frame, nullptr, {}).coordination;
  EXPECT_EQ(seen.particles, 4U);
  EXPECT_NEAR(seen.touching_particles, 1, 1e-12);
  EXPECT_FALSE(seen.rattlers);
}

TEST(ContactForces, SeveralFramesAreOneSample) {
  const auto first = contacts_frame({oblique(1, 2, 1, 0)}, 5);
  const auto second = contacts_frame({oblique(1, 2, 3, 0), oblique(2, 3, 5, 0)}, 6);
  ContactForceSample sample({});
  sample.add(first);
  sample.add(second);
  const auto forces = sample.result();
  EXPECT_NEAR(forces.normal.mean, 3, 1e-12);
  EXPECT_EQ(forces.coordination.particles, 5U);
  EXPECT_NEAR(forces.coordination.contacts, 6.0 / 5, 1e-12);
}

TEST(ContactForces, WrongInputsAreNamed) {
  const auto frame = contacts_frame({oblique(1, 2, 1, 0), oblique(1, 3, 1, 0)});
  EXPECT_THAT(error_of(contacts_frame({})), HasSubstr("c.dump:9: no contacts"));
  EXPECT_THAT(error_of(contacts_frame({oblique(1, 2, 0, 0), oblique(1, 0, 2, 0)})),
              HasSubstr("no contact carries a force; left out: 1 without normal force, 1 with"));
  EXPECT_THAT(error_of(contacts_frame({oblique(1, 2, 1, 0), {1, 2, {1, 0, 0}, {1, 1, 0}}})),
              HasSubstr("c.dump:11: columns 'nx ny nz': expected a unit vector, found one of "
                        "length 1.41421"));
  const auto later = bodies_frame(3, 7);
  EXPECT_THAT(error_of(frame, &later), HasSubstr("expected bodies of timestep 5"));
  EXPECT_THAT(error_of(frame, &later), HasSubstr("found timestep 7"));
  const auto few = bodies_frame(2);
  EXPECT_THAT(error_of(frame, &few), HasSubstr("no particle 3, which has a contact in"));
  auto lacking = frame;
  lacking.names.back() = "other";
  EXPECT_THAT(error_of(lacking), HasSubstr("no column 'nz'"));
  ContactForceOptions options;
  options.bin_width = 0;
  EXPECT_THAT(error_of(frame, nullptr, options), HasSubstr("expected a positive value, found 0"));
}

TEST(ContactForces, FrictionComesFromTheCommandLineElseFromTheRun) {
  const auto folder = fresh_folder();
  Frame dump;
  dump.file = (folder / "c.dump").string();
  const auto found = [&](std::optional<double> given = {}) {
    return find_friction(dump, "", given).table;
  };
  EXPECT_TRUE(found().empty());
  put(folder / "parameters.json", "{\"friction\": 0.3}");
  EXPECT_EQ(found(), FrictionTable{{0.3}});
  EXPECT_EQ(found(0.4), FrictionTable{{0.4}});
  put(folder / "parameters.json", "{\"friction\": 0}");
  EXPECT_TRUE(found().empty());
  put(folder / "parameters.json", "{\"friction\": -1}");
  EXPECT_THROW(found(), DataError);
}

// Two sphere contacts of one pair, in either order: the forces on the same body are summed.
TEST(ForceLines, SumTheContactsOfAPair) {
  const auto lines = force_lines(contacts_frame({{1, 2, {3, 0, 0}, {1, 0, 0}, {4, 5, 2, 5}},
                                                 {2, 1, {0, -4, 0}, {0, -1, 0}, {2, 5, 4, 5}},
                                                 {1, 3, {1, 0, 0}, {1, 0, 0}, {4, 5, 1, 1}}}));
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_NEAR(lines[0].force, 5, 1e-12);
  EXPECT_EQ(lines[0].x1, 4);
  EXPECT_EQ(lines[0].x2, 2);
  EXPECT_NEAR(lines[1].force, 1, 1e-12);
  EXPECT_EQ(lines[1].y2, 1);
}

// In a corner: two contacts with the floor, one of them three times stronger, and one with a wall.
TEST(ForceLines, WallsAreToldApartByTheirNormals) {
  const auto lines = force_lines(contacts_frame({{1, 0, {0, 1, 0}, {0, 1, 0}, {2, 1, 1, 0}},
                                                 {1, 0, {0, 3, 0}, {0, 1, 0}, {2, 1, 3, 0}},
                                                 {1, 0, {2, 0, 0}, {1, 0, 0}, {2, 1, 0, 1}}}));
  ASSERT_EQ(lines.size(), 2U);
  const auto& floor = lines[0].force > 3 ? lines[0] : lines[1];
  const auto& side = lines[0].force > 3 ? lines[1] : lines[0];
  EXPECT_NEAR(floor.force, 4, 1e-12);
  EXPECT_NEAR(floor.x2, 2.5, 1e-12);
  EXPECT_NEAR(floor.y2, 0, 1e-12);
  EXPECT_NEAR(side.force, 2, 1e-12);
  EXPECT_NEAR(side.x2, 0, 1e-12);
}

// A rod on the floor across a periodic border of 10 m: its contacts come with it in two images.
TEST(ForceLines, ContactsOfOneParticleInTwoImagesMeetBetweenThem) {
  const auto lines = force_lines(contacts_frame(
      {{1, 0, {0, 1, 0}, {0, 1, 0}, {9, 1, 8, 0}}, {1, 0, {0, 1, 0}, {0, 1, 0}, {-1, 1, 0, 0}}}));
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NEAR(lines[0].x1, 9, 1e-12);
  EXPECT_NEAR(lines[0].x2, 9, 1e-12);
}

TEST(FrameAt, FindsTheTimestepAmongFilesOfSeveralFrames) {
  const auto folder = fresh_folder();
  const auto frame = [](long step) { return frame_head(step, 1, 1, 1, "id") + "1\n"; };
  const std::vector<std::string> files{put(folder / "a.dump", frame(1) + frame(3)),
                                       put(folder / "b.dump", frame(5) + frame(7))};
  for (const long step : {1L, 3L, 5L, 7L}) EXPECT_EQ(frame_at(files, step).timestep, step);
  EXPECT_THROW(frame_at(files, 0), NoSuchFrame);
  EXPECT_THROW(frame_at(files, 4), NoSuchFrame);
  EXPECT_THROW(frame_at(files, 8), NoSuchFrame);
}

}  // namespace
