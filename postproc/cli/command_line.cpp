// SPDX-License-Identifier: GPL-2.0-or-later
#include "cli/command_line.h"

#include <iostream>

#include "cli/commands.h"
#include "rodpack/version.h"

namespace rodpack::cli {
namespace {

// Names of files may hold line ends and worse.
std::string one_line(std::string text) {
  for (char& each : text)
    if (static_cast<unsigned char>(each) < ' ' || each == 127) each = '?';
  return text;
}

}  // namespace

int run_command_line(int argc, const char* const* argv) {
  constexpr int bad_data = 1;
  constexpr int bad_usage = 2;

  CLI::App app("Analyses packings of spherocylinders that LIGGGHTS with rodpack's styles wrote.");
  app.name("rodpack");
  app.set_version_flag("--version", std::string("rodpack ") + version() + " (" + commit() + ")",
                       "version and commit");
  app.require_subcommand(1);
  app.footer(
      "Start with a whole run:\n"
      "  rodpack analyse results/quick\n"
      "Every subcommand explains itself:  rodpack rdf --help\n"
      "Exit codes: 0 done, 1 data that cannot be used, 2 wrong command line.");
  add_analyse(app);
  add_report(app);
  add_orientation(app);
  add_rdf(app);
  add_forces(app);
  add_render(app);
  add_stress(app);
  add_solid_fraction(app);
  add_profile(app);
  add_export(app);
  add_ensemble(app);
  add_compare(app);
  add_accuracy(app);
  add_timestep(app);
  add_discharge(app);
  add_incline(app);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // help, version
    const auto commands = app.get_subcommands();
    std::cerr << "rodpack: " << one_line(error.what()) << " (see 'rodpack "
              << (commands.empty() ? "" : commands.front()->get_name() + " ") << "--help')\n";
    return bad_usage;
  } catch (const std::bad_alloc&) {
    std::cerr << "rodpack: not enough memory\n";
    return bad_data;
  } catch (const std::exception& error) {
    std::cerr << "rodpack: " << one_line(error.what()) << '\n';
    return bad_data;
  }
  return 0;
}

}  // namespace rodpack::cli
