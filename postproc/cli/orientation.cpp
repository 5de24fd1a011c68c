// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/orientation.h"
#include "analysis/order/bond_order.h"

#include <iostream>
#include <memory>

#include "cli/checks.h"
#include "cli/commands.h"
#include "cli/input.h"
#include "figures/orientation_figure.h"
#include "reading/number_text.h"

namespace rodpack::cli {

namespace {

// Too small a bed, or particles that are no chains, are no reason to refuse the rest.
struct OptionalBondOrder {
  BondOrderSample sample;
  std::string missing;

  void add(const Frame& bodies, const Packing& packing) {
    try {
      if (missing.empty()) sample.add(bodies, packing);
    } catch (const DataError& reason) {
      missing = reason.what();
    }
  }
  std::string line() const {
    try {
      if (!missing.empty()) return "no psi6: " + missing + '\n';
      const auto order = sample.result();
      return "|psi6| = " + number_text(order.local, 4) + " +- " +
             number_text(order.local_error, 2) + " at " + std::to_string(order.points) +
             " points of the centrelines, |<psi6>| = " + number_text(order.global, 4) + '\n';
    } catch (const TooFewParticles& reason) {
      return std::string(reason.what()) + '\n';
    }
  }
};

}  // namespace

void add_orientation(CLI::App& app) {
  struct Options {
    Input input;
    std::string stem = "orientation";
    std::optional<int> bins;
  };
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand(
      "orientation",
      "Distribution of the angle gamma between a particle's long axis and the horizontal: [0, 180) "
      "degrees for straight particles, [0, 360) for curved ones (0 = the arc bulges up), with the "
      "nematic order parameter S2 and its director, the sixfold one S6 = |<exp 6 i gamma>|, and "
      "the "
      "sixfold bond order psi6 of AR points on each centreline. Particles closer than AR d_p to a "
      "side wall or the floor are left out, spheres too.");
  command->footer(
      "Example:\n"
      "  rodpack orientation 'results/quick/dumps/bodies.*.dump' -o gamma\n"
      "writes gamma.csv, gamma.png/.svg (histogram) and gamma_polar.png/.svg (rose).");
  add_files(*command, options->input, "bodies");
  add_all_frames(*command, options->input);
  add_packing_options(*command, options->input);
  command
      ->add_option("--bins", options->bins,
                   "number of bins over the whole range, centred on the multiples of their width "
                   "from 0 on [default: 5 degrees wide: 36, curved particles 72]")
      ->check(whole_number(2, 3600))
      ->type_name("N");
  add_output(*command, options->stem);

  command->callback([options] {
    OrientationSample sample;
    OptionalBondOrder bonds;
    std::string setting;
    options->input.for_frames([&](const Frame& frame) {
      const auto packing = read_packing(frame, options->input.packing);
      sample.add(packing);
      bonds.add(frame, packing);
      setting = describe(packing);
    });
    const auto distribution = sample.distribution(options->bins);
    const auto& stem = options->stem;
    write_orientation_table(distribution, stem + ".csv");
    plot_orientation_linear(distribution, stem);
    plot_orientation_polar(distribution, stem + "_polar");
    std::cout << setting << '\n'
              << options->input.passed_over_line() << distribution.particles
              << " particles; left out: " << distribution.near_walls
              << " closer than AR d_p to a wall, " << distribution.spheres << " spheres\n"
              << "S2 = " << number_text(distribution.nematic.order, 4) << " +- "
              << number_text(distribution.nematic.standard_error, 2) << ", director "
              << number_text(distribution.nematic.director, 4) << " deg\n"
              << "S6 = " << number_text(distribution.sixfold.order, 4)
              << ", <cos 6 gamma> = " << number_text(distribution.sixfold.mean_cosine, 4) << " +- "
              << number_text(distribution.sixfold.standard_error, 2) << '\n'
              << bonds.line() << "written: " << stem << ".csv .png .svg, " << stem
              << "_polar.png .svg\n";
  });
}

}  // namespace rodpack::cli
