// SPDX-License-Identifier: GPL-2.0-or-later
// Each contact is measured by the friction of its own two atom types.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "../synthetic_packing.h"
#include "analysis/contact_forces.h"
#include "liggghts_run.h"
#include "table.h"

namespace {
using namespace rodpack;
using rodpack::test::frame_head;
using rodpack::test::fresh_folder;
using rodpack::test::put;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// A contact with a normal force of 2 N along x, of spheres of two types, or of one and a wall.
struct TypedContact {
  int type_i, type_j;
  double tangential;  // N, along y
  bool wall = false;
};

// Each is one of two other bodies, at x = 0.1 and 0.103 m and as many millimetres up as its number.
std::string contacts_text(const std::vector<TypedContact>& contacts) {
  std::ostringstream rows;
  int number = 0;
  for (const auto& [type_i, type_j, tangential, wall] : contacts) {
    const int i = 2 * ++number - 1, j = wall ? 0 : i + 1;
    const double y = 5e-3 * number;
    rows << i << ' ' << j << ' ' << i << ' ' << j << ' ' << wall << " 0.1015 " << y << " 0 -2 "
         << tangential << " 0 0.1 " << y << " 0 0.103 " << y << " 0 1e-6 0 -1 0 0 " << type_i << ' '
         << type_j << '\n';
  }
  return frame_head(7, contacts.size(), 0.3, 0.3,
                    "body_i body_j sphere_i sphere_j wall x y z fx fy fz bix biy biz bjx bjy bjz "
                    "overlap_n overlap_t nx ny nz type_i type_j") +
         rows.str();
}

const FrictionTable table{{0.5, 0.25, 0.8}, {0.25, 0.1, 0}, {0.8, 0, 0.4}};

// Mobilised: half of mu = 0.5; half of 0.25 either way round, and all of it; all of 0.1; the wall's
// 0.8 a quarter. Of 2 and 3 there is no friction.
const std::vector<TypedContact> mixed{{1, 1, 0.5}, {1, 2, 0.25}, {2, 1, 0.25},     {2, 1, 0.6},
                                      {2, 2, 0.2}, {2, 3, 0.1},  {1, 3, 0.4, true}};

Frame frame_of(const std::vector<TypedContact>& contacts) {
  return last_frame({put(fresh_folder() / "contacts.7.dump", contacts_text(contacts))});
}

TEST(FrictionByType, EachContactIsMeasuredByItsOwnPair) {
  ContactForceOptions options;
  options.friction.table = table;
  const auto frame = frame_of(mixed);
  auto friction = *measure_contact_forces(frame, nullptr, options).friction;
  EXPECT_NEAR(friction.mean, (0.5 + 0.5 + 0.5 + 1 + 1) / 5, 1e-12);
  EXPECT_NEAR(friction.sliding_fraction, 0.4, 1e-12);
  EXPECT_EQ(friction.frictionless, 1U);
  EXPECT_EQ(friction.lowest, 0.1);
  EXPECT_EQ(friction.highest, 0.5);
  ASSERT_EQ(friction.by_type.size(), 3U);
  const auto& mixed_pair = friction.by_type[1];
  EXPECT_EQ(mixed_pair.lower_type, 1);
  EXPECT_EQ(mixed_pair.upper_type, 2);
  EXPECT_EQ(mixed_pair.coefficient, 0.25);
  EXPECT_EQ(mixed_pair.contacts, 3U);
  EXPECT_NEAR(mixed_pair.mean, 2.0 / 3, 1e-12);
  EXPECT_NEAR(mixed_pair.sliding_fraction, 1.0 / 3, 1e-12);
  EXPECT_EQ(friction.by_type[2].sliding_fraction, 1);

  options.walls_too = true;
  friction = *measure_contact_forces(frame, nullptr, options).friction;
  EXPECT_NEAR(friction.mean, (3.5 + 0.25) / 6, 1e-12);
  EXPECT_EQ(friction.highest, 0.8);
  ASSERT_EQ(friction.by_type.size(), 4U);
  EXPECT_EQ(friction.by_type[2].upper_type, 3);  // 1 and the wall
}

TEST(FrictionByType, ContactsWithoutAnyHaveNone) {
  ContactForceOptions options;
  options.friction.table = table;
  const auto forces = measure_contact_forces(frame_of({{2, 3, 0.1}}), nullptr, options);
  EXPECT_FALSE(forces.friction);
  EXPECT_THAT(forces.why_no_friction, HasSubstr("have friction 0"));
}

// 0 is a wall whose type is not told: its friction is known where all types' is the same.
TEST(FrictionByType, UnknownTypesAreRefusedByName) {
  ContactForceOptions options;
  options.walls_too = true;
  options.friction.table = table;
  const auto refusal = [&](const TypedContact& contact) -> std::string {
    try {
      measure_contact_forces(frame_of({{1, 1, 0}, contact}), nullptr, options);
    } catch (const DataError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(refusal({1, 4, 0}),
              HasSubstr("contacts.7.dump:11: column 'type_j': expected an atom type of the scene's "
                        "friction, 1 to 3, found 4"));
  EXPECT_THAT(refusal({0, 1, 0}), HasSubstr("column 'type_i'"));
  EXPECT_THAT(refusal({1, 0, 0}), HasSubstr("column 'type_j'"));
  EXPECT_THAT(refusal({1, 0, 0, true}),
              HasSubstr("contacts.7.dump:11: expected the wall's atom type, since spheres of type "
                        "1 have another friction with each, found none"));
  options.friction.table[0] = {0.25, 0.25, 0.25};
  EXPECT_EQ(refusal({1, 0, 0, true}), "");
  options.friction.table[0][0] = -1;
  EXPECT_THAT(refusal({1, 1, 0}), HasSubstr("expected a value of at least 0, found -1"));
}

TEST(FrictionByType, IsReadFromTheSceneByForcesAndAnalyse) {
  const auto folder = fresh_folder();
  nlohmann::json scene{{"format", "rodpack-scene 1"},
                       {"units", "si"},
                       {"timestep", 7},
                       {"timestep_s", 1e-5},
                       {"walls", {}},
                       {"templates", {}},
                       {"gravity_m_s2", {0, -9.81, 0}},
                       {"friction", table}};
  scene["walls"] = nlohmann::json::array();
  put(folder / "mine/scene.7.json", scene.dump());
  put(folder / "mine/contacts.7.dump", contacts_text(mixed));
  std::string bodies;
  for (int id = 1; id <= 14; ++id) {
    const int pair = (id + 1) / 2;
    bodies += std::to_string(id) + " 1 1 " + (id % 2 == 1 ? "0.1 " : "0.103 ") +
              std::to_string(5e-3 * pair) + " 0 0 0 0 0 0 0 0 1 0 0 0 1.5e-3 1.5e-3 0 7e-6 3e-5\n";
  }
  put(folder / "mine/bodies.7.dump",
      frame_head(7, 14, 0.3, 0.3,
                 "id type nspheres x y z angle vx vy vz omegax omegay omegaz qw qx qy qz "
                 "half_length radius curvature area mass") +
          bodies);
  const auto run = [&](const std::string& arguments) {
    const auto result = rodpack::test::run_rodpack(arguments, folder);
    EXPECT_EQ(result.exit_code, 0) << result.output;
    return result.output;
  };
  auto said = run("forces mine/contacts.7.dump -o f");
  EXPECT_THAT(said, AllOf(HasSubstr("mobilised friction: mean 0.7, sliding 0.4 of the contacts; mu "
                                    "= 0.1 to 0.5\n"),
                          HasSubstr("  atom types 1 and 2, mu 0.25: 3 contacts, mean 0.6667, "
                                    "sliding 0.3333\n"),
                          HasSubstr("  left out: 1 contacts of friction 0\n"),
                          HasSubstr("f_friction_types.csv")));
  const auto types = rodpack::test::read_table(folder / "f_friction_types.csv");
  EXPECT_THAT(types.column("contacts"), testing::ElementsAre(1, 3, 1));
  EXPECT_THAT(types.column("friction"), testing::ElementsAre(0.5, 0.25, 0.1));

  run("analyse mine");
  const auto summary =
      nlohmann::json::parse(rodpack::test::text_of(folder / "mine/analysis/summary.json"));
  EXPECT_NEAR(summary["mobilised_friction_mean"].get<double>(), 0.7, 1e-12);
  ASSERT_EQ(summary["friction_by_type"].size(), 3U);
  EXPECT_EQ(summary["friction_by_type"][1]["types"], nlohmann::json({1, 2}));
  EXPECT_EQ(summary["friction_by_type"][1]["contacts"], 3);
  EXPECT_EQ(rodpack::test::text_of(folder / "mine/analysis/forces_friction_types.csv"),
            rodpack::test::text_of(folder / "f_friction_types.csv"));

  // One for all, as the user says, has no such table, and leaves none of before.
  said = run("forces mine/contacts.7.dump --friction 0.5 -o one");
  EXPECT_THAT(said, AllOf(HasSubstr("mu = 0.5\n"), Not(HasSubstr("atom types"))));
  run("analyse mine --friction 0.5");
  EXPECT_FALSE(std::filesystem::exists(folder / "mine/analysis/forces_friction_types.csv"));
}

}  // namespace
