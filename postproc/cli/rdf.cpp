// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/rdf.h"

#include <iostream>
#include <memory>
#include <optional>
#include <utility>

#include "analysis/pairs/peak_configurations.h"
#include "analysis/space/axial_rdf.h"
#include "analysis/space/pairs/spatial_peak.h"
#include "analysis/space/spatial_rdf.h"

#include "cli/checks.h"
#include "cli/commands.h"
#include "cli/input.h"
#include "figures/pairs/peak_figure.h"
#include "reading/number_text.h"
#include "report/mixture_outputs.h"
#include "report/outputs.h"

namespace rodpack::cli {
namespace {

struct RdfCommand {
  Input input;
  RdfOptions rdf;
  std::optional<double> explain, explain_width;  // d_p
  std::optional<double> axial;                   // d_p
  AxialRdfOptions along_across;
  std::string stem = "rdf";
};

// Of the frames by PeakSample or SpatialPeakSample; `read`: makes its packing of a frame.
template <class Sample, class Read>
std::optional<PeakExplanation> explain_peak(const RdfCommand& options, const Rdf& rdf,
                                            const Read& read) {
  if (!options.explain) return std::nullopt;
  Sample sample(options.rdf, find_rdf_peak(rdf, *options.explain, options.explain_width));
  options.input.for_frames([&](const Frame& frame) { sample.add(frame, read(frame)); });
  return sample.result();
}

void write_explanation(const PeakExplanation& explanation, const Rdf& rdf,
                       const std::string& stem) {
  const auto& peak = explanation.peak;
  write_peak_table(explanation, stem + ".csv");
  plot_peak(rdf, explanation, stem);
  std::cout << "pairs at " << number_text(peak.from, 4) << " to " << number_text(peak.to, 4)
            << " d_p, highest G = " << number_text(peak.g, 3) << " at "
            << number_text(peak.summit, 4) << ": " << number_text(explanation.pairs) << ", "
            << number_text(100 * explanation.touching_share, 3) << " % touch\n";
  for (const auto& each : explanation.configurations)
    std::cout << "  " << number_text(100 * each.share, 3) << " %  " << each.name << ", spread "
              << number_text(each.spread, 2) << " d_p\n";
  std::cout << "  " << number_text(100 * explanation.other_share, 3) << " %  other\n"
            << "written: " << stem << ".csv .png .svg\n";
}

void add_rdf_options(CLI::App& command, RdfCommand& options) {
  command.add_option("--bin", options.rdf.bin_width, "width of a bin, in d_p")
      ->check(number(1e-3, 10))
      ->capture_default_str()
      ->type_name("DR");
  command.add_option("--r-max", options.rdf.largest_distance, "largest distance, in d_p")
      ->check(number(1e-3, 1000))
      ->capture_default_str()
      ->type_name("R");
  command
      .add_option("--margin", options.rdf.margin,
                  "distance of the centres from walls and surface, in d_p [default: 10 + AR, at "
                  "most a third of the bed's smaller extent]")
      ->check(number(0, 1000))
      ->type_name("R");
  auto* explain =
      command
          .add_option("--explain", options.explain,
                      "distance in d_p: find the configurations of the pairs of the peak of G(r) "
                      "next to it")
          ->check(number(0, 1000))
          ->type_name("R");
  command
      .add_option("--explain-width", options.explain_width,
                  "explain all bins within so many d_p of that distance, peak or not [default: "
                  "the peak's bins above half its prominence]")
      ->check(number(0, 1000))
      ->type_name("DR")
      ->needs(explain);
}

void add_axial_options(CLI::App& command, RdfCommand& options) {
  auto* axial =
      command
          .add_option("--axial", options.axial,
                      "in space: also the pair correlation along and across the centre particle's "
                      "axis up to this distance, in d_p; its centres lie further than R + AR from "
                      "walls and surface")
          ->check(number(0.1, 1000))
          ->type_name("R");
  command
      .add_option("--axial-bin", options.along_across.bin_width,
                  "width of a bin along and across, in d_p")
      ->check(number(1e-3, 10))
      ->capture_default_str()
      ->type_name("DR")
      ->needs(axial);
}

void require_few_bins(double distance, double width, double most, const std::string& option,
                      const std::string& up_to) {
  if (distance / width > most)
    throw CLI::ValidationError(option, "expected at most " + number_text(most) + " bins up to " +
                                           up_to + ", found " + number_text(distance / width));
}

// Partial ones of a mixture, of the last frame. Adds to what is `written`, and returns lines for
// the terminal, none where all particles are of one kind.
template <class AnyPacking>
std::string by_kind(const Frame& last, const AnyPacking& packing, const RdfCommand& options,
                    std::string& written) {
  std::string note;
  const auto mixture = kinds_to_measure(last, note);
  if (mixture) {
    try {
      const auto rdf = partial_rdf(packing, *mixture, options.rdf);
      written += ", " + write_partial_rdf(rdf, *mixture, options.stem + "_partial", note);
    } catch (const TooFewParticles& reason) {
      note = std::string("partial RDF: ") + reason.what();
    }
  }
  const auto kinds = mixture ? "by kind, last frame:\n" + describe(*mixture, {}, {}) : "";
  return note.empty() ? kinds : kinds + note + '\n';
}

std::string largest_distances(const Rdf& rdf) {
  return "last quarter of r: G = " + number_text(rdf.tail_g, 4) + " +- " +
         number_text(rdf.tail_standard_error, 2) + '\n';
}

void rdf_in_space(const RdfCommand& options) {
  SpatialRdfSample sample(options.rdf);
  std::optional<AxialRdfSample> axial_sample;
  if (options.axial) axial_sample.emplace(options.along_across);
  SpatialPacking last_packing;
  const auto read = [&](const Frame& frame) {
    return read_spatial_packing(frame, options.input.packing, options.input.space);
  };
  const Frame& last = options.input.for_frames([&](const Frame& frame) {
    auto packing = read(frame);
    sample.add(packing);
    if (axial_sample) axial_sample->add(packing);
    last_packing = std::move(packing);
  });
  const auto rdf = sample.result();
  const auto explanation = explain_peak<SpatialPeakSample>(options, rdf, read);
  auto written = write_rdf(rdf, options.stem);
  const auto kinds = by_kind(last, last_packing, options, written);
  std::cout << describe(last_packing) << '\n'
            << options.input.passed_over_line() << rdf.centres << " centres";
  if (rdf.margin > 0)
    std::cout << " further than " << number_text(rdf.margin, 4) << " d_p from walls and surface"
              << (rdf.margin_reduced ? " (the bed is too small for 10 + AR)" : "");
  std::cout << '\n' << largest_distances(rdf);
  if (axial_sample) {
    const auto axial = axial_sample->result();
    written += ", " + write_axial_rdf(axial, options.stem + "_axial");
    std::cout << "along and across: " << axial.centres << " centres";
    if (axial.margin > 0)
      std::cout << " further than " << number_text(axial.margin, 4)
                << " d_p from walls and surface";
    std::cout << '\n';
  }
  std::cout << kinds << "written: " << written << '\n';
  if (explanation) write_explanation(*explanation, rdf, options.stem + "_explained");
}

void rdf_in_plane(const RdfCommand& options) {
  if (options.axial) throw CLI::ValidationError("--axial", "expected in a scene in space alone");
  RdfSample sample(options.rdf);
  Packing last_packing;
  const auto read = [&](const Frame& frame) { return read_packing(frame, options.input.packing); };
  const Frame& last = options.input.for_frames([&](const Frame& frame) {
    auto packing = read(frame);
    sample.add(packing);
    last_packing = std::move(packing);
  });
  const auto rdf = sample.result();
  // A wrong distance shows before anything is written.
  const auto explanation = explain_peak<PeakSample>(options, rdf, read);
  auto written = write_rdf(rdf, options.stem);
  const auto kinds = by_kind(last, last_packing, options, written);
  std::cout << describe(last_packing) << '\n'
            << options.input.passed_over_line() << rdf.centres << " centres further than "
            << number_text(rdf.margin, 4) << " d_p from walls and surface"
            << (rdf.margin_reduced ? " (the bed is too small for 10 + AR)" : "") << '\n'
            << largest_distances(rdf) << kinds << "written: " << written << '\n';
  if (explanation) write_explanation(*explanation, rdf, options.stem + "_explained");
}

void run_rdf(RdfCommand& options) {
  require_few_bins(options.rdf.largest_distance, options.rdf.bin_width, 1e4, "--bin", "--r-max");
  if (options.rdf.bin_width > options.rdf.largest_distance)
    throw CLI::ValidationError(
        "--r-max", "expected the width of a bin (--bin), " + number_text(options.rdf.bin_width) +
                       " d_p, at least, found " + number_text(options.rdf.largest_distance));
  if (options.axial) {
    options.along_across.largest_distance = *options.axial;
    require_few_bins(*options.axial, options.along_across.bin_width, 1e3, "--axial-bin", "--axial");
    if (2 * options.along_across.bin_width > *options.axial)
      throw CLI::ValidationError(
          "--axial", "expected at least 2 bins, found " + number_text(*options.axial) + " d_p");
  }
  if (options.input.is_in_space())
    rdf_in_space(options);
  else
    rdf_in_plane(options);
}

}  // namespace

void add_rdf(CLI::App& app) {
  auto options = std::make_shared<RdfCommand>();
  auto* command = app.add_subcommand(
      "rdf",
      "Radial distribution function G(r) of the centres of mass, in a plane or in space. Centres "
      "lie "
      "further than (10 + AR) d_p from the walls and from the surface of the bed (less in a small "
      "bed, and the report says so); their neighbours count up to AR d_p from them. G tends to 1 "
      "at "
      "large r. Of a mixture also by pairs of kinds.");
  command->footer(
      "Example:\n"
      "  rodpack rdf 'results/quick/dumps/bodies.*.dump' --r-max 15\n"
      "writes rdf.csv and rdf.png/.svg; of a mixture rdf_partial.csv and .png/.svg too, of the "
      "last "
      "frame.\n"
      "  rodpack rdf 'results/quick/dumps/bodies.*.dump' --explain 1.7\n"
      "says in rdf_explained.csv and .png/.svg how the pairs of the peak near 1.7 d_p lie. To pool "
      "runs, name\nthe last dump of each and add --all-frames.\n"
      "  rodpack rdf bodies.dump --vertical z --axial 8\n"
      "writes, in space, rdf_axial.csv and .png/.svg too: the pair correlation along and across a\n"
      "particle's axis.");
  add_files(*command, options->input, "bodies");
  add_all_frames(*command, options->input);
  add_packing_options(*command, options->input);
  add_space_options(*command, options->input);
  add_rdf_options(*command, *options);
  add_axial_options(*command, *options);
  add_output(*command, options->stem);

  command->callback([options] { run_rdf(*options); });
}

}  // namespace rodpack::cli
