// SPDX-License-Identifier: GPL-2.0-or-later
#include "cli/command_line.h"

int main(int argc, char** argv) { return rodpack::cli::run_command_line(argc, argv); }
