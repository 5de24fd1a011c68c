// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/solid_fraction.h"
#include "analysis/space/vertical_profile.h"

#include <iostream>
#include <memory>

#include "cli/commands.h"
#include "cli/field_input.h"
#include "figures/field_maps.h"
#include "reading/number_text.h"
#include "report/outputs.h"

namespace rodpack::cli {

namespace {

void solid_fraction_in_plane(const FieldInput& options) {
  const GriddedFields all(options, false);
  const std::vector<Field> fields{field_named(all.sample.fields(), "number_density"),
                                  field_named(all.sample.fields(), "solid_fraction")};
  const auto& stem = options.stem;
  write_fields(all.sample.averages(), fields, all.time, stem);
  plot_solid_fraction_map(all.sample.averages(), fields, mapped_bed(all.sample, all.packing), stem);
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
            << "; covered area over that of the bed " << number_text(slice.covered_below_surface, 4)
            << '\n'
            << "written: " << stem << ".vti .csv .png .svg\n";
}

void solid_fraction_in_space(const FieldInput& options) {
  VerticalProfileSample sample(options.fields);
  options.for_spatial_packings(false, [&](const SpatialPacking& packing, const Frame& bodies,
                                          const Frame*) { sample.add(packing, bodies, nullptr); });
  const auto profile = sample.result();
  const SpatialFields all(options, false);
  const auto& stem = options.stem;
  auto written = write_layers(profile, stem);
  written += ", " + write_fields(all.sample, {"number_density", "solid_fraction"}, all.time,
                                 stem + "_grid");
  written += ", " + draw_solid_fraction_maps(all.sample, stem + "_map");
  std::cout << all.report() << "over the cross-section of " << number_text(profile.cross_section, 4)
            << " m^2: " << solid_fraction_line(profile) << "written: " << written << '\n';
}

}  // namespace

void add_solid_fraction(CLI::App& app) {
  auto options = std::make_shared<FieldInput>();
  options->stem = "solid_fraction";
  auto* command = app.add_subcommand(
      "solid-fraction",
      "In a plane: coarse-grained solid fraction on a grid, and its means in the central vertical "
      "slice of the last frame. In space: on a grid, with maps of slices and, in a cylinder, means "
      "over rings; and over height, of the container's whole cross-section, smoothed along the "
      "vertical alone by a Gaussian of scale w (default AR d_p / 2).");
  command->footer(
      "Example:\n"
      "  rodpack solid-fraction 'results/quick/dumps/bodies.*.dump' -o phi\n"
      "writes phi.vti, phi.csv and phi.png/.svg; in space, with --vertical, phi.csv and "
      "phi.png/.svg\n"
      "over height, phi_grid.vti, phi_grid.csv and the maps phi_map and phi_map_across.");
  add_files(*command, options->input, "bodies");
  add_all_frames(*command, options->input);
  add_kernel_options(*command, *options);
  add_window(*command, *options);
  add_slices(*command, *options);
  add_packing_options(*command, options->input);
  add_space_options(*command, options->input);
  add_output(*command, options->stem);
  command->callback([options, command] {
    if (options->input.is_in_space()) {
      refuse_in_space(*command, {"--kernel", "--window"});
      return solid_fraction_in_space(*options);
    }
    refuse_in_plane(*command, {"--slice"});
    solid_fraction_in_plane(*options);
  });
}

}  // namespace rodpack::cli
