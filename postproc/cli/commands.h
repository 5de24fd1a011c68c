// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CLI_COMMANDS_H
#define RODPACK_CLI_COMMANDS_H

#include <CLI/CLI.hpp>

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
void add_ensemble(CLI::App& app);
void add_report(CLI::App& app);
void add_compare(CLI::App& app);
void add_accuracy(CLI::App& app);
void add_timestep(CLI::App& app);
void add_discharge(CLI::App& app);
void add_incline(CLI::App& app);

}  // namespace rodpack::cli

#endif
