// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "liggghts_run.h"
#include "reading/data_error.h"
#include "synthetic_packing.h"

namespace {
using rodpack::DataError;
using rodpack::read_table;
using rodpack::test::fresh_folder;
using rodpack::test::put;
using testing::ElementsAre;

std::string written(const std::string& text) { return put(fresh_folder() / "t.csv", text); }

// Text of the error that reading `text` and then `use` gives, without the file's name.
std::string error_of(const std::string& text,
                     const std::function<void(const rodpack::Table&)>& use = {},
                     const std::string& header = "") {
  const auto file = written(text);
  try {
    const auto table = read_table(file, header);
    if (use) use(table);
  } catch (const DataError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.rfind(file, 0), 0U) << "does not start with the file's name: " << message;
    return message.substr(file.size());
  }
  return "no error";
}

TEST(TableReader, ColumnsOfNumbersAndWordsAreFoundByNameBetweenCommas) {
  const auto table =
      read_table(written("name,error,steps\r\nab3, 1e-3 ,10\r\n\r\nbuiltin,inf,-7\n"));
  EXPECT_EQ(table.rows(), 2U);
  EXPECT_THAT(table.names(), ElementsAre("name", "error", "steps"));
  EXPECT_THAT(table.column("error"), ElementsAre(1e-3, INFINITY));
  EXPECT_THAT(table.whole_numbers("steps"), ElementsAre(10, -7));
  EXPECT_THAT(table.words("name"), ElementsAre("ab3", "builtin"));
  EXPECT_THAT(table.words("error"), ElementsAre("1e-3", "inf"));
}

// As `fix ave/time` writes it, with a title before the names, and `fix print` with `title`.
TEST(TableReader, NamesStandInTheLastCommentBeforeTheRowsOrInTheFirstLine) {
  const auto averaged =
      read_table(written("# Time-averaged data\n# TimeStep c_ke\n 7\t8\n# end\n"));
  EXPECT_THAT(averaged.names(), ElementsAre("TimeStep", "c_ke"));
  EXPECT_THAT(averaged.column("c_ke"), ElementsAre(8));
  // A title may say a word twice, as that of a fix called 'data' does: it names no columns.
  EXPECT_THAT(read_table(written("# Time-averaged data for fix data\n# t ke\n1 2\n")).names(),
              ElementsAre("t", "ke"));
  EXPECT_THAT(read_table(written("out\n1e-4\n -2e-4\n")).column("out"), ElementsAre(1e-4, -2e-4));
}

TEST(TableReader, AnEmptyFieldIsAFieldThatIsNoNumber) {
  const auto table = read_table(written("quantity,builtin,exact\nmass,1.5,\n"));
  EXPECT_THAT(table.words("exact"), ElementsAre(""));
  EXPECT_THAT(table.column("builtin"), ElementsAre(1.5));
  EXPECT_EQ(error_of("a,b\n1,\n", [](const auto& t) { t.column("b"); }),
            ":2: expected a number, found '' (column 'b')");
}

TEST(TableReader, ErrorsNameFileLineColumnValueAndExpectation) {
  const auto column = [](const char* name) {
    return [name](const rodpack::Table& table) { table.column(name); };
  };
  EXPECT_EQ(error_of("a,b\n1,2\n3,4x\n", column("b")),
            ":3: expected a number, found '4x' (column 'b')");
  EXPECT_EQ(error_of("a,b\n1,2\n3,4x\n", column("a")), "no error");
  EXPECT_EQ(error_of("a,b\n1,2\n", column("c")), ":1: no column 'c'; the columns are: a b");
  EXPECT_EQ(error_of("# title\n# a b\n1 2\n", column("c")),
            ":2: no column 'c'; the columns are: a b");
  EXPECT_EQ(error_of("a,b\n1,2\n\n3\n"), ":4: expected a,b, found '3'");
  EXPECT_EQ(error_of("a,b\n1,2,3\n"), ":2: expected a,b, found '1,2,3'");
  EXPECT_EQ(error_of(""), ":1: expected a line with the names of the columns, found an empty file");
  EXPECT_EQ(error_of("a,c\n1,2\n", {}, "a,b"), ":1: expected a,b, found 'a,c'");
  EXPECT_EQ(error_of("#\n1 2\n"),
            ":2: expected a line with the names of the columns first, found '1 2'");
  EXPECT_EQ(error_of("a\n1\n2.5\n", [](const auto& t) { t.whole_numbers("a"); }),
            ":3: expected a whole number, found '2.5' (column 'a')");
  EXPECT_EQ(error_of("a\nmaybe\n", [](const auto& t) { t.refuse(0, "a", "yes or no"); }),
            ":2: expected yes or no, found 'maybe' (column 'a')");
  EXPECT_THROW(read_table("no/such/file"), DataError);
}

}  // namespace
