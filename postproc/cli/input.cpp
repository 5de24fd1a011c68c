// SPDX-License-Identifier: GPL-2.0-or-later
#include "cli/input.h"

#include <utility>

#include "analysis/stock/stock_dumps.h"
#include "cli/checks.h"
#include "reading/checks/frame_pool.h"
#include "reading/number_text.h"

namespace rodpack::cli {

namespace {

// The frame as this kind of dump has it.
Frame of_kind(const Frame& frame, const std::string& kind) {
  if (kind == "bodies") return as_bodies(frame);
  if (kind == "contacts") require_contact_dump(frame);
  return frame;
}

}  // namespace

Frame Input::taken(const Frame& read) const {
  return convert ? convert(read) : of_kind(read, kind);
}

const Frame& Input::last() const {
  if (!last_) last_ = taken(last_frame(find_dumps(patterns)));
  return *last_;
}

const Frame& Input::for_frames(const std::function<void(const Frame&)>& visit) const {
  if (!all_frames) {
    visit(last());
    return last();
  }
  const auto files = find_dumps(patterns);
  FramePool pool;
  bool any = false;
  for_each_frame(files, [&](const Frame& read) {
    auto frame = taken(read);
    if (!pool.take(frame)) return;
    any = true;
    visit(frame);
    last_visited_ = std::move(frame);
  });
  if (!any) throw DataError(files.back() + ": no rows in any frame");
  passed_over = pool.passed_over();
  return last_visited_;
}

bool Input::is_in_space() const {
  const bool result = rodpack::is_in_space(last(), packing, space);
  const auto refuse = [](const std::string& option, const std::string& scene) {
    throw CLI::ValidationError(option, "expected in a scene " + scene + " alone");
  };
  if (result && !packing.walls.empty()) refuse("--walls", "in a plane");
  if (!result && !space.container.empty()) refuse("--container", "in space");
  if (!result && !space.cylinder.empty()) refuse("--cylinder", "in space");
  return result;
}

void add_files(CLI::App& command, Input& input, const std::string& kind) {
  input.kind = kind;
  command
      .add_option("dumps", input.patterns,
                  "dump files of " + kind +
                      ", plain or .gz; quoted wildcards are fine; they are "
                      "ordered by timestep, and the last frame is used")
      ->required()
      ->check(some_name())
      ->type_name("FILE");
}

void add_all_frames(CLI::App& command, Input& input) {
  command.add_flag("--all-frames", input.all_frames, "use every frame, not only the last");
}

void add_packing_options(CLI::App& command, Input& input) {
  auto& packing = input.packing;
  command
      .add_option("--walls", packing.walls,
                  "x of the left and right wall and y of the floor, m [default: dump scene, else "
                  "parameters.json, else the box bounds of the dump; a periodic direction has no "
                  "walls]")
      ->expected(3)
      ->check(place())
      ->type_name("LEFT RIGHT FLOOR");
  command
      .add_option("--dp", packing.particle_diameter,
                  "primary sphere diameter d_p, m [default: parameters.json, else the mean]")
      ->check(length())
      ->type_name("M");
  command
      .add_option("--ar", packing.aspect_ratio,
                  "aspect ratio AR [default: parameters.json, else the longest particle's]")
      ->check(number(1, 1000))
      ->type_name("AR");
  command
      .add_option("--parameters", packing.parameters,
                  "parameters.json of the run [default: beside the dump or one folder up]")
      ->check(existing_file())
      ->type_name("FILE");
}

void add_vertical(CLI::App& command, Input& input) {
  command
      .add_option("--vertical", input.space.vertical,
                  "in space: the axis that points up [default: gravity of dump scene, else "
                  "'vertical_axis' of parameters.json; in a plane y]")
      ->check(one_of({"x", "y", "z"}))
      ->type_name("AXIS");
}

void add_space_options(CLI::App& command, Input& input) {
  add_vertical(command, input);
  auto& space = input.space;
  command
      .add_option(
          "--container", space.container,
          "in space: walls of the container, whose top is open, m [default: dump scene, else "
          "'container' of parameters.json, else the box bounds of the dump; a periodic direction "
          "has no walls]")
      ->expected(6)
      ->check(place())
      ->type_name("XLO XHI YLO YHI ZLO ZHI");
  command
      .add_option("--cylinder", space.cylinder,
                  "in space: the side wall is an upright cylinder: the horizontal coordinates of "
                  "its axis, in the order x, y, z, x after the vertical, and its radius, m")
      ->expected(3)
      ->check(place())
      ->type_name("A B RADIUS");
}

CLI::Option* add_local_contacts(CLI::App& command, LocalContactOptions& local,
                                const std::string& spheres) {
  auto* words =
      command
          .add_option("--local", local.words,
                      "the contacts' dumps are LIGGGHTS's own dump local of compute "
                      "pair/gran/local: the words behind that compute, id and force among them; " +
                          spheres +
                          " a dump custom of the spheres, id type x y z radius "
                          "id_multisphere")
          ->check(one_of(local_contact_words()))
          ->type_name("WORD...");
  command
      .add_option("--local-walls", local.wall_files,
                  "dump local of compute wall/gran/local with the same words, pos among them: the "
                  "contacts with meshes")
      ->check(existing_files())
      ->type_name("FILE")
      ->needs(words);
  return words;
}

void add_output(CLI::App& command, std::string& stem) {
  command.add_option("-o,--output", stem, "start of the names of the files to write")
      ->check(stem_of_files())
      ->capture_default_str()
      ->type_name("STEM");
}

void refuse_in_space(const CLI::App& command, const std::vector<std::string>& names) {
  for (const auto& name : names)
    if (command.count(name) > 0)
      throw CLI::ValidationError(name, "expected in a scene in a plane alone");
}

void refuse_in_plane(const CLI::App& command, const std::vector<std::string>& names) {
  for (const auto& name : names)
    if (command.count(name) > 0)
      throw CLI::ValidationError(name, "expected in a scene in space alone");
}
namespace {

std::string lines_of_notes(const std::vector<std::string>& notes) {
  std::string text;
  for (const auto& note : notes) text += "\nnote: " + note;
  return text;
}

}  // namespace

std::string describe(const Packing& packing) {
  return "walls: " + packing.walls.source + "; d_p = " + number_text(packing.particle_diameter, 5) +
         " m, AR = " + number_text(packing.aspect_ratio, 4) + ", bed " +
         number_text((packing.surface - packing.walls.floor) / packing.particle_diameter, 4) +
         " d_p high" + (packing.inclination == 0 ? "" : "\n" + note_on_slope(packing)) +
         lines_of_notes(packing.walls.notes);
}

std::string describe(const SpatialPacking& packing) {
  const auto& walls = packing.walls;
  const auto up = walls.vertical;
  return "in space, " + std::string(1, "xyz"[up]) + " up; walls: " + walls.source +
         "; d_p = " + number_text(packing.particle_diameter, 5) +
         " m, AR = " + number_text(packing.aspect_ratio, 4) + ", bed " +
         number_text((packing.surface - walls.low[up]) / packing.particle_diameter, 4) +
         " d_p high" + lines_of_notes(walls.notes);
}

}  // namespace rodpack::cli
