// SPDX-License-Identifier: GPL-2.0-or-later
#include "cli/input.h"

#include "reading/number_text.h"

namespace rodpack::cli {

void Input::for_frames(const std::function<void(const Frame&)>& visit) const {
  const auto files = find_dumps(patterns);
  if (all_frames)
    for_each_frame(files, visit);
  else
    visit(last_frame(files));
}

void add_files(CLI::App& command, Input& input, const std::string& kind) {
  command
      .add_option("dumps", input.patterns,
                  "dump files of " + kind +
                      ", plain or .gz; quoted wildcards are fine; they are "
                      "ordered by timestep, and the last frame is used")
      ->required()
      ->type_name("FILE");
}

void add_all_frames(CLI::App& command, Input& input) {
  command.add_flag("--all-frames", input.all_frames, "use every frame, not only the last");
}

void add_packing_options(CLI::App& command, Input& input) {
  auto& packing = input.packing;
  command
      .add_option("--walls", packing.walls,
                  "x of the left and right wall and y of the floor, m [default: parameters.json, "
                  "else the box bounds of the dump; a periodic direction has no walls]")
      ->expected(3)
      ->type_name("LEFT RIGHT FLOOR");
  command
      .add_option("--dp", packing.particle_diameter,
                  "primary sphere diameter d_p, m [default: parameters.json, else the mean]")
      ->check(CLI::PositiveNumber)
      ->type_name("M");
  command
      .add_option("--ar", packing.aspect_ratio,
                  "aspect ratio AR [default: parameters.json, else the longest particle's]")
      ->check(CLI::PositiveNumber)
      ->type_name("AR");
  command
      .add_option("--parameters", packing.parameters,
                  "parameters.json of the run [default: beside the dump or one folder up]")
      ->type_name("FILE");
}

void add_output(CLI::App& command, std::string& stem) {
  command.add_option("-o,--output", stem, "start of the names of the files to write")
      ->capture_default_str()
      ->type_name("STEM");
}

std::string describe(const Packing& packing) {
  return "walls: " + packing.walls.source + "; d_p = " + number_text(packing.particle_diameter, 5) +
         " m, AR = " + number_text(packing.aspect_ratio, 4) + ", bed " +
         number_text((packing.surface - packing.walls.floor) / packing.particle_diameter, 4) +
         " d_p high";
}

}  // namespace rodpack::cli
