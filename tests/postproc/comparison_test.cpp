// SPDX-License-Identifier: GPL-2.0-or-later
#include "campaigns/comparison/comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sched.h>

#include <cmath>

#include "liggghts_run.h"
#include "campaigns/launch/deck_folder.h"
#include "campaigns/launch/step_timing.h"
#include "synthetic_packing.h"

namespace {
using namespace rodpack;
using rodpack::test::fresh_folder;
using rodpack::test::put;
using testing::HasSubstr;
namespace fs = std::filesystem;

std::string message_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const DataError& error) {
    return error.what();
  }
  return "no error";
}

// Two bodies that stay where they are but for `drift(frame)`, added to x and y of the second one.
BodyHistory history(const std::function<double(std::size_t)>& drift, std::size_t frames = 6) {
  BodyHistory result;
  result.body = {1, 7};
  for (std::size_t frame = 0; frame < frames; ++frame) {
    result.time.push_back(0.5 * static_cast<double>(frame));
    result.x.push_back({0.1, 0.2 + 3 * drift(frame)});
    result.y.push_back({0.1, 0.2 - 4 * drift(frame)});
    result.angle.push_back({0, 1});
    result.potential.push_back(0);
  }
  return result;
}
BodyHistory resting() {
  return history([](std::size_t) { return 0.0; });
}

// The second body is 3-4-5 away: 5 * 2^-10 frame^2 m, i.e. 5/1024 * (0, 1, 4, 9, 16, 25).
BodyHistory drifting() {
  return history([](std::size_t frame) { return std::pow(frame, 2) / 1024; });
}

TEST(Comparison, RunsPartAtTheFirstFrameWhoseLargestDistanceExceedsTheLimit) {
  const auto separation = separate(drifting(), resting(), 5 * 8.5 / 1024);
  ASSERT_TRUE(separation.parted);
  EXPECT_EQ(*separation.parted, 3U);
  EXPECT_EQ(separation.parting_time(), 1.5);
  EXPECT_EQ(separation.time, resting().time);
  for (std::size_t frame = 0; frame < 6; ++frame) {
    const double distance = 5 * std::pow(frame, 2) / 1024;
    EXPECT_NEAR(separation.largest[frame], distance, 1e-15);
    // one of two bodies moves: the mean of the squares is half of its square
    EXPECT_NEAR(separation.rms[frame], distance / std::sqrt(2), 1e-15);
  }
}

TEST(Comparison, RunsThatStayWithinTheLimitNeverPart) {
  EXPECT_FALSE(separate(drifting(), resting(), 5 * 25.5 / 1024).parting_time());
  EXPECT_FALSE(separate(resting(), resting(), 0).parting_time());
}

TEST(Comparison, RunsOfOtherBodiesOrTimesAreRefused) {
  auto other = resting();
  other.body = {1, 8};
  EXPECT_THAT(message_of([&] { separate(resting(), other, 1); }),
              HasSubstr("expected the same bodies, found 2 and 2, or other ids"));
  const auto shorter = history([](std::size_t) { return 0.0; }, 4);
  EXPECT_THAT(message_of([&] { separate(resting(), shorter, 1); }),
              HasSubstr("found 6 frames up to 2.5 s and 4 up to 1.5 s"));
}

const std::string columns = "id x y z angle vx vy vz omegax omegay omegaz qw qx qy qz mass";

TEST(Comparison, HistoryReadsTimesHeightsAndWhatLeavesThePlane) {
  const auto file = fresh_folder() / "bodies.dump";
  // Second frame: body 2 has turned by -0.2 rad about y, which lifts its x axis by 0.2 rad.
  const std::string turned = std::to_string(std::cos(0.1)) + " 0 " + std::to_string(-std::sin(0.1));
  put(file, test::frame_head(0, 2, 1, 1, columns) +
                "1 0.1 0.2 0.001 0 0 0 0 0 0 0 1 0 0 0 2\n"
                "2 0.3 0.4 0.002 1 0 0 0 0 0 0 1 0 0 0 3\n" +
                test::frame_head(50, 2, 1, 1, columns) +
                "1 0.1 0.1 0.001 0 9 9 -5 0 -7 0 1 0 0 0 2\n"
                "2 0.3 0.4 -0.002 1 9 9 4 6 0 -8 " +
                turned + " 0 3\n");
  const auto read = read_body_history({file.string()}, 1e-3, 10);
  EXPECT_EQ(read.body, (std::vector<double>{1, 2}));
  EXPECT_EQ(read.time, (std::vector<double>{0, 0.05}));
  EXPECT_EQ(read.y[1], (std::vector<double>{0.1, 0.4}));
  EXPECT_NEAR(read.potential[0], 10 * (2 * 0.2 + 3 * 0.4), 1e-12);
  EXPECT_NEAR(read.potential[1], 10 * (2 * 0.1 + 3 * 0.4), 1e-12);
  EXPECT_NEAR(read.leak.z, 0.004, 1e-15);
  EXPECT_EQ(read.leak.vz, 5);
  EXPECT_EQ(read.leak.omega_x, 6);
  EXPECT_EQ(read.leak.omega_y, 7);
  EXPECT_EQ(read.leak.omega_z, 8);
  EXPECT_NEAR(read.leak.tilt, 0.2, 1e-5);  // to_string gives six digits
}

