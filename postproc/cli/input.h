// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CLI_INPUT_H
#define RODPACK_CLI_INPUT_H

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/stock/local_contacts.h"
#include "reading/dump.h"
#include "reading/packing.h"
#include "reading/space/spatial_packing.h"

namespace rodpack::cli {

/// Dumps to read, common to the measuring subcommands.
struct Input {
  std::vector<std::string> patterns;
  std::string kind;  // "bodies", "contacts", "spheres"
  bool all_frames = false;
  PackingOptions packing;
  SpaceOptions space;
  // Where a frame is not of the kind, what makes it one; none: what is told of last().
  std::function<Frame(const Frame&)> convert;

  /// The last frame. Stock dumps are read as bodies where they carry enough. @throws DataError as
  /// as_bodies() and require_contact_dump().
  const Frame& last() const;
  /// Calls `visit` with it, or with every frame that FramePool takes if the user asks
  /// for all; returns the last one of these. @throws DataError as last(), and when it takes none.
  const Frame& for_frames(const std::function<void(const Frame&)>& visit) const;
  /// Whether the last frame shows a scene in space. @throws DataError as rodpack::is_in_space(),
  /// CLI::ValidationError for walls of the other kind of scene.
  bool is_in_space() const;
  /// What FramePool has passed over by now, as a line for the report; empty if nothing.
  std::string passed_over_line() const { return passed_over.empty() ? "" : passed_over + "\n"; }
  mutable std::string passed_over;

 private:
  Frame taken(const Frame& read) const;
  mutable std::optional<Frame> last_;  // read once: a frame may take seconds
  mutable Frame last_visited_;         // of all that count
};

/// Adds the dump files of `kind` ("bodies") as arguments without a name.
void add_files(CLI::App& command, Input& input, const std::string& kind);
/// Adds --all-frames.
void add_all_frames(CLI::App& command, Input& input);
/// Adds --walls, --dp, --ar and --parameters.
void add_packing_options(CLI::App& command, Input& input);
/// Adds --vertical, for what measures scenes in space too.
void add_vertical(CLI::App& command, Input& input);
/// The same with --container and --cylinder.
void add_space_options(CLI::App& command, Input& input);
/// Adds --local and --local-walls, for what measures contacts, and returns the former. `spheres`:
/// where the dump of spheres comes from that they need, for the help.
CLI::Option* add_local_contacts(CLI::App& command, LocalContactOptions& local,
                                const std::string& spheres);
/// Adds --output, the start of the names of the files to write.
void add_output(CLI::App& command, std::string& stem);

/// Refuses options that a scene in space has no use for, and the other way round.
void refuse_in_space(const CLI::App& command, const std::vector<std::string>& names);
void refuse_in_plane(const CLI::App& command, const std::vector<std::string>& names);

/// "<where the walls come from>, d_p = ... m, AR = ..." for the reports on the terminal, and a line
/// for each wall of the scene that is no wall of the container.
std::string describe(const Packing& packing);
/// The same, with the vertical.
std::string describe(const SpatialPacking& packing);

}  // namespace rodpack::cli

#endif
