// SPDX-License-Identifier: GPL-2.0-or-later
// What cannot be written stops the run at once, with a line that names the file, and no half file
// takes the place of a whole one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "deck.h"
#include "liggghts_run.h"

using namespace rodpack::test;
using testing::HasSubstr;
using testing::Not;

namespace {

namespace fs = std::filesystem;

/// A sphere that moves on its own, and `lines`, then 20 steps and a line that says it was not
/// stopped.
std::string deck(const std::string& lines) {
  return Deck().with(
      "create_atoms 1 single 0.05 0.05 0 units box\nset group all diameter 0.003 "
      "density 2500\nfix move all nve/sphere\nvariable n equal step\nthermo 10\n" +
      lines + "\nrun 20\nprint \"went on\"\n");
}

/// `shell` with LIGGGHTS in place of the word PROGRAM.
Run start(const std::string& shell, const std::string& deck) {
  const fs::path folder = fresh_folder();
  std::ofstream(folder / "in.deck") << deck;
  std::string command = shell;
  command.replace(command.find("PROGRAM"), 7, "'" RODPACK_BIN "/liggghts' -in in.deck");
  return run_command(
      "OMPI_MCA_orte_tmpdir_base=\"$PWD\"; OMPI_MCA_ess_singleton_isolated=1; export "
      "OMPI_MCA_orte_tmpdir_base OMPI_MCA_ess_singleton_isolated; " +
          command,
      folder);
}

void expect_stopped(const std::string& lines, const std::string& message) {
  const auto run = start("PROGRAM", deck(lines));
  EXPECT_NE(run.exit_code, 0) << lines;
  EXPECT_THAT(run.output, HasSubstr(message)) << lines;
  EXPECT_THAT(run.output, Not(HasSubstr("went on"))) << lines;
}

const std::string full = "No space left on device";

}  // namespace

// /dev/full takes nothing. The log file says it too.
TEST(WriteErrors, AFullDiskIsSaidWhateverIsWritten) {
  for (const char* file :
       {"dump d all multisphere/sphere 10 /dev/full", "dump d all multisphere/body 10 /dev/full",
        "dump d all contact/gran 10 /dev/full", "dump d all custom 10 /dev/full id x y z",
        "fix p all print 10 \"$n\" file /dev/full screen no",
        "print word file /dev/full screen no"}) {
    const auto run = start("PROGRAM", deck(file));
    EXPECT_NE(run.exit_code, 0) << file;
    for (const std::string& text : {run.output, text_of(run.folder / "log.liggghts")}) {
      EXPECT_THAT(text, HasSubstr("ERROR on proc 0: ")) << file;
      EXPECT_THAT(text, HasSubstr(full)) << file;
      EXPECT_THAT(text, Not(HasSubstr("went on"))) << file;
    }
  }
  expect_stopped(
      "compute st all stress/goldhirsch scale 0.01 spacing 0.02\n"
      "dump f all stress/goldhirsch 10 full.csv st\nshell ln -s /dev/full full.csv",
      "Cannot write dump file full.csv");
  expect_stopped("log /dev/full", "Cannot write the log file /dev/full: " + full);
}

TEST(WriteErrors, AScreenThatCannotBeWrittenStopsTheRun) {
  const auto disk = start("PROGRAM > /dev/full", deck(""));
  EXPECT_NE(disk.exit_code, 0);
  EXPECT_THAT(text_of(disk.folder / "log.liggghts"),
              HasSubstr("Cannot write to the screen: " + full));
  EXPECT_THAT(disk.output, HasSubstr("Cannot write to the screen: " + full));  // its standard error

  // A reader that is gone before anything is written.
  const auto pipe = start("{ sleep 0.5; PROGRAM; echo \"status $?\" >&2; } | true", deck(""));
  EXPECT_THAT(pipe.output, HasSubstr("Cannot write to the screen: Broken pipe"));
  EXPECT_THAT(pipe.output, HasSubstr("status 1"));
  EXPECT_THAT(text_of(pipe.folder / "log.liggghts"), Not(HasSubstr("went on")));
}

// gzip is told from a shell: it has a file, not a command line.
TEST(WriteErrors, ACompressedDumpThatCannotBeWrittenIsSaid) {
  expect_stopped(
      "shell ln -s /dev/full d.gz\ndump d all multisphere/sphere 10 d.gz\nrun 20\nundump d",
      "gzip has failed");
  const auto run = start("PROGRAM", deck("dump d all multisphere/sphere 10 x';touch,y.*.gz"));
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_TRUE(fs::exists(run.folder / "x';touch,y.20.gz")) << run.output;
}

TEST(WriteErrors, ADumpsFolderThatCannotBeThereIsRefusedBeforeTheFirstStep) {
  for (const char* style : {"multisphere/sphere", "multisphere/body", "contact/gran"}) {
    const auto run = start("echo > file; PROGRAM",
                           deck(std::string("dump d all ") + style + " 1000000 file/sub/a.*.dump"));
    EXPECT_NE(run.exit_code, 0);
    EXPECT_THAT(run.output, HasSubstr(std::string("ERROR: Dump ") + style +
                                      " (id d): Cannot write dump file file/sub/a.*.dump: folder "
                                      "file/sub/: Not a directory"));
    EXPECT_THAT(run.output, Not(HasSubstr("Step")));
  }
}

TEST(WriteErrors, ARestartFilesFolderThatIsNotThereIsRefusedBeforeTheFirstStep) {
  expect_stopped("restart 1000000 nowhere/r.*.restart",
                 "Cannot write restart file nowhere/r.*.restart: folder nowhere/: No such file");
  expect_stopped("restart 1000000 a.restart nowhere/b.restart", "folder nowhere/: No such file");
}

// A limit of 16 KiB for a file in place of a full disk: the dump of some 1400 spheres is larger.
// What was whole stays, and what is not has not got its name.
TEST(WriteErrors, AFileThatIsCutOffDoesNotGetItsName) {
  const std::string spheres =
      "lattice sc 0.0045\ncreate_atoms 1 box\nset group all diameter 0.003 density 2500\n";
  const auto dump = start("ulimit -f 32; PROGRAM > screen.txt",
                          deck(spheres + "dump d all multisphere/sphere 10 s.*.dump"));
  EXPECT_NE(dump.exit_code, 0);
  EXPECT_THAT(text_of(dump.folder / "screen.txt"),
              HasSubstr("Cannot write dump file s.0.dump: File too large"));
  EXPECT_FALSE(fs::exists(dump.folder / "s.0.dump"));

  const auto restart = start("echo before > r.restart; ulimit -f 32; PROGRAM > screen.txt",
                             deck(spheres + "write_restart r.restart"));
  EXPECT_NE(restart.exit_code, 0);
  EXPECT_THAT(text_of(restart.folder / "screen.txt"),
              HasSubstr("Cannot write restart file r.restart: File too large"));
  EXPECT_EQ(text_of(restart.folder / "r.restart"), "before\n");
  EXPECT_FALSE(fs::exists(restart.folder / "r.restart.part"));
}
