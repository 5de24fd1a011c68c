// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CLI_FIELD_INPUT_H
#define RODPACK_CLI_FIELD_INPUT_H

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/fields.h"
#include "analysis/space/fields/spatial_fields.h"
#include "analysis/space/vertical_profile.h"
#include "cli/input.h"

namespace rodpack::cli {

/// What the subcommands of coarse-grained fields read, and how they average.
struct FieldInput {
  Input input;
  std::vector<std::string> contacts;
  LocalContactOptions local;
  FieldOptions fields;
  std::vector<double> window;
  std::vector<std::string> slices;  // "y=0.018"
  std::string stem;

  /// Calls `visit` with the last frame, or with every frame if the user asks for all; the contacts
  /// are null unless `with_contacts`.
  using Visit = std::function<void(const Packing&, const Frame& bodies, const Frame* contacts)>;
  void for_packings(bool with_contacts, const Visit& visit) const;
  /// The same in space.
  using SpatialVisit =
      std::function<void(const SpatialPacking&, const Frame& bodies, const Frame* contacts)>;
  void for_spatial_packings(bool with_contacts, const SpatialVisit& visit) const;
  /// What the report says of what was read: frames that did not count, LIGGGHTS's own contacts.
  std::string notes_on_input() const;

 private:
  std::vector<std::string> contact_files() const;
  void for_bodies(
      bool with_contacts,
      const std::function<void(const Frame& bodies, const Frame* contacts)>& visit) const;
  Frame contacts_of(const Frame& bodies, const std::vector<std::string>& files) const;
};

void add_kernel_options(CLI::App& command, FieldInput& options);
void add_contact_options(CLI::App& command, FieldInput& options);
void add_window(CLI::App& command, FieldInput& options);
/// Adds --slice, of scenes in space.
void add_slices(CLI::App& command, FieldInput& options);

/// "solid fraction, 3 w from floor and surface: ..." for the terminal.
std::string solid_fraction_line(const VerticalProfile& profile);

/// Fields on a grid, with what figures and reports need beside them.
struct GriddedFields {
  FieldSample sample;
  Packing packing;  // of the first frame
  double time = 0;  // of the last one, s, or its timestep

  GriddedFields(const FieldInput& options, bool with_contacts);
  std::string notes;           // on the input, as lines for the report
  std::string report() const;  // packing, scale and grid, for the terminal
};

/// The same in space.
struct SpatialFields {
  SpatialFieldSample sample;
  double time = 0;

  SpatialFields(const FieldInput& options, bool with_contacts);
  std::string notes;
  /// Packing, scale, grid, and the solid fraction that neither wall nor surface disturbs.
  std::string report() const;
};

}  // namespace rodpack::cli

#endif
