// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/solid_fraction.h"
#include "analysis/space/vertical_profile.h"

#include <iostream>
#include <memory>

#include "cli/commands.h"
#include "cli/field_input.h"
#include "figures/field_maps.h"
#include "figures/space/vertical_profile_figure.h"
#include "reading/number_text.h"

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
  std::string setting;
  options.for_spatial_packings(
      false, [&](const SpatialPacking& packing, const Frame& bodies, const Frame*) {
        sample.add(packing, bodies, nullptr);
        setting = describe(packing);
      });
  const auto profile = sample.result();
  const auto& stem = options.stem;
  write_layer_table(profile, stem + ".csv");
  plot_layers(profile, stem);
  std::cout << setting << '\n'
            << options.input.passed_over_line() << "w = " << number_text(profile.scale, 4)
            << " m, cross-section " << number_text(profile.cross_section, 4) << " m^2\n"
            << solid_fraction_line(profile) << "written: " << stem << ".csv .png .svg\n";
}

}  // namespace

void add_solid_fraction(CLI::App& app) {
  auto options = std::make_shared<FieldInput>();
  options->stem = "solid_fraction";
  auto* command = app.add_subcommand(
      "solid-fraction",
      "In a plane: coarse-grained solid fraction on a grid, and its means in the central vertical "
      "slice of the last frame. In space: solid fraction over height, of the container's whole "
      "cross-section, smoothed along the vertical alone by a Gaussian of scale w (default AR d_p / "
      "2).");
  command->footer(
      "Example:\n"
      "  rodpack solid-fraction 'results/quick/dumps/bodies.*.dump' -o phi\n"
      "writes phi.vti, phi.csv and phi.png/.svg; in space, with --vertical, no .vti.");
  add_files(*command, options->input, "bodies");
  add_all_frames(*command, options->input);
  add_kernel_options(*command, *options);
  add_window(*command, *options);
  add_packing_options(*command, options->input);
  add_space_options(*command, options->input);
  add_output(*command, options->stem);
  command->callback([options, command] {
    if (!options->input.is_in_space()) return solid_fraction_in_plane(*options);
    refuse_in_space(*command, {"--kernel", "--tolerance", "--window"});
    solid_fraction_in_space(*options);
  });
}

}  // namespace rodpack::cli
