// SPDX-License-Identifier: GPL-2.0-or-later
#include <iostream>
#include <memory>

#include "cli/checks.h"
#include "cli/commands.h"
#include "figures/vtk_export.h"
#include "reading/scene/run_scene.h"
#include "reading/parameters.h"

namespace rodpack::cli {

void add_export(CLI::App& app) {
  struct Options {
    std::vector<std::string> patterns;
    std::string folder = "vtk";
    double timestep = 0;
    bool capsules = false;
  };
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand("export",
                                     "VTK files (.vtp) of every frame of dumps of bodies, spheres "
                                     "and contacts, told apart by their "
                                     "columns, and one time index (.pvd) per kind.");
  command->footer(
      "Example:\n"
      "  rodpack export 'results/quick/dumps/*.dump' -o vtk\n"
      "then open vtk/spheres.pvd in ParaView and glyph with spheres scaled by 2 radius_m;\n"
      "vtk/contacts.pvd holds a line per contact (tube filter, colour by contact_force_N).\n"
      "  rodpack export 'results/ar2/dumps/bodies.*.dump' --capsules\n"
      "writes vtk/capsules.pvd too, the surfaces of rods, straight or bent: no glyphs needed.\n"
      "Units stand in the names of the arrays; positions are in m, times in s.");
  command
      ->add_option("dumps", options->patterns,
                   "dump files, plain or .gz; quoted wildcards are fine")
      ->required()
      ->check(some_name())
      ->type_name("FILE");
  command
      ->add_option(
          "--timestep", options->timestep,
          "length of a timestep, s [default: dump scene or parameters.json beside the dump or "
          "one folder up; unknown: the index counts timesteps]")
      ->check(positive_number(1e6))
      ->type_name("S");
  command->add_flag("--capsules", options->capsules,
                    "the surfaces of the bodies too, as spherocylinders");
  command->add_option("-o,--output", options->folder, "folder to write to")
      ->check(name_of_folder())
      ->capture_default_str()
      ->type_name("FOLDER");

  command->callback([options] {
    const auto files = find_dumps(options->patterns);
    double timestep = options->timestep;
    Frame first;
    if (timestep == 0 && DumpReader(files.front()).next(first))
      timestep = find_timestep(first, "").value_or(0);
    const auto written = export_vtk(files, options->folder, timestep, options->capsules);
    std::cout << "written: " << written.size() << " files in " << options->folder << '\n';
  });
}

}  // namespace rodpack::cli
