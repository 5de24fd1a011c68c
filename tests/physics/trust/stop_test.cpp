// SPDX-License-Identifier: GPL-2.0-or-later
// The end of a run by one rank, which knows what the others do not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "deck.h"
#include "liggghts_run.h"

using namespace rodpack::test;
using testing::HasSubstr;

namespace {

std::string contents(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

// A pipe is written to by blocks, and MPI_Abort throws away what waits for its block to fill: the
// line has to be flushed first. Hence the program as a user starts it, without the line buffering
// of run_liggghts().
TEST(Stop, TheLineOfOneRankAndWhatCameBeforeArriveThroughAPipe) {
  const auto folder = fresh_folder();
  std::ofstream(folder / "in.deck") << Deck().hertz().with(R"(
create_atoms 1 single 0.05 0.05 0.004 units box
set group all diameter 0.003 density 2500
fix move all nve/sphere
fix plane all enforce2d/multisphere
print "said before"
run 0
)");
  const auto run = run_command(
      "OMPI_MCA_orte_tmpdir_base=\"$PWD\" OMPI_MCA_ess_singleton_isolated=1 "
      "'" RODPACK_BIN "/liggghts' -in in.deck | cat",
      folder);
  const std::string line =
      "ERROR on proc 0: Fix enforce2d/multisphere (id plane): sphere 1 lies 0.004 m off the plane";
  EXPECT_THAT(run.output, HasSubstr("said before"));
  EXPECT_THAT(run.output, HasSubstr(line));
  EXPECT_THAT(contents(folder / "log.liggghts"), HasSubstr(line));
}
