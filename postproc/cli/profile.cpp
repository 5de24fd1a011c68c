// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/pressure_profile.h"

#include <iostream>
#include <memory>

#include "analysis/janssen_fit.h"
#include "cli/commands.h"
#include "cli/field_input.h"
#include "figures/profile_figure.h"
#include "reading/number_text.h"

namespace rodpack::cli {

void add_profile(CLI::App& app) {
  auto options = std::make_shared<FieldInput>();
  options->stem = "profile";
  auto* command = app.add_subcommand(
      "profile",
      "Pressure P_0 = (sigma_1 + sigma_2) / 2 over the depth below the surface in the central "
      "vertical slice, principal stresses, anisotropy, and a fit of Janssen's law.");
  command->footer(
      "Example:\n"
      "  rodpack profile 'results/quick/dumps/bodies.*.dump'\n"
      "reads the contacts.*.dump beside them; writes profile.csv and profile.png/.svg.");
  add_files(*command, options->input, "bodies");
  add_contact_options(*command, *options);
  add_all_frames(*command, options->input);
  add_kernel_options(*command, *options);
  add_packing_options(*command, options->input);
  add_output(*command, options->stem);
  command->callback([options] {
    ProfileSample sample(options->fields);
    std::string setting;
    options->for_packings(true,
                          [&](const Packing& packing, const Frame& bodies, const Frame* contacts) {
                            sample.add(packing, bodies, *contacts);
                            setting = describe(packing);
                          });
    const auto profile = sample.result();
    std::optional<JanssenFit> fit;
    std::string report;
    try {
      fit = fit_janssen(profile);
      report = describe(*fit, profile.particle_diameter);
    } catch (const TooFewParticles& reason) {
      report = reason.what();
    }
    const auto& stem = options->stem;
    write_profile_table(profile, stem + ".csv");
    plot_profile(profile, fit ? &*fit : nullptr, stem);
    std::cout << setting << '\n'
              << options->input.passed_over_line() << "w = " << number_text(profile.scale, 4)
              << " m\n"
              << report << '\n'
              << "written: " << stem << ".csv .png .svg\n";
  });
}

}  // namespace rodpack::cli
