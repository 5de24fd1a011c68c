// SPDX-License-Identifier: GPL-2.0-or-later
// What a dump may hold: everything else is refused with file, line, value and expectation.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "liggghts_run.h"
#include "reading/dump.h"
#include "../synthetic_packing.h"

namespace {
using namespace rodpack;
using rodpack::test::frame_head;
using rodpack::test::fresh_folder;
using rodpack::test::put;
using testing::ElementsAre;
using testing::HasSubstr;

// Text of the error of reading `content` and taking the column, behind the file's name.
std::string error_of(const std::string& content, const std::string& column) {
  const auto file = put(fresh_folder() / "a.dump", content);
  try {
    last_frame({file}).column(column);
  } catch (const DataError& error) {
    const std::string text = error.what();
    EXPECT_EQ(text.rfind(file, 0), 0U) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    return text.substr(file.size());
  }
  return "no error";
}

std::string with_box(const std::string& flags, const std::string& x, const std::string& y) {
  return "ITEM: TIMESTEP\n1\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS" + flags + "\n" + x + "\n" +
         y + "\n-0.01 0.01\nITEM: ATOMS id x\n1 0.05\n";
}

// A row of one column "name" in the box 0 ... 0.3, 0 ... 2.
std::string with_value(const std::string& name, const std::string& value) {
  return error_of(frame_head(1, 1, 0.3, 2, "tag " + name) + "1 " + value + "\n", name);
}

TEST(DumpLimits, BoxesThatAreNotUprightAreRefusedInEveryForm) {
  EXPECT_EQ(error_of(with_box(" ff ff ff", "0 0.1", "0 0.1"), "x"), "no error");
  EXPECT_EQ(error_of(with_box("", "0 0.1", "0 0.1"), "x"), "no error");
  // The old form has the tilt behind the bounds, the newer ones have names as well, and LAMMPS's
  // general boxes four numbers in a line.
  EXPECT_THAT(
      error_of(with_box(" ", "-0.01 0.07 0.01", "0 0.1 0"), "x"),
      HasSubstr(":6: expected two numbers (the bounds of an upright box), found '-0.01 0.07 "
                "0.01' (a tilted box?)"));
  for (const std::string flags :
       {" xy xz yz ff ff ff", " xy xz yz", " abc origin ff ff ff", " abc origin", " ff ff", " xx"})
    EXPECT_THAT(error_of(with_box(flags, "0 0.1 0.01", "0 0.1 0"), "x"),
                HasSubstr(":5: expected the three boundary flags of an upright box"))
        << flags;
  EXPECT_THAT(error_of(with_box(" ff ff ff", "0 0.1", "0.1 0"), "x"),
              HasSubstr(":7: expected box bounds lo < hi within -1000000 to 1000000 m"));
  EXPECT_THAT(error_of(with_box(" ff ff ff", "0 1e300", "0 0.1"), "x"), HasSubstr(":6: expected"));
}

TEST(DumpLimits, SignsAreReadAndUnitsThatAreNotSiRefused) {
  const auto file = put(fresh_folder() / "a.dump", "ITEM: UNITS\nsi\nITEM: TIME\n+0.5\n" +
                                                       frame_head(1, 1, 0.3, 2, "id x y") +
                                                       "+1 +2.5e-03 -1e-3\n");
  const Frame frame = last_frame({file});
  EXPECT_THAT(frame.column("x"), ElementsAre(2.5e-3));
  EXPECT_THAT(frame.column("y"), ElementsAre(-1e-3));
  EXPECT_EQ(with_value("v", "+-1"), ":10: column 'v': expected a finite number, found '+-1'");
  EXPECT_EQ(with_value("v", "++1"), ":10: column 'v': expected a finite number, found '++1'");
  EXPECT_EQ(error_of("ITEM: UNITS\ncgs\n" + frame_head(1, 0, 0.3, 2, "id"), "id"),
            ":2: expected a dump in SI units ('si'), found units 'cgs'");
}

TEST(DumpLimits, PlacesHaveToLieAboutTheBox) {
  EXPECT_EQ(with_value("y", "3.9"), "no error");  // the image of a body across a periodic border
  EXPECT_EQ(with_value("y", "1e18"),
            ":10: column 'y': expected a number of -2 to 4 (up to a box size outside the box), "
            "found '1e18'");
  for (const std::string name : {"x", "z", "bix", "biy", "biz", "bjx", "bjy", "bjz"})
    EXPECT_THAT(with_value(name, "1e6"), HasSubstr("outside the box), found '1e6'")) << name;
}

TEST(DumpLimits, EveryColumnHasARange) {
  for (const std::string name : {"radius", "half_length", "mass", "area"})
    for (const std::string value : {"-1", "0", "1e308"})
      EXPECT_THAT(with_value(name, value),
                  HasSubstr(":10: column '" + name + "': expected a number of 1e-"))
          << name << ' ' << value;
  for (const std::string name : {"vx", "omegaz", "fy", "overlap_n", "overlap_t", "fsum", "angle",
                                 "curvature", "qw", "nx", "id", "body_i", "sphere_j", "type"})
    EXPECT_THAT(with_value(name, "-1e308"), HasSubstr("expected a ")) << name;
  EXPECT_THAT(with_value("nspheres", "2.5"), HasSubstr("expected a whole number of 1 to 1000000"));
  EXPECT_THAT(with_value("wall", "2"), HasSubstr("expected a whole number of 0 to 1"));
  EXPECT_EQ(with_value("anything", "-1e308"), "no error");
  EXPECT_THAT(with_value("anything", "1e309"), HasSubstr("expected a finite number"));
  for (const std::string value : {"nan", "-nan", "inf", "0x10", "1e400", "1,5", "1d5", "--1"})
    EXPECT_THAT(with_value("y", value), HasSubstr("expected a finite number, found '" + value))
        << value;
}

TEST(DumpLimits, TimestepsAreExactAsDouble) {
  EXPECT_EQ(error_of(frame_head(9007199254740992, 1, 0.3, 2, "id x") + "1 0\n", "x"), "no error");
  EXPECT_THAT(error_of(frame_head(9000000000000000000, 0, 0.3, 2, "id x"), "x"),
              HasSubstr(":2: expected a timestep of at most 9007199254740992"));
  EXPECT_THAT(error_of("ITEM: TIMESTEP\n99999999999999999999\n", "x"), HasSubstr(":2: expected"));
}

TEST(DumpLimits, AFrameOfMoreNumbersThanMemoryIsMeantForIsRefusedBeforeItsRows) {
  EXPECT_EQ(error_of(frame_head(1, 125000001, 0.3, 2, "id x") + "1 0\n", "x"),
            ":9: expected a frame of at most 250000000 numbers, found one of 125000001 rows and 2 "
            "columns");
  EXPECT_THAT(error_of(frame_head(1, 125000000, 0.3, 2, "id x") + "1 0\n", "x"),
              HasSubstr(":10: the frame is cut short here: expected 125000000 rows, found 1"));
}

TEST(DumpLimits, BytesThatAreNoTextAreRefused) {
  const std::string nul(1, '\0');
  EXPECT_EQ(error_of(frame_head(1, 2, 0.3, 2, "id x") + "1 0\n" + nul + "2 0\n", "x"),
            ":11: expected text, found a NUL character: the file is damaged, or no text dump");
  EXPECT_THAT(error_of(nul + "\n", "x"), HasSubstr(":1: expected text, found a NUL"));
  EXPECT_THAT(error_of(std::string(3000000, '7'), "x"), HasSubstr("found a longer one"));
  EXPECT_THAT(error_of(frame_head(1, 1, 0.3, 2, "id x") + "1 0\x1b[2J\n", "x"),
              HasSubstr("found '0?[2J'"));
}

TEST(DumpLimits, ALastNumberWithoutLineEndMayBeCut) {
  EXPECT_EQ(error_of(frame_head(1, 1, 0.3, 2, "id x") + "1 0.12", "x"),
            ":10: the file is cut short here: this line has no line end");
}

TEST(DumpLimits, ColumnsParticlesAndContactsStandOnce) {
  EXPECT_EQ(error_of(frame_head(1, 0, 0.3, 2, "id x y x"), "x"),
            ":9: expected each column once, found 'x' twice");
  EXPECT_EQ(error_of(frame_head(1, 3, 0.3, 2, "id x") + "7 0\n8 0.1\n7 0.2\n", "x"),
            ":12: expected each particle once, found id 7 of line 10 again");
  const std::string columns = "body_i body_j sphere_i sphere_j wall x y z";
  EXPECT_EQ(error_of(frame_head(1, 2, 0.3, 2, columns) + "1 2 3 4 0 0 0 0\n1 2 3 4 0 0 0 0\n", "x"),
            ":11: expected each contact once, found that of line 10 again");
  // One sphere may touch two walls.
  EXPECT_EQ(error_of(frame_head(1, 2, 0.3, 2, columns) + "1 0 3 0 1 0 0 0\n1 0 3 0 1 0 1 0\n", "x"),
            "no error");
}

}  // namespace