TEST(Comparison, ALostBodyIsNamedWithFileAndLine) {
  const auto file = fresh_folder() / "bodies.dump";
  const std::string row = " 0 0 0 0 0 0 0 0 0 0 1 0 0 0 1\n";
  put(file, test::frame_head(0, 2, 1, 1, columns) + "1" + row + "2" + row +
                test::frame_head(50, 1, 1, 1, columns) + "1" + row);
  EXPECT_THAT(message_of([&] { read_body_history({file.string()}, 1, 1); }),
              HasSubstr("bodies.dump:20: expected the 2 bodies of the first frame in their order, "
                        "found 1 bodies, or other ones, at timestep 50"));
}

Comparison synthetic_comparison() {
  Comparison comparison;
  for (auto* run : {&comparison.builtin, &comparison.rodpack, &comparison.sampled}) {
    run->bodies = resting();
    for (auto* series : {&run->series.kinetic_translational, &run->series.kinetic_rotational,
                         &run->series.elastic_normal, &run->series.elastic_tangential,
                         &run->series.sphere_contacts})
      *series = {1, 2, 3, 4, 5, 6};
  }
  comparison.builtin.name = "builtin";
  comparison.rodpack.name = "rodpack";
  comparison.sampled.name = "builtin_sampled";
  comparison.builtin.bodies = drifting();
  comparison.builtin.bodies.potential = {0, 0, 0, 0, 0, 0.5};
  comparison.exact = {2, {3, 4, 5}};
  comparison.rodpack.mass = 2;
  comparison.limit = 5 * 8.5 / 1024;
  comparison.particle_diameter = 1;
  comparison.builtin_rodpack =
      separate(comparison.builtin.bodies, comparison.rodpack.bodies, comparison.limit);
  comparison.sampled_rodpack =
      separate(comparison.sampled.bodies, comparison.rodpack.bodies, comparison.limit);
  comparison.step_times = {{"falling", {4, 1, 2, 9, 3}, {6, 6, 6, 1, 60}}};
  return comparison;
}

const ComparisonRow& row(const std::vector<ComparisonRow>& rows, const std::string& quantity) {
  for (const auto& each : rows)
    if (each.quantity == quantity) return each;
  throw std::out_of_range("no row " + quantity);
}

TEST(Comparison, RowsHoldPartingMassesEnergiesAndTheRatioOfMedians) {
  const auto rows = comparison_rows(synthetic_comparison());
  EXPECT_EQ(row(rows, "parting_time_from_rodpack").builtin, 1.5);
  EXPECT_FALSE(row(rows, "parting_time_from_rodpack").sampled);
  EXPECT_EQ(row(rows, "mass").rodpack, 2);
  EXPECT_EQ(row(rows, "mass").exact, 2);
  EXPECT_EQ(row(rows, "inertia_across_2").exact, 5);
  EXPECT_EQ(row(rows, "kinetic_energy_at_the_start").builtin, 1 + 1);
  EXPECT_EQ(row(rows, "total_energy_at_the_end").builtin, 6 + 6 + 6 + 6 + 0.5);
  EXPECT_FALSE(row(rows, "contacts_per_particle").builtin);
  EXPECT_EQ(row(rows, "time_per_step_falling").builtin, 3);
  EXPECT_EQ(row(rows, "time_per_step_falling").rodpack, 6);
  EXPECT_EQ(row(rows, "time_per_step_over_builtin_falling").rodpack, 2);
}

TEST(Comparison, TrajectoriesEndWithTheFrameOfTheParting) {
  const auto folder = fresh_folder();
  write_trajectories(synthetic_comparison(), (folder / "t.csv").string());
  const auto table = test::read_table(folder / "t.csv");
  ASSERT_EQ(table.rows(), 2U * 4);  // two bodies, frames 0 to 3
  EXPECT_EQ(table.column("time_s").back(), 1.5);
  EXPECT_EQ(table.column("body").back(), 7);
  EXPECT_NEAR(table.column("builtin_x_m").back(), 0.2 + 3 * 9. / 1024, 1e-9);
  EXPECT_NEAR(table.column("builtin_y_m").back(), 0.2 - 4 * 9. / 1024, 1e-9);
  EXPECT_NEAR(table.column("rodpack_x_m").back(), 0.2, 1e-9);
  EXPECT_NEAR(table.column("rodpack_angle_deg").back(), 57.29577951, 1e-7);
}

