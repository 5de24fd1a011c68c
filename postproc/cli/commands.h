// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_COMMANDS_H
#define RODPACK_COMMANDS_H

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "reading/packing.h"

namespace rodpack::cli {

// Each adds one subcommand; its options live in its own file.
void add_orientation(CLI::App& app);
void add_rdf(CLI::App& app);
void add_forces(CLI::App& app);
void add_render(CLI::App& app);
void add_stress(CLI::App& app);
void add_solid_fraction(CLI::App& app);
void add_profile(CLI::App& app);
void add_export(CLI::App& app);
void add_analyse(CLI::App& app);
void add_compare(CLI::App& app);
void add_accuracy(CLI::App& app);

/// Dumps to read, common to the measuring subcommands.
struct Input {
  std::vector<std::string> patterns;
  bool all_frames = false;
  PackingOptions packing;

  /// Calls `visit` with the last frame, or with every frame if the user asks for all.
  void for_frames(const std::function<void(const Frame&)>& visit) const;
};
void add_files(CLI::App& command, Input& input, const std::string& kind);
void add_all_frames(CLI::App& command, Input& input);
void add_packing_options(CLI::App& command, Input& input);
void add_output(CLI::App& command, std::string& stem);

/// "<where the walls come from>, d_p = ... m, AR = ..." for the reports on the terminal.
std::string describe(const Packing& packing);

}  // namespace rodpack::cli

#endif
