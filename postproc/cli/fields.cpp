// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/fields.h"

#include <filesystem>
#include <iostream>
#include <memory>

#include "commands.h"
#include "rodpack/pressure_profile.h"
#include "rodpack/solid_fraction.h"
#include "rodpack/text.h"

namespace rodpack::cli {
namespace {

struct FieldInput {
  Input input;
  std::vector<std::string> contacts;
  FieldOptions fields;
  std::optional<double> scale_in_diameters;
  std::vector<double> window;
  std::string stem;
};

void add_kernel_options(CLI::App& command, FieldInput& options) {
  auto& fields = options.fields;
  auto* metres =
      command
          .add_option("--scale", fields.scale, "scale w of the averaging, m [default: 3 AR d_p]")
          ->check(CLI::PositiveNumber)
          ->type_name("M");
  command.add_option("--scale-in-dp", options.scale_in_diameters, "the same in d_p")
      ->check(CLI::PositiveNumber)
      ->type_name("N")
      ->excludes(metres);
  command.add_option("--kernel", fields.kernel, "gaussian, lucy or heaviside")
      ->check(CLI::IsMember({"gaussian", "lucy", "heaviside"}))
      ->capture_default_str();
  command
      .add_option("--tolerance", fields.tolerance,
                  "relative error allowed: cut-off of the Gaussian and points along a branch")
      ->check(CLI::Range(1e-15, 0.1))
      ->capture_default_str();
  command.add_option("--spacing", fields.spacing, "of the grid, m [default: w/4]")
      ->check(CLI::PositiveNumber)
      ->type_name("M");
}

void add_contact_options(CLI::App& command, FieldInput& options) {
  command
      .add_option("--contacts", options.contacts,
                  "dump files of the contacts of the same timesteps [default: the bodies' names "
                  "with 'contacts' for 'bodies']")
      ->type_name("FILE");
  command
      .add_option("--line", options.fields.line,
                  "integral along a branch vector: auto, exact, or 1 to 4 Gauss-Legendre points")
      ->check(CLI::IsMember({"auto", "exact", "1", "2", "3", "4"}))
      ->capture_default_str();
}

void add_window(CLI::App& command, FieldInput& options) {
  command
      .add_option("--window", options.window,
                  "corners of the grid, m [default: between the walls, to w above the surface]")
      ->expected(4)
      ->type_name("XLO XHI YLO YHI");
}

std::string contacts_beside(const std::string& bodies) {
  const std::filesystem::path path(bodies);
  auto name = path.filename().string();
  const auto at = name.find("bodies");
  if (at == std::string::npos)
    throw DataError(bodies + ": no 'bodies' in the name, give the contacts with --contacts");
  return (path.parent_path() / name.replace(at, 6, "contacts")).string();
}

// Calls visit(packing, bodies, contacts) for the last frame, or for all; contacts is null unless
// `with_contacts`.
template <class Visit>
void for_packings(FieldInput& options, bool with_contacts, Visit visit) {
  if (!options.window.empty()) {
    const auto& w = options.window;
    if (!(w[1] > w[0] && w[3] > w[2]))
      throw CLI::ValidationError("--window", "expected XLO < XHI and YLO < YHI");
    options.fields.window = {w[0], w[1], w[2], w[3]};
  }
  std::vector<std::string> contact_files;
  if (with_contacts) {
    auto patterns = options.contacts;
    if (patterns.empty())
      for (const auto& each : find_dumps(options.input.patterns))
        patterns.push_back(contacts_beside(each));
    contact_files = find_dumps(patterns);
  }
  const double diameters = options.scale_in_diameters.value_or(0);
  options.input.for_frames([&](const Frame& bodies) {
    if (options.input.all_frames && bodies.rows == 0) return;  // as at the start of a deposition
    const auto packing = read_packing(bodies, options.input.packing);
    if (diameters > 0) options.fields.scale = diameters * packing.particle_diameter;
    if (!with_contacts) return visit(packing, bodies, nullptr);
    const auto contacts = frame_at(contact_files, bodies.timestep);
    if (contacts.rows == 0 && !options.input.all_frames)
      throw DataError(contacts.file + ": no contacts in the frame of timestep " +
                      std::to_string(contacts.timestep) + ", there is no stress to measure");
    visit(packing, bodies, &contacts);
  });
}

double time_of(const Frame& frame, const PackingOptions& options) {
  const auto parameters = find_parameters(frame.file, options.parameters);
  const bool known = parameters && parameters->values.contains("timestep_s");
  return static_cast<double>(frame.timestep) * (known ? parameters->number("timestep_s") : 1.0);
}

// The fields of a run of the command; keeps what figures and reports need.
struct Fields {
  FieldSample sample;
  Packing packing;
  double time = 0;

  Fields(FieldInput& options, bool with_contacts) : sample(options.fields) {
    bool started = false;
    for_packings(options, with_contacts,
                 [&](const Packing& each, const Frame& bodies, const Frame* contacts) {
                   if (!started) {
                     sample = FieldSample(options.fields);
                     packing = each;
                   }
                   started = true;
                   time = time_of(bodies, options.input.packing);
                   sample.add(each, bodies, contacts);
                 });
  }
};

std::string grid_report(const CoarseGraining& averages) {
  const Grid& grid = *averages.grid();
  return "w = " + number_text(averages.kernel().scale(), 4) + " m, grid " +
         std::to_string(grid.count[0]) + " x " + std::to_string(grid.count[1]);
}

}  // namespace

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
    const Fields all(*options, true);
    const auto fields = all.sample.fields();
    const auto& stem = options->stem;
    write_fields(all.sample.averages(), fields, all.time, stem);
    plot_pressure_map(all.sample.averages(), fields, all.packing, stem + "_pressure");
    std::cout << describe(all.packing) << '\n'
              << grid_report(all.sample.averages()) << '\n'
              << "written: " << stem << ".vti .csv, " << stem << "_pressure.png .svg\n";
  });
}

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
    const Fields all(*options, false);
    const std::vector<Field> fields{field_named(all.sample.fields(), "number_density"),
                                    field_named(all.sample.fields(), "solid_fraction")};
    const auto& stem = options->stem;
    write_fields(all.sample.averages(), fields, all.time, stem);
    plot_solid_fraction_map(all.sample.averages(), fields, all.packing, stem);
    const auto slice = solid_fraction(all.packing);
    const auto mean = [](const std::optional<double>& value) {
      return value ? number_text(*value, 4) : std::string("none, the bed is too low");
    };
    std::cout << describe(all.packing) << '\n'
              << grid_report(all.sample.averages()) << '\n'
              << "slice, w = 3 AR d_p, from 3 w above the floor: up to the surface "
              << mean(slice.up_to_surface) << ", up to 3 w below it "
              << mean(slice.up_to_3_scales_below) << '\n'
              << "written: " << stem << ".vti .csv .png .svg\n";
  });
}

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
    std::unique_ptr<ProfileSample> sample;
    std::string setting;
    for_packings(*options, true,
                 [&](const Packing& packing, const Frame& bodies, const Frame* contacts) {
                   if (!sample) sample = std::make_unique<ProfileSample>(options->fields);
                   sample->add(packing, bodies, *contacts);
                   setting = describe(packing);
                 });
    if (!sample) throw TooFewParticles("profile: no frame with particles");
    const auto profile = sample->result();
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
              << "w = " << number_text(profile.scale, 4) << " m\n"
              << report << '\n'
              << "written: " << stem << ".csv .png .svg\n";
  });
}

}  // namespace rodpack::cli
