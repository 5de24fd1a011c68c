// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CLI_COMMAND_LINE_H
#define RODPACK_CLI_COMMAND_LINE_H

namespace rodpack::cli {

/// All that `rodpack` does with its command line, of which the first word is the program's name. It
/// speaks through std::cout and std::cerr.
/// @return the exit code: 0 done, 1 data that cannot be used, 2 wrong command line.
int run_command_line(int argc, const char* const* argv);

}  // namespace rodpack::cli

#endif
