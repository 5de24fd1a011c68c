// SPDX-License-Identifier: GPL-2.0-or-later
#include <iostream>
#include <memory>

#include "cli/commands.h"
#include "cli/field_input.h"
#include "figures/field_maps.h"

namespace rodpack::cli {

void add_stress(CLI::App& app) {
  auto options = std::make_shared<FieldInput>();
  options->stem = "stress";
  auto* command = app.add_subcommand(
      "stress",
      "Coarse-grained fields on a grid (Goldhirsch 2010): densities, velocity, contact and kinetic "
      "stress, boundary force density, coordination; compression counts positive.");
  command->footer(
      "Example:\n"
      "  rodpack stress 'results/quick/dumps/bodies.*.dump'\n"
      "reads the contacts.*.dump beside them; writes stress.vti, stress.csv and\n"
      "stress_pressure.png/.svg, the pressure with crosses along the principal directions.");
  add_files(*command, options->input, "bodies");
  add_contact_options(*command, *options);
  add_all_frames(*command, options->input);
  add_kernel_options(*command, *options);
  add_window(*command, *options);
  command->add_flag("--couple", options->fields.couple_stress, "the couple stress as well");
  add_packing_options(*command, options->input);
  add_output(*command, options->stem);
  command->callback([options] {
    const GriddedFields all(*options, true);
    const auto fields = all.sample.fields();
    const auto& stem = options->stem;
    write_fields(all.sample.averages(), fields, all.time, stem);
    plot_pressure_map(all.sample.averages(), fields, mapped_bed(all.sample, all.packing),
                      stem + "_pressure");
    std::cout << all.report() << "written: " << stem << ".vti .csv, " << stem
              << "_pressure.png .svg\n";
  });
}

}  // namespace rodpack::cli
