// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/measures.h"

#include "analysis/energies.h"
#include "analysis/fields.h"
#include "analysis/force_chains.h"
#include "analysis/janssen_fit.h"
#include "analysis/order/bond_order.h"
#include "analysis/orientation.h"
#include "analysis/pressure_profile.h"
#include "analysis/rdf.h"
#include "analysis/solid_fraction.h"
#include "analysis/stock/stock_dumps.h"
#include "figures/energies_figure.h"
#include "figures/field_maps.h"
#include "figures/solid_fraction_figure.h"
#include "reading/number_text.h"
#include "reading/run_folder.h"
#include "reading/scene/run_scene.h"
#include "report/outputs.h"

namespace rodpack {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

void report_orientation(const Packing& packing, const fs::path& out, Json& summary) {
  OrientationSample sample;
  sample.add(packing);
  auto distribution = sample.distribution();
  // Few particles in narrow bins would show their noise only.
  if (packing.size() < 1000)
    distribution = sample.distribution(static_cast<int>(distribution.centre.size() / 2));
  write_orientation(distribution, (out / "orientation").string());
  summary["orientation_particles"] = distribution.particles;
  summary["orientation_left_out_closer_than_AR_dp_to_walls"] = distribution.near_walls;
  summary["nematic_order_S2"] = distribution.nematic.order;
  summary["nematic_order_S2_standard_error"] = distribution.nematic.standard_error;
  summary["director_deg"] = distribution.nematic.director;
  summary["sixfold_order_S6"] = distribution.sixfold.order;
  summary["mean_cos_6_gamma"] = distribution.sixfold.mean_cosine;
  summary["mean_cos_6_gamma_standard_error"] = distribution.sixfold.standard_error;
}

void report_bond_order(const Frame& bodies, const Packing& packing, Json& summary) {
  BondOrderSample sample;
  sample.add(bodies, packing);
  const auto order = sample.result();
  summary["sixfold_bond_order_points"] = order.points;
  summary["sixfold_bond_order_local"] = order.local;
  summary["sixfold_bond_order_local_standard_error"] = order.local_error;
  summary["sixfold_bond_order_global"] = order.global;
}

RdfOptions rdf_options(double half_period, Json& summary) {
  const RdfOptions usual;
  const auto options = up_to(usual, half_period);
  if (options.largest_distance < usual.largest_distance)
    summary["notes"].push_back("RDF: up to " + number_text(options.largest_distance, 4) +
                               " d_p, half of the shortest period");
  return options;
}

void report_rdf(const Packing& packing, const fs::path& out, Json& summary) {
  const auto options = rdf_options(half_period(packing), summary);
  RdfSample sample(options);
  sample.add(packing);
  put_rdf(sample.result(), out, summary);
}

void put_rdf(const Rdf& rdf, const fs::path& out, Json& summary) {
  write_rdf(rdf, (out / "rdf").string());
  summary["rdf_centres"] = rdf.centres;
  summary["rdf_margin_over_dp"] = rdf.margin;
  if (rdf.tail_standard_error > 0) {
    summary["rdf_tail_mean"] = rdf.tail_g;
    summary["rdf_tail_standard_error"] = rdf.tail_standard_error;
  } else {
    summary["rdf_tail_mean"] = nullptr;
    summary["notes"].push_back("RDF: no pair of particles in the last quarter of r");
  }
  if (rdf.margin_reduced)
    summary["notes"].push_back(
        "RDF: the bed is too small for centres (10 + AR) d_p away from walls "
        "and surface; a margin of " +
        number_text(rdf.margin, 3) + " d_p was used");
}

void report_solid_fraction(const Packing& packing, const fs::path& out, Json& summary) {
  const auto field = solid_fraction(packing);
  const double d = packing.particle_diameter;
  summary["omega_m"] = field.scale;
  const auto mean = [&](const std::string& key, const std::optional<double>& value) {
    if (value)
      summary[key] = *value;
    else
      summary[key] = nullptr;
  };
  mean("solid_fraction_from_3_omega_above_floor_to_surface", field.up_to_surface);
  mean("solid_fraction_from_3_omega_above_floor_to_3_omega_below_surface",
       field.up_to_3_scales_below);
  mean("solid_fraction_normalised_by_kernel_share_from_3_omega_above_floor_to_surface",
       field.normalised_up_to_surface);
  mean("solid_fraction_normalised_by_kernel_share_from_floor_to_surface",
       field.normalised_from_floor_to_surface);
  summary["covered_area_over_area_below_surface"] = field.covered_below_surface;
  if (!field.up_to_3_scales_below)
    summary["notes"].push_back("solid fraction: the bed, " +
                               number_text((packing.surface - packing.walls.floor) / d, 3) +
                               " d_p high, is too low for the averaging heights (omega = " +
                               number_text(field.scale / d, 3) + " d_p)");
  if (!field.side_distance_kept)
    summary["notes"].push_back(
        "solid fraction: the side walls are closer than 3 omega to the central slice");
  if (!field.up_to_surface) return;  // nothing but the kernel's tails: no figure
  write_solid_fraction_table(field, d, (out / "solid_fraction.csv").string());
  plot_solid_fraction(field, d, packing.walls.floor, (out / "solid_fraction").string());
}

MeasuredContacts measure_contacts(const std::string& run, const Frame& bodies,
                                  const std::function<Frame(const Frame&)>& contacts_of,
                                  const std::string& parameters, std::optional<double> friction) {
  MeasuredContacts report;
  try {
    report.files = dumps_of_run(run, "contacts");
  } catch (const DataError& reason) {
    report.note = std::string(reason.what()) + "; dump contact/gran writes them";
    return report;
  }
  try {
    auto& frame = report.frame;
    frame = frame_at(report.files, bodies.timestep);
    if (contacts_of) frame = contacts_of(frame);
    if (!frame.has("body_i")) {
      report.note = why_no_contact_dump(frame);
      report.files.clear();
      frame = {};
      return report;
    }
    if (frame.rows > 0 && !frame.has("nx")) {
      report.note = frame.file + ":" + std::to_string(frame.header_line) +
                    ": no column 'nx', which dumps of earlier versions lack: forces are left out";
      return report;
    }
    ContactForceOptions options;
    options.friction = find_friction(frame, parameters, friction);
    force_lines(frame);  // bad columns show before anything is written
    ContactForceSample sample(options);
    sample.add(frame, &bodies);
    report.forces = sample.result();
    report.normals = sample.normals();
    report.normal_forces = sample.normal_forces();
  } catch (const NoSuchFrame& reason) {
    report.note = reason.what();
  } catch (const TooFewParticles& reason) {
    report.note = reason.what();
  }
  return report;
}

namespace {

// Where coefficients differ, what each pair of atom types makes of its own.
void put_friction_by_type(const MobilisedFriction& friction, Json& summary) {
  for (const auto& pair : friction.by_type)
    summary["friction_by_type"].push_back({{"types", {pair.lower_type, pair.upper_type}},
                                           {"friction", pair.coefficient},
                                           {"contacts", pair.contacts},
                                           {"mobilised_friction_mean", pair.mean},
                                           {"sliding_fraction", pair.sliding_fraction}});
  if (friction.frictionless > 0)
    summary["notes"].push_back("contacts: " + std::to_string(friction.frictionless) +
                               " of friction 0 do not count for the mobilised friction");
}

}  // namespace

void report_contacts(const MeasuredContacts& contacts, const fs::path& out, Json& summary) {
  if (!contacts.note.empty()) summary["notes"].push_back("contacts: " + contacts.note);
  if (!contacts.forces) return;
  const auto& forces = *contacts.forces;
  write_contact_forces(forces, (out / "forces").string());
  summary["mean_normal_force_N"] = forces.normal.mean;
  summary["mean_tangential_force_N"] = forces.tangential.mean;
  if (forces.friction) {
    summary["mobilised_friction_mean"] = forces.friction->mean;
    summary["sliding_fraction"] = forces.friction->sliding_fraction;
    put_friction_by_type(*forces.friction, summary);
  } else {
    summary["mobilised_friction_mean"] = nullptr;
    summary["sliding_fraction"] = nullptr;
    summary["notes"].push_back("contacts: " + forces.why_no_friction);
  }
  summary["coordination_number"] = forces.coordination.touching_particles;
  summary["contacts_per_particle"] = forces.coordination.contacts;
  summary["rattlers"] = *forces.coordination.rattlers;
}

void report_fields(const Packing& packing, const Frame& bodies, const Frame* contacts, double time,
                   const fs::path& out, Json& summary) {
  FieldSample sample({});
  sample.add(packing, bodies, contacts);
  const auto fields = sample.fields();
  write_fields(sample.averages(), fields, time, (out / "fields").string());
  const auto bed = mapped_bed(sample, packing);
  plot_solid_fraction_map(sample.averages(), fields, bed, (out / "solid_fraction_map").string());
  if (!contacts) return;
  plot_pressure_map(sample.averages(), fields, bed, (out / "pressure_map").string());

  ProfileSample slice({});
  slice.add(packing, bodies, *contacts);
  const auto profile = slice.result();
  std::optional<JanssenFit> fit;
  try {
    fit = fit_janssen(profile);
  } catch (const TooFewParticles& reason) {
    summary["notes"].push_back(reason.what());
  }
  write_profile(profile, fit ? &*fit : nullptr, (out / "profile").string());
  put_janssen_fit(fit, packing.particle_diameter, "N_m", summary);
}

void put_janssen_fit(const std::optional<JanssenFit>& fit, double particle_diameter,
                     const std::string& pressure_unit, Json& summary) {
  const bool saturates = fit && fit->saturates;
  if (fit && !saturates)
    summary["notes"].push_back(
        "Janssen fit: " + describe(*fit, particle_diameter, pressure_unit == "N_m" ? "N/m" : "Pa"));
  const auto set = [&](const std::string& key, double JanssenFit::*value, double unit) {
    if (saturates)
      summary[key] = (*fit).*value / unit;
    else
      summary[key] = nullptr;
  };
  set("janssen_pressure_" + pressure_unit, &JanssenFit::pressure, 1);
  set("janssen_pressure_standard_error_" + pressure_unit, &JanssenFit::pressure_error, 1);
  set("janssen_depth_over_dp", &JanssenFit::depth, particle_diameter);
  set("janssen_depth_standard_error_over_dp", &JanssenFit::depth_error, particle_diameter);
  set("janssen_rms_residual_" + pressure_unit, &JanssenFit::rms_residual, 1);
}

void report_energies(const fs::path& run, const fs::path& out, Json& summary) {
  const auto file = (run / "energies.csv").string();
  if (!fs::exists(file)) {
    summary["notes"].push_back("energies: no energies.csv in the run folder");
    return;
  }
  const EnergyHistory energies = read_energies(file);
  summary["kinetic_energy_J"] = energies.kinetic.back();
  summary["elastic_energy_J"] = energies.elastic.back();
  plot_energies(energies, file, (out / "energies").string());
}

}  // namespace rodpack