TEST(Comparison, TableLeavesEmptyWhatDoesNotExist) {
  const auto folder = fresh_folder();
  const auto rows = comparison_rows(synthetic_comparison());
  write_comparison(rows, (folder / "c.csv").string());
  std::ifstream in(folder / "c.csv");
  std::string head, first;
  std::getline(in, head);
  std::getline(in, first);
  EXPECT_EQ(head, "quantity,unit,builtin,rodpack,builtin_sampled,exact");
  EXPECT_EQ(first, "parting_time_from_rodpack,s,1.5,,,");
  EXPECT_THAT(comparison_text(rows), HasSubstr("\nmass "));
}

TEST(StepTiming, TimeIsThatOfTheLastLoop) {
  EXPECT_EQ(time_per_step("Loop time of 9 on 1 procs for 3 steps with 4 atoms\nx\n"
                          "Loop time of 2.5 on 2 procs for 5 steps with 4 atoms, finish time\n"),
            0.5);
  EXPECT_THAT(message_of([] { time_per_step("nothing"); }), HasSubstr("'Loop time of"));
  EXPECT_THAT(message_of([] { time_per_step("Loop time of 1 on 1 procs for 0 steps"); }),
              HasSubstr("'Loop time of"));
}

TEST(StepTiming, MedianIsTheMiddleOfTheSortedValues) {
  EXPECT_EQ(median({5, 1, 100}), 5);
  EXPECT_EQ(median({5, 1, 100, 7}), 6);
  EXPECT_THAT(message_of([] { median({}); }), HasSubstr("expected at least one value"));
}

TEST(StepTiming, TurnsAreReversedEveryOtherRound) {
  std::string order;
  const auto values = measure_in_turns(2, 3, [&](int who, int round) {
    order += static_cast<char>('a' + who);
    return 10 * who + round;
  });
  EXPECT_EQ(order, "abbaab");
  EXPECT_EQ(values, (std::vector<std::vector<double>>{{0, 1, 2}, {10, 11, 12}}));
}

TEST(StepTiming, PinBindsToSoManyProcessorsAndGivesThemBack) {
  const auto count = [] {
    cpu_set_t set;
    sched_getaffinity(0, sizeof set, &set);
    return CPU_COUNT(&set);
  };
  const int before = count();
  {
    const ProcessorPin pin(1);
    EXPECT_EQ(count(), 1);
    EXPECT_FALSE(pin.processors().empty());
  }
  EXPECT_EQ(count(), before);
  EXPECT_THAT(message_of([&] { ProcessorPin(before + 1); }),
              HasSubstr(std::to_string(before + 1) + " ranks, found " + std::to_string(before)));
}

TEST(DeckFolder, DeckIsThatOfTheRepositoryOrWhereItIsSaid) {
  const std::string name = "comparison/in.comparison";
  const auto folder = fresh_folder();
  put(folder / name, "print 1\n");
  EXPECT_EQ(find_deck(name, folder.string()), (folder / name).string());
  EXPECT_TRUE(fs::equivalent(find_deck(name, ""), fs::path(RODPACK_REPOSITORY) / "inputs" / name));
  EXPECT_EQ(message_of([&] { find_deck("none", folder.string()); }),
            folder.string() + ": expected a folder with the deck none");
  EXPECT_THAT(message_of([] { find_deck("none", ""); }), HasSubstr("no deck inputs/none above "));
}

auto compare_command(const std::string& arguments, const fs::path& folder) {
  return test::run_rodpack("compare " + arguments, folder);
}

TEST(CompareCommand, NothingIsOverwritten) {
  const auto folder = fresh_folder();
  put(folder / "old" / "compare.csv", "mine");
  put(folder / "other" / "notes.txt", "mine");
  put(folder / "file", "mine");
  const auto refused = [&](const std::string& out, const std::string& what) {
    const auto run = compare_command(out + " --liggghts /bin/true", folder);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_EQ(run.output, "rodpack: " + out + ": expected a new or empty folder, found " + what +
                              "; nothing is overwritten\n");
  };
  refused("old", "a comparison");
  refused("other", "other files");
  refused("file", "a file");
}

TEST(CompareCommand, WrongUsageExitsWithTwo) {
  const auto folder = fresh_folder();
  EXPECT_EQ(compare_command("--help", folder).exit_code, 0);
  for (const std::string wrong :
       {"", "out --particles 1", "out --time 0", "out --seed 0", "out --rounds 4", "out --ranks 0",
        "out --liggghts none", "out --inputs none", "out --limit 0", "out --every 0"})
    EXPECT_EQ(compare_command(wrong, folder).exit_code, 2) << wrong;
  EXPECT_FALSE(fs::exists(folder / "out"));
}

}  // namespace
