// SPDX-License-Identifier: GPL-2.0-or-later
#include "cli/field_input.h"

#include <cmath>
#include <filesystem>

#include "analysis/stock/stock_dumps.h"
#include "cli/checks.h"
#include "reading/number_text.h"
#include "reading/parsing.h"
#include "reading/scene/run_scene.h"

namespace rodpack::cli {
namespace {

std::string contacts_beside(const std::string& bodies) {
  const std::filesystem::path path(bodies);
  auto name = path.filename().string();
  const auto at = name.find("bodies");
  if (at == std::string::npos)
    throw DataError(bodies + ": no 'bodies' in the name, give the contacts with --contacts");
  return (path.parent_path() / name.replace(at, 6, "contacts")).string();
}

double time_of(const Frame& frame, const PackingOptions& options) {
  return static_cast<double>(frame.timestep) * find_timestep(frame, options.parameters).value_or(1);
}

// The fields' options, with the window of the command line.
FieldOptions checked(const FieldInput& options) {
  auto fields = options.fields;
  const auto& w = options.window;
  if (w.empty()) return fields;
  require_window(w);
  fields.window = {w[0], w[1], w[2], w[3]};
  return fields;
}

// Reads "y=0.018"; false when it is none.
bool parse_slice(const std::string& word, Slice& slice) {
  const auto axis = std::string("xyz").find(word.substr(0, 1));
  if (word.size() < 3 || word[1] != '=' || axis == std::string::npos) return false;
  slice.axis = axis;
  return parse_number(std::string_view(word).substr(2), slice.at) && std::abs(slice.at) <= 1e6;
}

std::vector<Slice> slices_of(const FieldInput& options) {
  std::vector<Slice> slices;
  for (const auto& word : options.slices) parse_slice(word, slices.emplace_back());
  return slices;
}

}  // namespace

void add_kernel_options(CLI::App& command, FieldInput& options) {
  auto& fields = options.fields;
  auto* metres =
      command
          .add_option("--scale", fields.scale,
                      "scale w of the averaging, m [default: 3 AR d_p, in space AR d_p / 2]")
          ->check(length())
          ->type_name("M");
  command.add_option("--scale-in-dp", fields.scale_in_diameters, "the same in d_p")
      ->check(number(1e-3, 1e4))
      ->type_name("N")
      ->excludes(metres);
  command.add_option("--kernel", fields.kernel, "gaussian, lucy or heaviside")
      ->check(one_of({"gaussian", "lucy", "heaviside"}))
      ->capture_default_str();
  command
      .add_option("--tolerance", fields.tolerance,
                  "relative error allowed: cut-off of the Gaussian and points along a branch")
      ->check(number(1e-15, 0.1))
      ->capture_default_str();
  command
      .add_option_function<std::string>(
          "--normalise",
          [&fields](const std::string& space) {
            fields.normalisation = space == "none"    ? Normalisation::none
                                   : space == "walls" ? Normalisation::walls
                                                      : Normalisation::walls_and_surface;
          },
          "divide the densities by the kernel's share inside the container, so that they do not "
          "sink towards its edges: none, walls (the floor too) or walls-and-surface (of the bed; "
          "above it all is 0)")
      ->check(one_of({"none", "walls", "walls-and-surface"}))
      ->default_str("none");
  command
      .add_option("--spacing", fields.spacing,
                  "of the grid, m [default: w/4, of a grid in space w/2]")
      ->check(length())
      ->type_name("M");
}

void add_contact_options(CLI::App& command, FieldInput& options) {
  command
      .add_option("--contacts", options.contacts,
                  "dump files of the contacts of the same timesteps [default: the bodies' names "
                  "with 'contacts' for 'bodies']")
      ->check(existing_files())
      ->type_name("FILE");
  add_local_contacts(command, options.local, "those of the bodies are then");
  command
      .add_option("--line", options.fields.line,
                  "integral along a branch vector: auto, exact, or 1 to 4 Gauss-Legendre points")
      ->check(one_of({"auto", "exact", "1", "2", "3", "4"}))
      ->capture_default_str();
}

void add_window(CLI::App& command, FieldInput& options) {
  command
      .add_option("--window", options.window,
                  "corners of the grid, m [default: between the walls, to w above the surface, or "
                  "to the surface where it "
                  "bounds what --normalise counts]")
      ->expected(4)
      ->check(place())
      ->type_name("XLO XHI YLO YHI");
}

void add_slices(CLI::App& command, FieldInput& options) {
  command
      .add_option("--slice", options.slices,
                  "in space: a plane to draw, m; may repeat [default: an upright one through the "
                  "middle of the container and a level one at half the height of the bed]")
      ->check(CLI::Validator(
          [](std::string& word) {
            Slice slice{};
            return parse_slice(word, slice) ? std::string()
                                            : "expected an axis and a place, such as y=0.018, "
                                              "found '" +
                                                  shortened(word) + "'";
          },
          ""))
      ->allow_extra_args(false)
      ->type_name("AXIS=M");
}

std::vector<std::string> FieldInput::contact_files() const {
  auto patterns = contacts;
  if (patterns.empty())
    for (const auto& each : find_dumps(input.patterns)) patterns.push_back(contacts_beside(each));
  return find_dumps(patterns);
}

Frame FieldInput::contacts_of(const Frame& bodies, const std::vector<std::string>& files) const {
  auto frame = frame_beside(bodies, files);
  if (local.words.empty())
    require_contact_dump(frame);
  else
    frame = read_local_contacts(frame, local, frame_beside(bodies, find_dumps(input.patterns)));
  if (frame.rows == 0 && !input.all_frames)
    throw DataError(frame.file + ": no contacts in the frame of timestep " +
                    std::to_string(frame.timestep) + ", there is no stress to measure");
  return frame;
}

void FieldInput::for_bodies(
    bool with_contacts,
    const std::function<void(const Frame& bodies, const Frame* contacts)>& visit) const {
  std::vector<std::string> files;
  if (with_contacts) files = contact_files();
  input.for_frames([&](const Frame& bodies) {
    if (!with_contacts) return visit(bodies, nullptr);
    const auto frame = contacts_of(bodies, files);
    visit(bodies, &frame);
  });
}

void FieldInput::for_packings(bool with_contacts, const Visit& visit) const {
  for_bodies(with_contacts, [&](const Frame& bodies, const Frame* touching) {
    visit(read_packing(bodies, input.packing), bodies, touching);
  });
}

void FieldInput::for_spatial_packings(bool with_contacts, const SpatialVisit& visit) const {
  for_bodies(with_contacts, [&](const Frame& bodies, const Frame* touching) {
    visit(read_spatial_packing(bodies, input.packing, input.space), bodies, touching);
  });
}

std::string FieldInput::notes_on_input() const {
  return input.passed_over_line() +
         (local.words.empty() ? "" : note_on_local_contacts(local) + "\n");
}

std::string solid_fraction_line(const VerticalProfile& profile) {
  const auto mean = mean_solid_fraction(profile);
  return "solid fraction, 3 w from floor and surface: " +
         (mean ? number_text(*mean, 4) : std::string("none, the bed is too low")) + "\n";
}

GriddedFields::GriddedFields(const FieldInput& options, bool with_contacts)
    : sample(checked(options)) {
  options.for_packings(with_contacts,
                       [&](const Packing& each, const Frame& bodies, const Frame* contacts) {
                         if (packing.size() == 0) packing = each;
                         time = time_of(bodies, options.input.packing);
                         sample.add(each, bodies, contacts);
                       });
  notes = options.notes_on_input();
}

std::string GriddedFields::report() const {
  const Grid& grid = *sample.averages().grid();
  return describe(packing) + "\nw = " + number_text(sample.averages().kernel().scale(), 4) +
         " m, grid " + std::to_string(grid.count[0]) + " x " + std::to_string(grid.count[1]) +
         "\n" + notes;
}

SpatialFields::SpatialFields(const FieldInput& options, bool with_contacts)
    : sample(options.fields, slices_of(options)) {
  options.for_spatial_packings(
      with_contacts, [&](const SpatialPacking& each, const Frame& bodies, const Frame* contacts) {
        time = time_of(bodies, options.input.packing);
        sample.add(each, bodies, contacts);
      });
  notes = options.notes_on_input();
}

std::string SpatialFields::report() const {
  const Grid& grid = *sample.averages().grid();
  const auto interior = interior_solid_fraction(sample);
  std::string counts;
  for (const int count : grid.count)
    counts += (counts.empty() ? "" : " x ") + std::to_string(count);
  return describe(sample.packing()) +
         "\nw = " + number_text(sample.averages().kernel().scale(), 4) + " m, grid " + counts +
         "\nsolid fraction where no wall and no surface disturbs it: " +
         (interior ? number_text(interior->mean, 4) + ", standard deviation " +
                         number_text(interior->deviation, 2) + " over " +
                         std::to_string(interior->places) + " places"
                   : std::string("none, the bed is too small")) +
         "\n" + notes;
}

}  // namespace rodpack::cli
