// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/pressure_profile.h"

#include <iostream>
#include <memory>

#include "analysis/janssen_fit.h"
#include "analysis/space/vertical_profile.h"
#include "cli/commands.h"
#include "cli/field_input.h"
#include "figures/space/vertical_profile_figure.h"
#include "reading/number_text.h"
#include "report/outputs.h"

namespace rodpack::cli {

namespace {

// The fit and what to say of it, in words.
template <class Profile>
std::pair<std::optional<JanssenFit>, std::string> fitted(const Profile& profile,
                                                         const std::string& unit) {
  try {
    const auto fit = fit_janssen(profile);
    return {fit, describe(fit, profile.particle_diameter, unit)};
  } catch (const TooFewParticles& reason) {
    return {std::nullopt, reason.what()};
  }
}

void profile_in_plane(const FieldInput& options) {
  ProfileSample sample(options.fields);
  std::string setting;
  options.for_packings(true,
                       [&](const Packing& packing, const Frame& bodies, const Frame* contacts) {
                         sample.add(packing, bodies, *contacts);
                         setting = describe(packing);
                       });
  const auto profile = sample.result();
  const auto [fit, report] = fitted(profile, "N/m");
  const auto written = write_profile(profile, fit ? &*fit : nullptr, options.stem);
  std::cout << setting << '\n'
            << options.notes_on_input() << "w = " << number_text(profile.scale, 4) << " m\n"
            << report << '\n'
            << "written: " << written << '\n';
}

void profile_in_space(const FieldInput& options) {
  VerticalProfileSample sample(options.fields);
  std::string setting;
  options.for_spatial_packings(
      true, [&](const SpatialPacking& packing, const Frame& bodies, const Frame* contacts) {
        sample.add(packing, bodies, contacts);
        setting = describe(packing);
      });
  const auto profile = sample.result();
  const auto [fit, report] = fitted(profile, "Pa");
  const auto written = write_profile(profile, fit ? &*fit : nullptr, options.stem);
  const auto solid_fraction = options.stem + "_solid_fraction";
  plot_layers(profile, solid_fraction);
  std::cout << setting << '\n'
            << options.notes_on_input() << "w = " << number_text(profile.scale, 4)
            << " m, cross-section " << number_text(profile.cross_section, 4) << " m^2\n"
            << solid_fraction_line(profile) << "vertical stress: " << report << '\n'
            << "written: " << written << ", " << solid_fraction << ".png .svg\n";
}

}  // namespace

void add_profile(CLI::App& app) {
  auto options = std::make_shared<FieldInput>();
  options->stem = "profile";
  auto* command = app.add_subcommand(
      "profile",
      "In a plane: pressure P_0 = (sigma_1 + sigma_2) / 2 over the depth below the surface in the "
      "central vertical slice, principal stresses, anisotropy, and a fit of Janssen's law. In "
      "space: vertical and horizontal stresses, their fit, and the solid fraction, all over the "
      "container's whole cross-section, smoothed along the vertical alone by a Gaussian of scale w "
      "(default AR d_p / 2).");
  command->footer(
      "Example:\n"
      "  rodpack profile 'results/quick/dumps/bodies.*.dump'\n"
      "reads the contacts.*.dump beside them; writes profile.csv and profile.png/.svg.\n"
      "  rodpack profile bodies.dump --vertical z\n"
      "writes, in space, profile_solid_fraction.png/.svg too.");
  add_files(*command, options->input, "bodies");
  add_contact_options(*command, *options);
  add_all_frames(*command, options->input);
  add_kernel_options(*command, *options);
  add_packing_options(*command, options->input);
  add_space_options(*command, options->input);
  add_output(*command, options->stem);
  command->callback([options, command] {
    if (!options->input.is_in_space()) return profile_in_plane(*options);
    refuse_in_space(*command, {"--kernel", "--line", "--tolerance"});
    profile_in_space(*options);
  });
}

}  // namespace rodpack::cli
