// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/rdf.h"

#include <iostream>
#include <memory>

#include "cli/commands.h"
#include "cli/input.h"
#include "figures/rdf_figure.h"
#include "reading/number_text.h"

namespace rodpack::cli {

void add_rdf(CLI::App& app) {
  struct Options {
    Input input;
    RdfOptions rdf;
    std::string stem = "rdf";
  };
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand(
      "rdf",
      "Radial distribution function G(r) of the centres of mass. Centres lie "
      "further than (10 + AR) "
      "d_p from the walls and from the surface of the bed (less in a small bed, "
      "and the report says "
      "so); their neighbours count up to AR d_p from them. G tends to 1 at large r.");
  command->footer(
      "Example:\n"
      "  rodpack rdf 'results/quick/dumps/bodies.*.dump' --r-max 15\n"
      "writes rdf.csv and rdf.png/.svg.");
  add_files(*command, options->input, "bodies");
  add_all_frames(*command, options->input);
  add_packing_options(*command, options->input);
  command->add_option("--bin", options->rdf.bin_width, "width of a bin, in d_p")
      ->check(CLI::Range(1e-3, 10.0))
      ->capture_default_str()
      ->type_name("DR");
  command->add_option("--r-max", options->rdf.largest_distance, "largest distance, in d_p")
      ->check(CLI::Range(1e-3, 1000.0))
      ->capture_default_str()
      ->type_name("R");
  command
      ->add_option("--margin", options->rdf.margin,
                   "distance of the centres from walls and surface, in d_p [default: 10 + AR, at "
                   "most a third of the bed's smaller extent]")
      ->check(CLI::NonNegativeNumber)
      ->type_name("R");
  add_output(*command, options->stem);

  command->callback([options] {
    RdfSample sample(options->rdf);
    std::string setting;
    options->input.for_frames([&](const Frame& frame) {
      const auto packing = read_packing(frame, options->input.packing);
      sample.add(packing);
      setting = describe(packing);
    });
    const auto rdf = sample.result();
    write_rdf_table(rdf, options->stem + ".csv");
    plot_rdf(rdf, options->stem);
    std::cout << setting << '\n'
              << rdf.centres << " centres further than " << number_text(rdf.margin, 4)
              << " d_p from walls and surface"
              << (rdf.margin_reduced ? " (the bed is too small for 10 + AR)" : "") << '\n'
              << "last quarter of r: G = " << number_text(rdf.tail_g, 4) << " +- "
              << number_text(rdf.tail_standard_error, 2) << '\n'
              << "written: " << options->stem << ".csv .png .svg\n";
  });
}

}  // namespace rodpack::cli
