// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/dump.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include "liggghts_run.h"
#include "synthetic_packing.h"

namespace {
using namespace rodpack;
using rodpack::test::frame_head;
using rodpack::test::fresh_folder;
using rodpack::test::put;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;

// Text of the error that reading every frame of `content` and taking column x gives.
std::string error_of(const std::string& content, const std::string& column = "x") {
  const auto file = put(fresh_folder() / "a.dump", content);
  try {
    for_each_frame({file}, [&](const Frame& frame) { frame.column(column); });
  } catch (const DataError& error) {
    const std::string text = error.what();
    EXPECT_EQ(text.rfind(file, 0), 0U) << "does not start with the file's name: " << text;
    return text.substr(file.size());
  }
  return "no error";
}

std::string frame_of(long timestep, const std::string& rows, std::size_t count) {
  return frame_head(timestep, count, 0.3, 2, "id x y") + rows;
}

TEST(DumpReader, ColumnsAreFoundByNameInAnyOrder) {
  const auto folder = fresh_folder();
  const auto file = put(folder / "a.dump", frame_head(7, 2, 0.3, 2, "y element id x", "pp ff mm") +
                                               "1.5 Fe 1 -2e-3\n2.5 Si 2 4e-3\n");
  const Frame frame = last_frame({file});
  EXPECT_EQ(frame.timestep, 7);
  EXPECT_THAT(frame.column("x"), ElementsAre(-2e-3, 4e-3));
  EXPECT_THAT(frame.column("y"), ElementsAre(1.5, 2.5));
  EXPECT_THAT(frame.column("id"), ElementsAre(1, 2));
  EXPECT_EQ(frame.bounds[0][1], 0.3);
  EXPECT_EQ(frame.bounds[2][0], -0.01);
  EXPECT_THAT(frame.periodic, ElementsAre(true, false, false));
}

TEST(DumpReader, FramesOfOneFileComeInOrderAndEntriesAreRowsToo) {
  const auto file =
      put(fresh_folder() / "a.dump", frame_of(10, "1 0.1 0\n", 1) + frame_of(20, "", 0) +
                                         frame_head(30, 1, 0.3, 2, "body_i x") + "4 0.3\r\n");
  std::vector<long> steps;
  std::vector<std::size_t> rows;
  for_each_frame({file}, [&](const Frame& frame) {
    steps.push_back(frame.timestep);
    rows.push_back(frame.rows);
  });
  EXPECT_THAT(steps, ElementsAre(10, 20, 30));
  EXPECT_THAT(rows, ElementsAre(1, 0, 1));
  EXPECT_THAT(last_frame({file}).column("x"), ElementsAre(0.3));
}

TEST(DumpReader, GzipFilesReadLikePlainOnesAndADamagedOneIsReported) {
  const auto folder = fresh_folder();
  const auto file = (folder / "a.dump.gz").string();
  std::string rows;
  for (int i = 1; i <= 2000; ++i)
    rows += std::to_string(i) + " 0." + std::to_string(i * i) + " 1\n";
  const auto text = frame_of(5, rows, 2000);
  gzFile out = gzopen(file.c_str(), "wb");
  gzwrite(out, text.data(), static_cast<unsigned>(text.size()));
  gzclose(out);
  const Frame frame = last_frame({file});
  EXPECT_EQ(frame.rows, 2000U);
  EXPECT_EQ(frame.column("id").back(), 2000);

  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  try {
    last_frame({file});
    FAIL() << "half a file was read";
  } catch (const DataError& error) {
    EXPECT_THAT(error.what(), HasSubstr("damaged or cut short"));
  }
}

TEST(DumpReader, ErrorsNameFileLineWhatWasFoundAndWhatWasExpected) {
  EXPECT_EQ(error_of(frame_of(1, "1 0 0\n2 0 0\n", 3)),
            ":11: the frame is cut short here: expected 3 rows, found 2");
  EXPECT_EQ(error_of(frame_of(1, "1 0 0\n", 2) + frame_of(2, "", 0)),
            ":11: the frame has too few rows: expected 2 rows, found 1");
  EXPECT_EQ(error_of(frame_of(1, "1 0 0\n2 0 0\n", 1)),
            ":11: expected 'ITEM: TIMESTEP', found '2 0 0' (more rows than the frame's count "
            "states?)");
  EXPECT_EQ(error_of(frame_of(1, "1 0 0\n", 1), "angle"),
            ":9: no column 'angle'; the columns are: id x y");
  EXPECT_EQ(error_of(frame_of(1, "1 0 0\n2 0.1mm 0\n", 2)),
            ":11: column 'x': expected a finite number, found '0.1mm'");
  EXPECT_EQ(error_of(frame_of(1, "1 nan 0\n", 1)),
            ":10: column 'x': expected a finite number, found 'nan'");
  EXPECT_EQ(error_of(frame_of(1, "1 0\n", 1)), ":10: expected 3 fields, found 2");
  EXPECT_EQ(error_of(frame_of(1, "1 0 0 0\n", 1)), ":10: expected 3 fields, found more");
  EXPECT_EQ(error_of("ITEM: TIMESTEP\n5\n"),
            ":2: the frame is cut short here: expected 'ITEM: NUMBER OF '");
  EXPECT_EQ(error_of("ITEM: TIMESTEP\nfive\n"),
            ":2: expected a timestep (whole number), found 'five'");
  EXPECT_EQ(error_of("ITEM: TIMESTEP\n5\nITEM: NUMBER OF ATOMS\n-3\n"),
            ":4: expected the number of rows (whole number), found '-3'");
  EXPECT_EQ(error_of("LAMMPS data file\n"),
            ":1: expected 'ITEM: TIMESTEP', found 'LAMMPS data file'");
}

TEST(FindDumps, WildcardsAreOrderedByTimestepNotByName) {
  const auto folder = fresh_folder();
  for (const long step : {900L, 1000L, 20000L})
    put(folder / ("bodies." + std::to_string(step) + ".dump"), frame_of(step, "", 0));
  const auto files =
      find_dumps({(folder / "bodies.*.dump").string(), (folder / "bodies.900.dump").string()});
  EXPECT_THAT(files,
              ElementsAre(EndsWith(".900.dump"), EndsWith(".1000.dump"), EndsWith(".20000.dump")));
  EXPECT_EQ(last_frame(files).timestep, 20000);
}

TEST(FindDumps, MissingFilesAndEmptyMatchesAreErrors) {
  const auto folder = fresh_folder();
  const auto error = [](const std::string& name) -> std::string {
    try {
      find_dumps({name});
    } catch (const DataError& reason) {
      return reason.what();
    }
    return "no error";
  };
  const auto missing = (folder / "none.dump").string();
  EXPECT_EQ(error(missing), missing + ": no such file");
  const auto pattern = (folder / "*.dump").string();
  EXPECT_EQ(error(pattern), "no file matches '" + pattern + "'");
  const auto empty = put(folder / "empty.dump", "");
  EXPECT_EQ(error(empty), empty + ": no frame in this file");
  EXPECT_THAT(error(folder.string()), HasSubstr("is a folder"));
}

}  // namespace
