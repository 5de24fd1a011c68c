// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/render.h"
#include "figures/space/packing_picture.h"

#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "cli/checks.h"
#include "cli/commands.h"
#include "cli/input.h"
#include "reading/packing.h"

namespace rodpack::cli {

namespace {

struct RenderArguments {
  Input input;
  RenderOptions render;
  std::vector<double> window;
  std::optional<double> largest;
  std::optional<SphereColour> colour;
  std::optional<double> azimuth, elevation;
  bool in_diameters = false;
  std::string stem = "packing";
};

void draw(const RenderArguments& options, bool in_space) {
  auto render = options.render;
  render.packing = options.input.packing;
  render.largest = options.largest;
  render.colour = options.colour.value_or(in_space ? SphereColour::fsum : SphereColour::force);
  if (in_space) {
    render.space = options.input.space;
    render.azimuth = options.azimuth.value_or(render.azimuth);
    render.elevation = options.elevation.value_or(render.elevation);
    options.input.for_frames(
        [&](const Frame& frame) { render_in_space(frame, render, options.stem); });
    std::cout << "written: " << options.stem << ".png .svg\n";
    return;
  }
  const auto& window = options.window;
  options.input.for_frames([&](const Frame& frame) {
    if (!window.empty()) {
      const double unit = options.in_diameters ? sphere_diameter(frame, render.packing) : 1;
      render.window = {window[0] * unit, window[1] * unit, window[2] * unit, window[3] * unit};
    }
    render_spheres(frame, render, options.stem);
  });
  std::cout << "written: " << options.stem << ".png .svg\n";
}

void add_view_options(CLI::App& command, RenderArguments& options) {
  command
      .add_option("--azimuth", options.azimuth,
                  "in space: where it is seen from, degrees about the vertical, from the next axis "
                  "in the order x, y, z, x towards the one after [default: 30]")
      ->check(number(-360, 360))
      ->type_name("DEG");
  command
      .add_option("--elevation", options.elevation,
                  "in space: the same above the horizontal, degrees [default: 15]")
      ->check(number(-89, 89))
      ->type_name("DEG");
}

}  // namespace

void add_render(CLI::App& app) {
  auto options = std::make_shared<RenderArguments>();
  auto* command = app.add_subcommand("render",
                                     "Picture of a packing: every primary sphere at its true size "
                                     "and place, shaded by the contact "
                                     "force on it, with walls, colour bar and scale bar; in space "
                                     "in perspective, by the ray tracer Tachyon.");
  command->footer(
      "Examples:\n"
      "  rodpack render 'results/quick/dumps/spheres.*.dump'\n"
      "  rodpack render spheres.9000.dump --window 0 40 0 30 --in-dp --colour fsum -o corner\n"
      "write packing.png/.svg and corner.png/.svg.\n"
      "  rodpack render spheres.dump --vertical z --azimuth 60 --colour orientation\n"
      "looks at a scene in space.");
  add_files(*command, options->input, "spheres");
  const std::map<std::string, SphereColour> colours{{"force", SphereColour::force},
                                                    {"fsum", SphereColour::fsum},
                                                    {"orientation", SphereColour::orientation},
                                                    {"none", SphereColour::none}};
  std::vector<std::string> names;
  for (const auto& [name, colour] : colours) names.push_back(name);
  command
      ->add_option_function<std::string>(
          "--colour,--color",
          [options, colours](const std::string& name) { options->colour = colours.at(name); },
          "force: magnitude of the net contact force on the sphere; fsum: sum of the "
          "magnitudes of its contact forces, in space of all its particle's; orientation: of the "
          "particle's long axis, in space its angle to the vertical; none")
      ->check(one_of(names))
      ->default_str("force, in space fsum")
      ->type_name("NAME");
  command
      ->add_option("--window", options->window,
                   "part of the box to draw, m [default: the bed between the walls]")
      ->expected(4)
      ->check(place())
      ->type_name("XLO XHI YLO YHI");
  command->add_flag("--in-dp", options->in_diameters,
                    "--window counts in sphere diameters d_p, not m");
  command
      ->add_option("--max", options->largest,
                   "top of the colour scale, N [default: 99 % of the spheres are "
                   "below]")
      ->check(positive_number(1e15))
      ->type_name("N");
  command
      ->add_option("--pixels", options->render.pixels,
                   "longer side of the drawn window [default: 8 per d_p, 1200 to 4000; in space "
                   "1200]")
      ->check(whole_number(100, 20000))
      ->type_name("N");
  add_view_options(*command, *options);
  add_packing_options(*command, options->input);
  add_space_options(*command, options->input);
  add_output(*command, options->stem);

  command->callback([options, command] {
    if (!options->window.empty()) require_window(options->window);
    const bool in_space = options->input.is_in_space();
    if (in_space)
      refuse_in_space(*command, {"--window", "--in-dp"});
    else
      refuse_in_plane(*command, {"--azimuth", "--elevation"});
    draw(*options, in_space);
  });
}

}  // namespace rodpack::cli
