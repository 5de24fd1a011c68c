// SPDX-License-Identifier: GPL-2.0-or-later
#include <iostream>
#include <memory>

#include "cli/commands.h"
#include "cli/field_input.h"
#include "figures/field_maps.h"
#include "report/outputs.h"

namespace rodpack::cli {
namespace {

void stress_in_plane(const FieldInput& options) {
  const GriddedFields all(options, true);
  const auto fields = all.sample.fields();
  const auto& stem = options.stem;
  write_fields(all.sample.averages(), fields, all.time, stem);
  plot_pressure_map(all.sample.averages(), fields, mapped_bed(all.sample, all.packing),
                    stem + "_pressure");
  std::cout << all.report() << "written: " << stem << ".vti .csv, " << stem
            << "_pressure.png .svg\n";
}

void stress_in_space(const FieldInput& options) {
  const SpatialFields all(options, true);
  auto written = write_fields(all.sample, {}, all.time, options.stem);
  written += ", " + draw_pressure_maps(all.sample, options.stem + "_pressure");
  std::cout << all.report() << "written: " << written << '\n';
}

}  // namespace

void add_stress(CLI::App& app) {
  auto options = std::make_shared<FieldInput>();
  options->stem = "stress";
  auto* command = app.add_subcommand(
      "stress",
      "Coarse-grained fields on a grid (Goldhirsch 2010): densities, velocity, contact and kinetic "
      "stress, boundary force density, coordination; compression counts positive. In space with "
      "maps of slices and, in a cylinder, means over rings.");
  command->footer(
      "Example:\n"
      "  rodpack stress 'results/quick/dumps/bodies.*.dump'\n"
      "reads the contacts.*.dump beside them; writes stress.vti, stress.csv and\n"
      "stress_pressure.png/.svg, the pressure with crosses along the principal directions.\n"
      "  rodpack stress bodies.dump --vertical z --slice x=0.01 --slice z=0.02\n"
      "draws, in space, stress_pressure_x_0.01 and stress_pressure_z_0.02; in a cylinder there "
      "are\n"
      "stress_rings.csv and stress_pressure_rings too.");
  add_files(*command, options->input, "bodies");
  add_contact_options(*command, *options);
  add_all_frames(*command, options->input);
  add_kernel_options(*command, *options);
  add_window(*command, *options);
  add_slices(*command, *options);
  command->add_flag("--couple", options->fields.couple_stress, "the couple stress as well");
  add_packing_options(*command, options->input);
  add_space_options(*command, options->input);
  add_output(*command, options->stem);
  command->callback([options, command] {
    if (options->input.is_in_space()) {
      refuse_in_space(*command, {"--window"});
      return stress_in_space(*options);
    }
    refuse_in_plane(*command, {"--slice"});
    stress_in_plane(*options);
  });
}

}  // namespace rodpack::cli
