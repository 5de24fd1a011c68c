// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/contact_forces.h"

#include <iostream>
#include <memory>
#include <optional>

#include "analysis/force_chains.h"
#include "analysis/space/fabric.h"
#include "analysis/stock/local_contacts.h"
#include "analysis/stock/stock_dumps.h"
#include "cli/checks.h"
#include "cli/commands.h"
#include "cli/input.h"
#include "figures/force_chains_figure.h"
#include "figures/render.h"
#include "reading/checks/planar.h"
#include "reading/number_text.h"
#include "reading/packing.h"
#include "reading/scene/run_scene.h"
#include "report/mixture_outputs.h"
#include "report/outputs.h"

namespace rodpack::cli {
namespace {

struct ForcesArguments {
  Input input;
  std::vector<std::string> bodies;
  LocalContactOptions local;
  ContactForceOptions forces;
  std::optional<double> friction;
  std::string stem = "forces";
};

void report_friction(const MobilisedFriction& friction, std::ostream& out) {
  out << "mobilised friction: mean " << number_text(friction.mean, 4) << ", sliding "
      << number_text(friction.sliding_fraction, 4)
      << " of the contacts; mu = " << number_text(friction.lowest, 4);
  if (friction.highest > friction.lowest) out << " to " << number_text(friction.highest, 4);
  out << '\n';
  for (const auto& pair : friction.by_type)
    out << "  atom types " << pair.lower_type << " and " << pair.upper_type << ", mu "
        << number_text(pair.coefficient, 4) << ": " << pair.contacts << " contacts, mean "
        << number_text(pair.mean, 4) << ", sliding " << number_text(pair.sliding_fraction, 4)
        << '\n';
  if (friction.frictionless > 0)
    out << "  left out: " << friction.frictionless << " contacts of friction 0\n";
}

void report(const ContactForces& forces, std::ostream& out) {
  out << forces.carrying << " contacts; left out: " << forces.not_carrying
      << " without normal force, " << forces.at_walls << " with walls\n"
      << "mean normal force " << number_text(forces.normal.mean, 4) << " N, tangential "
      << number_text(forces.tangential.mean, 4) << " N\n";
  if (forces.friction)
    report_friction(*forces.friction, out);
  else
    out << forces.why_no_friction << '\n';
  const auto& coordination = forces.coordination;
  out << coordination.particles << " particles touch "
      << number_text(coordination.touching_particles, 4) << " others each, with "
      << number_text(coordination.contacts, 4) << " sphere contacts; ";
  if (coordination.rattlers)
    out << *coordination.rattlers << " have no contact\n";
  else
    out << "those without contact are missed: no --bodies\n";
}

void report_fabric(const Fabric& fabric) {
  const auto chance = isotropic_order(fabric.order.number);
  std::cout << "order of the contact normals";
  for (std::size_t k = 0; k < 3; ++k)
    std::cout << (k > 0 ? ", " : " ") << number_text(fabric.order.value[k], 4) << " +- "
              << number_text(fabric.order.standard_error[k], 2);
  std::cout << " (the first of as many isotropic ones " << number_text(chance.mean, 2) << " +- "
            << number_text(chance.deviation, 2) << "), about the vertical "
            << number_text(fabric.about_vertical.value, 4) << " +- "
            << number_text(fabric.about_vertical.standard_error, 2) << '\n';
}

// Who touches whom in a mixture, of the last frame, where all particles are known.
std::string touching_by_kind(const Frame& contacts, const std::vector<std::string>& body_files,
                             const std::string& stem, std::string& written) {
  if (body_files.empty()) return "";
  try {
    const auto bodies = as_bodies(frame_beside(contacts, body_files));
    std::string note;
    const auto mixture = kinds_to_measure(bodies, note);
    if (!mixture) return note.empty() ? "" : note + '\n';
    const auto coordination = coordination_by_species(contacts, bodies, *mixture);
    return write_by_kind(*mixture, {}, coordination, stem, written);
  } catch (const DataError& reason) {  // a dump of ids alone tells no kinds
    return std::string("not by kind: ") + reason.what() + '\n';
  }
}

// The axis that points up, where the contacts are to be measured in space.
std::optional<std::size_t> vertical_in_space(const Input& input, const Frame& contacts,
                                             bool planar) {
  const auto vertical = find_vertical(contacts, input.packing.parameters, input.space);
  constexpr std::size_t y = 1;
  if (planar && vertical.value_or(y) == y) return std::nullopt;
  return vertical;
}

void measure(const ForcesArguments& options) {
  const auto& input = options.input;
  auto packing = input.packing;
  std::vector<std::string> body_files;
  if (!options.bodies.empty()) body_files = find_dumps(options.bodies);
  auto settings = options.forces;
  settings.friction = find_friction(input.last(), input.packing.parameters, options.friction);
  ContactForceSample sample(settings);
  const Frame& last = input.for_frames([&](const Frame& frame) {
    std::optional<Frame> bodies;
    if (!body_files.empty()) bodies = as_bodies(frame_beside(frame, body_files));
    sample.add(frame, bodies ? &*bodies : nullptr);
    if (bodies) packing.particle_diameter = sphere_diameter(*bodies, packing);
  });
  const auto forces = sample.result();
  force_lines(last);  // bad columns show before anything is written
  const auto not_planar = why_contacts_not_planar(last);
  const auto vertical = vertical_in_space(input, last, not_planar.empty());
  std::optional<Fabric> fabric;
  if (vertical) fabric = measure_fabric(sample.normals(), sample.normal_forces(), *vertical);
  const auto& stem = options.stem;
  auto written = write_contact_forces(forces, stem);
  if (fabric) written += ", " + write_fabric(*fabric, stem + "_fabric");
  if (not_planar.empty()) draw_force_chains(last, packing, stem + "_chains");
  const auto kinds = touching_by_kind(last, body_files, stem, written);
  report(forces, std::cout);
  std::cout << kinds;
  if (fabric)
    report_fabric(*fabric);
  else if (!not_planar.empty())
    std::cout << "the fabric is left out: no --vertical, dump scene or 'vertical_axis' in "
                 "parameters.json\n";
  if (!options.local.words.empty()) std::cout << note_on_local_contacts(options.local) << '\n';
  std::cout << input.passed_over_line();
  if (!not_planar.empty()) std::cout << "no picture of the chains: " << not_planar << '\n';
  if (not_planar.empty()) written += ", " + stem + "_chains.png .svg";
  std::cout << "written: " << written << '\n';
}

}  // namespace

void add_forces(CLI::App& app) {
  auto options = std::make_shared<ForcesArguments>();
  auto* command = app.add_subcommand(
      "forces",
      "Contact forces: distributions of the normal and the tangential force over their means, "
      "mobilised friction f_t / (mu f_n), numbers of contacts per particle, in a plane a picture "
      "of "
      "the force chains (last frame), a line per touching pair, and in space the order tensor of "
      "the contact normals, with their angles to the vertical and the force by angle. Contacts "
      "with walls are left out but in the picture.");
  command->footer(
      "Example:\n"
      "  rodpack forces 'results/quick/dumps/contacts.*.dump' \\\n"
      "      --bodies 'results/quick/dumps/bodies.*.dump'\n"
      "writes forces.csv, forces_friction.csv, forces_coordination.csv, the figures of the same\n"
      "names and forces_chains, each .png/.svg; in space, with --vertical, forces_fabric.csv .png "
      ".svg\n"
      "and forces_fabric_order.csv. Of a mixture, with --bodies, forces_mixture.csv too.\n"
      "  rodpack forces pairs.dump --local pos id force --local-walls walls.dump \\\n"
      "      --bodies spheres.dump\n"
      "reads LIGGGHTS's own dumps of a deck with\n"
      "  compute pairs all pair/gran/local pos id force\n"
      "  dump pairs all local 1000 pairs.dump c_pairs[1] c_pairs[2] ... c_pairs[12]");
  add_files(*command, options->input, "contacts");
  add_all_frames(*command, options->input);
  auto* bodies =
      command
          ->add_option(
              "--bodies", options->bodies,
              "dump files of bodies with the same timesteps, to know the particles without "
              "contact; a quoted wildcard is fine")
          ->check(existing_files())
          ->type_name("FILE");
  add_local_contacts(*command, options->local, "--bodies is then")->needs(bodies);
  command->add_option("--bin", options->forces.bin_width, "width of a bin, in mean forces")
      ->check(number(1e-3, 10))
      ->capture_default_str()
      ->type_name("DF");
  command
      ->add_option("--friction", options->friction,
                   "friction coefficient mu of all contacts [default: the scene's, of each "
                   "contact's two atom types, parameters.json; unknown: no mobilised friction]")
      ->check(positive_number(1000))
      ->type_name("MU");
  command->add_flag("--walls-too", options->forces.walls_too,
                    "contacts with walls count too, but not as touching particles");
  add_packing_options(*command, options->input);
  add_vertical(*command, options->input);
  add_output(*command, options->stem);

  command->callback([options] {
    if (!options->local.words.empty())
      options->input.convert = [&](const Frame& pairs) {
        return read_local_contacts(pairs, options->local,
                                   frame_beside(pairs, find_dumps(options->bodies)));
      };
    measure(*options);
  });
}

}  // namespace rodpack::cli
