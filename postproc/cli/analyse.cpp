// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/analyse_run.h"

#include <iostream>
#include <memory>
#include <optional>

#include "cli/checks.h"
#include "cli/commands.h"
#include "cli/input.h"
#include "page/run_page.h"

namespace rodpack::cli {

void add_analyse(CLI::App& app) {
  struct Options {
    std::string folder;
    Input input;
    std::optional<double> friction;
    LocalContactOptions local;
  };
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand(
      "analyse",
      "Everything at once for the last frame of a run, in a plane or in space: orientation, RDF, "
      "solid fraction, contact forces, energies, pictures and VTK files, into RUN_FOLDER/analysis "
      "with a summary.json and a page to look at, report.html. What cannot be measured is left "
      "out, with a note that says why.");
  command->footer(
      "Example:\n"
      "  rodpack analyse results/quick\n"
      "reads parameters.json, dumps/ and energies.csv there; writes results/quick/analysis/.\n"
      "  rodpack analyse mine --vertical z --cylinder 0 0 0.05\n"
      "reads mine/bodies.*.dump, spheres.*.dump and contacts.*.dump of a deck of one's own, there\n"
      "or in mine/dumps/; the bodies are enough. scene.*.json (dump scene) says the rest: walls,\n"
      "gravity, friction, length of a time step.\n"
      "  rodpack analyse stock --local pos id force --local-walls stock/walls.dump\n"
      "reads LIGGGHTS's own dumps of a deck with\n"
      "  compute pairs all pair/gran/local pos id force\n"
      "  dump contacts all local 1000 stock/contacts.*.dump c_pairs[1] c_pairs[2] ... c_pairs[12]\n"
      "  dump bodies all custom 1000 stock/bodies.*.dump id type x y z radius id_multisphere "
      "mass vx vy vz");
  command->add_option("run_folder", options->folder, "folder that a simulation wrote")
      ->required()
      ->check(some_name())
      ->type_name("RUN_FOLDER");
  command->add_flag("--all-frames", options->input.all_frames,
                    "export every frame to VTK, not only the last");
  add_packing_options(*command, options->input);
  add_space_options(*command, options->input);
  command
      ->add_option(
          "--friction", options->friction,
          "friction coefficient mu of all contacts [default: that of dump scene, of each contact's "
          "two atom types, else parameters.json; unknown: no mobilised friction]")
      ->check(positive_number(1000))
      ->type_name("MU");
  add_local_contacts(*command, options->local, "those of the bodies are then");
  command->callback([options] {
    const auto summary =
        analyse_run(options->folder, {options->input.all_frames, options->input.packing,
                                      options->input.space, options->friction, options->local});
    for (const auto& [key, value] : summary.items())
      if (value.is_number()) std::cout << key << ": " << value << '\n';
    for (const auto& note : summary["notes"])
      std::cout << "note: " << note.get<std::string>() << '\n';
    if (summary.contains("scene")) std::cout << summary["scene"].get<std::string>() << '\n';
    const auto page = write_run_page(options->folder);
    std::cout << "written: " << options->folder << "/analysis, to look at: " << page << '\n';
  });
}

}  // namespace rodpack::cli
