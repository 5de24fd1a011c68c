// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/solid_fraction.h"

#include <iostream>
#include <memory>

#include "cli/commands.h"
#include "cli/field_input.h"
#include "figures/field_maps.h"
#include "reading/number_text.h"

namespace rodpack::cli {

void add_solid_fraction(CLI::App& app) {
  auto options = std::make_shared<FieldInput>();
  options->stem = "solid_fraction";
  auto* command = app.add_subcommand(
      "solid-fraction",
      "Coarse-grained solid fraction on a grid, and its means in the central vertical slice of the "
      "last frame.");
  command->footer(
      "Example:\n"
      "  rodpack solid-fraction 'results/quick/dumps/bodies.*.dump' -o phi\n"
      "writes phi.vti, phi.csv and phi.png/.svg.");
  add_files(*command, options->input, "bodies");
  add_all_frames(*command, options->input);
  add_kernel_options(*command, *options);
  add_window(*command, *options);
  add_packing_options(*command, options->input);
  add_output(*command, options->stem);
  command->callback([options] {
    const GriddedFields all(*options, false);
    const std::vector<Field> fields{field_named(all.sample.fields(), "number_density"),
                                    field_named(all.sample.fields(), "solid_fraction")};
    const auto& stem = options->stem;
    write_fields(all.sample.averages(), fields, all.time, stem);
    plot_solid_fraction_map(all.sample.averages(), fields, mapped_bed(all.sample, all.packing),
                            stem);
    const auto slice = solid_fraction(all.packing);
    const auto mean = [](const std::optional<double>& value) {
      return value ? number_text(*value, 4) : std::string("none, the bed is too low");
    };
    std::cout << all.report() << "slice, w = 3 AR d_p, from 3 w above the floor: up to the surface "
              << mean(slice.up_to_surface) << ", up to 3 w below it "
              << mean(slice.up_to_3_scales_below) << '\n'
              << "divided by the kernel's share between walls and below the surface: up to the "
                 "surface "
              << mean(slice.normalised_up_to_surface) << ", from the floor on "
              << mean(slice.normalised_from_floor_to_surface)
              << "; covered area over that of the bed "
              << number_text(slice.covered_below_surface, 4) << '\n'
              << "written: " << stem << ".vti .csv .png .svg\n";
  });
}

}  // namespace rodpack::cli
