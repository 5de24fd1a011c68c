// SPDX-License-Identifier: GPL-2.0-or-later
// A restart file of the very step in which two spheres touch that have touched before: what they
// remember of the first time is no part of the second.
#include <gtest/gtest.h>

#include <string>

#include "deck.h"
#include "liggghts_run.h"
#include "table.h"

using namespace rodpack::test;

namespace {

/// Two spheres that spin fly into each other, are thrown back by the walls, and meet again within
/// one neighbour list; `lines` follow, where there is no restart file `from`.
std::string meeting(const std::string& motion, const std::string& lines, const std::string& from) {
  std::string particles =
      "fix ball all particletemplate/" +
      std::string(motion == "nve/sphere/ab"
                      ? "sphere 15485863 atom_type 1 density constant 2500 radius constant 1.5e-3\n"
                      : "multisphere/spherocylinder 1 atom_type 1 type 1 aspect_ratio 1 diameter "
                        "0.003 surface smooth density constant 2500 planar no\n") +
      "fix mix all particledistribution/discrete 15485867 1 ball 1.0\n";
  const auto flying = [](const std::string& id, double x, const std::string& velocity) {
    return one_particle(id, {x, 0, 0}, "vel constant " + velocity + " omega constant 5 20 30");
  };
  if (from.empty())
    particles += flying("1", -2e-3, "0.5 0 0.01") + flying("2", 2e-3, "-0.5 0.02 0");
  const std::string wall =
      " all wall/gran model spring_dashpot tangential spring_dashpot primitive type 1 xplane ";
  return Deck()
      .box("-0.02 0.02 -0.02 0.02 -0.02 0.02")
      .skin("0.009")
      .restart(from)
      .with("fix left" + wall + "-0.004\nfix right" + wall + "0.004\n" + particles +
            "fix motion all " + motion + "\ncompute ep all contact/energy\n" +
            (from.empty() ? "run 1\n" : "") + lines);
}

const std::string state =
    "\nwrite_dump all custom end.dump id x y z vx vy vz omegax omegay omegaz modify format \"%d "
    "%.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g\"\n";

/// The step in which the third time begins that something touches: first the spheres, then both the
/// walls, then the spheres again.
long second_meeting(const std::string& motion) {
  const auto run = run_liggghts(meeting(
      motion, "thermo_style custom step c_ep[1]\nthermo_modify norm no\nthermo 1\nrun 4000", ""));
  if (run.exit_code != 0) throw std::runtime_error(run.output);
  const Table thermo = read_thermo(run.output, -1);
  const auto& energy = thermo.column("ep[1]");
  int times = 0;
  for (std::size_t row = 1; row < energy.size(); ++row)
    if (energy[row] > 0 && energy[row - 1] == 0 && ++times == 3)
      return static_cast<long>(thermo.column("Step")[row]);
  throw std::runtime_error("the spheres do not meet again");
}

}  // namespace

TEST(TouchAtRestart, ASecondTouchInTheStepOfTheFileIsThatOfTheUninterruptedRun) {
  for (const std::string motion : {"nve/sphere/ab", "multisphere/ab order 3 planar no events no",
                                   "multisphere/ab order 3 planar no events yes"}) {
    SCOPED_TRACE(motion);
    const std::string step = std::to_string(second_meeting(motion));
    const auto whole =
        run_liggghts(meeting(motion, "restart " + step + " rest.*\nrun 4000 upto" + state, ""));
    ASSERT_EQ(whole.exit_code, 0) << whole.output;
    const Table expected = read_dump(whole.folder / "end.dump");
    const auto rest =
        run_liggghts_in(whole.folder, meeting(motion, "run 4000 upto" + state, "rest." + step));
    ASSERT_EQ(rest.exit_code, 0) << rest.output;
    const Table found = read_dump(whole.folder / "end.dump");
    for (const std::string& name : expected.names())
      EXPECT_EQ(found.column(name), expected.column(name)) << name;
  }
}
