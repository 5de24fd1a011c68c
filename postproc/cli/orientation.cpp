// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/orientation.h"

#include <iostream>
#include <memory>
#include <utility>

#include "analysis/order/bond_order.h"
#include "analysis/space/spatial_orientation.h"
#include "cli/checks.h"
#include "cli/commands.h"
#include "cli/input.h"
#include "reading/number_text.h"
#include "report/mixture_outputs.h"
#include "report/outputs.h"

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

struct OrientationCommand {
  Input input;
  std::string stem = "orientation";
  std::optional<int> bins;
};

// The kinds of a mixture, of the last frame; `measure`: S2 and shares of a mixture. Adds to what is
// `written`, and returns lines for the terminal, none where all particles are of one kind.
template <class Measure>
std::string by_kind(const Frame& last, const Measure& measure, const std::string& stem,
                    std::string& written) {
  std::string note;
  const auto mixture = kinds_to_measure(last, note);
  if (!mixture) return note.empty() ? "" : note + '\n';
  return write_by_kind(*mixture, measure(*mixture), {}, stem, written);
}

void orientation_in_plane(const OrientationCommand& options) {
  OrientationSample sample;
  OptionalBondOrder bonds;
  Packing last_packing;
  const Frame& last = options.input.for_frames([&](const Frame& frame) {
    auto packing = read_packing(frame, options.input.packing);
    sample.add(packing);
    bonds.add(frame, packing);
    last_packing = std::move(packing);
  });
  const auto distribution = sample.distribution(options.bins);
  auto written = write_orientation(distribution, options.stem);
  const auto kinds = by_kind(
      last, [&](const Mixture& mixture) { return measure_species(last_packing, mixture); },
      options.stem, written);
  std::cout << describe(last_packing) << '\n'
            << options.input.passed_over_line() << distribution.particles
            << " particles; left out: " << distribution.near_walls
            << " closer than AR d_p to a wall, " << distribution.spheres << " spheres\n"
            << "S2 = " << number_text(distribution.nematic.order, 4) << " +- "
            << number_text(distribution.nematic.standard_error, 2) << ", director "
            << number_text(distribution.nematic.director, 4) << " deg\n"
            << "S6 = " << number_text(distribution.sixfold.order, 4)
            << ", <cos 6 gamma> = " << number_text(distribution.sixfold.mean_cosine, 4) << " +- "
            << number_text(distribution.sixfold.standard_error, 2) << '\n'
            << bonds.line() << kinds << "written: " << written << '\n';
}

void report_order(const SpatialOrientation& result) {
  const auto& order = result.order;
  const auto chance = isotropic_order(order.number);
  const auto director = direction_angles(order.direction[0], result.vertical);
  std::cout << order.number << " particles; left out: " << result.near_walls
            << " closer than AR d_p to a wall, " << result.spheres << " spheres\n"
            << "S2 = " << number_text(order.value[0], 4) << " +- "
            << number_text(order.standard_error[0], 2) << " (without its bias "
            << number_text(order.order_without_bias, 4) << "), of as many isotropic particles "
            << number_text(chance.mean, 2) << " +- " << number_text(chance.deviation, 2) << '\n'
            << "director " << number_text(director.polar, 4) << " deg from the vertical, azimuth "
            << number_text(director.azimuth, 4) << " deg, +- "
            << number_text(order.director_standard_error, 2) << " deg\n"
            << "principal values";
  for (std::size_t k = 0; k < 3; ++k)
    std::cout << (k > 0 ? ", " : " ") << number_text(order.value[k], 4) << " +- "
              << number_text(order.standard_error[k], 2);
  std::cout << "\norder about the vertical " << number_text(result.about_vertical.value, 4)
            << " +- " << number_text(result.about_vertical.standard_error, 2)
            << " (1 upright, 0 isotropic, -0.5 flat)\n";
}

void orientation_in_space(const OrientationCommand& options) {
  SpatialOrientationSample sample;
  SpatialPacking last_packing;
  const Frame& last = options.input.for_frames([&](const Frame& frame) {
    auto packing = read_spatial_packing(frame, options.input.packing, options.input.space);
    sample.add(packing);
    last_packing = std::move(packing);
  });
  const auto result = sample.result(options.bins);
  auto written = write_orientation(result, options.stem);
  const auto kinds = by_kind(
      last, [&](const Mixture& mixture) { return measure_species(last_packing, last, mixture); },
      options.stem, written);
  std::cout << describe(last_packing) << '\n' << options.input.passed_over_line();
  report_order(result);
  std::cout << kinds << "written: " << written << '\n';
}

}  // namespace

void add_orientation(CLI::App& app) {
  auto options = std::make_shared<OrientationCommand>();
  auto* command = app.add_subcommand(
      "orientation",
      "In a plane: distribution of the angle gamma between a particle's long axis and the "
      "horizontal: [0, 180) degrees for straight particles, [0, 360) for curved ones (0 = the arc "
      "bulges up), with the nematic order parameter S2 and its director, the sixfold one S6 = "
      "|<exp 6 i gamma>|, and the sixfold bond order psi6 of AR points on each centreline. In "
      "space: distributions "
      "of the long axis's angle to the vertical and of its azimuth, order tensor with its "
      "principal values and directions. Particles closer than AR d_p to a side wall or the floor "
      "are left out, spheres too. A mixture is measured by kind too.");
  command->footer(
      "Example:\n"
      "  rodpack orientation 'results/quick/dumps/bodies.*.dump' -o gamma\n"
      "writes gamma.csv, gamma.png/.svg (histogram) and gamma_polar.png/.svg (rose).\n"
      "  rodpack orientation bodies.dump --vertical z\n"
      "writes, in space, orientation.csv, orientation_azimuth.csv with figures of these names and\n"
      "orientation_order.csv. Of a mixture, orientation_mixture.csv too, of the last frame.");
  add_files(*command, options->input, "bodies");
  add_all_frames(*command, options->input);
  add_packing_options(*command, options->input);
  add_space_options(*command, options->input);
  command
      ->add_option(
          "--bins", options->bins,
          "number of bins over the whole range; angles in a plane and azimuths are centred "
          "on the multiples of their width from 0 on [default: 5 degrees wide: 36, curved "
          "particles 72; angle to the vertical: 18 of equal solid angle]")
      ->check(whole_number(2, 3600))
      ->type_name("N");
  add_output(*command, options->stem);

  command->callback([options] {
    if (options->input.is_in_space())
      orientation_in_space(*options);
    else
      orientation_in_plane(*options);
  });
}

}  // namespace rodpack::cli
