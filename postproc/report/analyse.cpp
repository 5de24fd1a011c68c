// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/analyse.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <vector>

#include "analysis/contact_forces.h"
#include "analysis/fields.h"
#include "figures/figure.h"
#include "analysis/force_chains.h"
#include "analysis/orientation.h"
#include "analysis/pressure_profile.h"
#include "analysis/rdf.h"
#include "figures/render.h"
#include "analysis/solid_fraction.h"
#include "reading/text.h"
#include "figures/vtk_export.h"

namespace rodpack {
namespace {
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Step at which the run ended, as its result.json says; none while it has not ended.
std::optional<long> last_step(const fs::path& run) {
  std::ifstream file(run / "result.json");
  if (!file) return {};
  const auto result = Json::parse(file, nullptr, false);
  if (!result.is_object() || !result.contains("step") || !result["step"].is_number())
    throw DataError((run / "result.json").string() +
                    ": expected a JSON object with a number 'step'");
  return result["step"].get<long>();
}

/// Dumps of one kind in order of time. A run that was resumed may end earlier than the one that was
/// interrupted had come: dumps after its end are of a course that it did not take.
std::vector<std::string> dumps_of(const fs::path& run, const std::string& kind) {
  auto files = find_dumps({(run / "dumps" / (kind + ".*.dump*")).string()});
  if (const auto last = last_step(run)) {
    const auto later = [&](const std::string& file) {
      const auto name = fs::path(file).filename().string();
      return std::strtol(name.c_str() + kind.size() + 1, nullptr, 10) > *last;
    };
    files.erase(std::remove_if(files.begin(), files.end(), later), files.end());
    if (files.empty())
      throw DataError((run / "dumps").string() + ": no dump of " + kind + " up to step " +
                      std::to_string(*last) + ", where result.json says the run ended");
  }
  return files;
}

void analyse_orientation(const Packing& packing, const fs::path& out, Json& summary) {
  OrientationSample sample;
  sample.add(packing);
  // Few particles in narrow bins would show their noise only.
  const auto distribution = sample.distribution(packing.size() < 1000 ? 18 : 36);
  write_orientation_table(distribution, (out / "orientation.csv").string());
  plot_orientation_linear(distribution, (out / "orientation").string());
  plot_orientation_polar(distribution, (out / "orientation_polar").string());
  summary["orientation_particles"] = distribution.particles;
  summary["orientation_left_out_closer_than_AR_dp_to_walls"] = distribution.near_walls;
  summary["nematic_order_S2"] = distribution.nematic.order;
  summary["nematic_order_S2_standard_error"] = distribution.nematic.standard_error;
  summary["director_deg"] = distribution.nematic.director;
}

void analyse_rdf(const Packing& packing, const fs::path& out, Json& summary) {
  RdfSample sample({});
  sample.add(packing);
  const auto rdf = sample.result();
  write_rdf_table(rdf, (out / "rdf.csv").string());
  plot_rdf(rdf, (out / "rdf").string());
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

void analyse_solid_fraction(const Packing& packing, const fs::path& out, Json& summary) {
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

// The contacts of the bodies' timestep and what they say, or why they say nothing.
struct Contacts {
  std::vector<std::string> files;
  Frame frame;
  std::optional<ContactForces> forces;
  std::string note;

  Contacts(const fs::path& run, const Frame& bodies, const std::string& parameters) {
    try {
      files = dumps_of(run, "contacts");
    } catch (const DataError& reason) {
      note = reason.what();
      return;
    }
    try {
      frame = frame_at(files, bodies.timestep);
      if (frame.rows > 0 && !frame.has("nx")) {
        note = frame.file + ":" + std::to_string(frame.header_line) +
               ": no column 'nx', which dumps of earlier versions lack: forces are left out";
        return;
      }
      ContactForceOptions options;
      options.friction = find_friction(frame.file, parameters, {});
      force_lines(frame);  // bad columns show before anything is written
      forces = measure_contact_forces(frame, &bodies, options);
    } catch (const NoSuchFrame& reason) {
      note = reason.what();
    } catch (const TooFewParticles& reason) {
      note = reason.what();
    }
  }
};

void analyse_contacts(const Contacts& contacts, const PackingOptions& options, const fs::path& out,
                      Json& summary) {
  if (!contacts.note.empty()) summary["notes"].push_back("contacts: " + contacts.note);
  if (!contacts.forces) return;
  const auto& forces = *contacts.forces;
  const auto stem = (out / "forces").string();
  write_contact_force_tables(forces, stem);
  plot_contact_forces(forces, stem);
  draw_force_chains(contacts.frame, options, stem + "_chains");
  summary["mean_normal_force_N"] = forces.normal.mean;
  summary["mean_tangential_force_N"] = forces.tangential.mean;
  if (forces.friction) {
    summary["mobilised_friction_mean"] = forces.friction->mean;
    summary["sliding_fraction"] = forces.friction->sliding_fraction;
  } else {
    summary["mobilised_friction_mean"] = nullptr;
    summary["sliding_fraction"] = nullptr;
    summary["notes"].push_back(
        "contacts: no positive friction in parameters.json, so that the "
        "mobilised friction is left out");
  }
  summary["coordination_number"] = forces.coordination.touching_particles;
  summary["contacts_per_particle"] = forces.coordination.contacts;
  summary["rattlers"] = *forces.coordination.rattlers;
}

// Maps of the fields and the profile of the pressure; without contacts the densities alone.
void analyse_fields(const Packing& packing, const Frame& bodies, const Frame* contacts, double time,
                    const fs::path& out, Json& summary) {
  FieldSample sample({});
  sample.add(packing, bodies, contacts);
  const auto fields = sample.fields();
  write_fields(sample.averages(), fields, time, (out / "fields").string());
  plot_solid_fraction_map(sample.averages(), fields, packing,
                          (out / "solid_fraction_map").string());
  if (!contacts) return;
  plot_pressure_map(sample.averages(), fields, packing, (out / "pressure_map").string());

  ProfileSample slice({});
  slice.add(packing, bodies, *contacts);
  const auto profile = slice.result();
  write_profile_table(profile, (out / "profile").string() + ".csv");
  std::optional<JanssenFit> fit;
  try {
    fit = fit_janssen(profile);
    if (!fit->saturates)
      summary["notes"].push_back("Janssen fit: " + describe(*fit, packing.particle_diameter));
  } catch (const TooFewParticles& reason) {
    summary["notes"].push_back(reason.what());
  }
  plot_profile(profile, fit ? &*fit : nullptr, (out / "profile").string());
  const bool saturates = fit && fit->saturates;
  const auto set = [&](const char* key, double JanssenFit::*value, double unit) {
    if (saturates)
      summary[key] = (*fit).*value / unit;
    else
      summary[key] = nullptr;
  };
  const double d = packing.particle_diameter;
  set("janssen_pressure_N_m", &JanssenFit::pressure, 1);
  set("janssen_pressure_standard_error_N_m", &JanssenFit::pressure_error, 1);
  set("janssen_depth_over_dp", &JanssenFit::depth, d);
  set("janssen_depth_standard_error_over_dp", &JanssenFit::depth_error, d);
  set("janssen_rms_residual_N_m", &JanssenFit::rms_residual, 1);
}

// Rows of energies.csv, without those that a run resumed from a restart has computed anew.
struct Energies {
  std::vector<double> time, kinetic, elastic;  // s, J, J

  explicit Energies(const std::string& file) {
    const CsvTable table(file);
    const auto& times = table.column("time_s");
    const auto& translational = table.column("kinetic_translational_J");
    const auto& rotational = table.column("kinetic_rotational_J");
    const auto& normal = table.column("elastic_normal_J");
    const auto& tangential = table.column("elastic_tangential_J");
    for (std::size_t i = 0; i < times.size(); ++i) {
      while (!time.empty() && time.back() >= times[i]) {
        time.pop_back();
        kinetic.pop_back();
        elastic.pop_back();
      }
      time.push_back(times[i]);
      kinetic.push_back(translational[i] + rotational[i]);
      elastic.push_back(normal[i] + tangential[i]);
    }
    if (time.empty()) throw DataError(file + ": no rows below the header");
  }
};

void analyse_energies(const fs::path& run, const fs::path& out, Json& summary) {
  const auto file = (run / "energies.csv").string();
  if (!fs::exists(file)) {
    summary["notes"].push_back("energies: no energies.csv in the run folder");
    return;
  }
  const Energies energies(file);
  summary["kinetic_energy_J"] = energies.kinetic.back();
  summary["elastic_energy_J"] = energies.elastic.back();
  plot_energies(file, (out / "energies").string());
}

}  // namespace

void plot_energies(const std::string& energies_csv, const std::string& stem) {
  const Energies energies(energies_csv);
  bool drawable = false;  // a logarithmic axis shows positive values only
  for (std::size_t i = 0; i < energies.time.size(); ++i)
    drawable = drawable || energies.kinetic[i] > 0 || energies.elastic[i] > 0;
  if (!drawable) throw DataError(energies_csv + ": no positive energy to draw");
  draw_figure(stem, 1.4,
              datablock("energies", {energies.time, energies.kinetic, energies.elastic}) +
                  "set xlabel 'time (s)'\nset ylabel 'energy (J)'\n"
                  "set logscale y\nset format y '10^{%T}'\nset mytics 10\n"
                  "set key outside top center horizontal\nset autoscale xfix\n"
                  "positive(e) = e > 0 ? e : NaN\n"
                  "plot $energies using 1:(positive($2)) with lines linewidth 1.4 linecolor '" +
                  colour::vermilion + "' title 'kinetic {/:Italic E}_k', " +
                  "$energies using 1:(positive($3)) with lines linewidth 1.4 linecolor '" +
                  colour::blue + "' title 'elastic {/:Italic E}_p'\n");
}

namespace {

// Removes what an earlier analysis wrote, so that nothing of it stays beside the new results.
void remove_own_outputs(const fs::path& out) {
  std::error_code ignored;
  fs::remove(out / "summary.json", ignored);
  fs::remove(out / "fields.vti", ignored);
  for (const std::string table : {"orientation", "rdf", "solid_fraction", "forces",
                                  "forces_friction", "forces_coordination", "fields", "profile"})
    fs::remove(out / (table + ".csv"), ignored);
  for (const std::string figure :
       {"orientation", "orientation_polar", "rdf", "solid_fraction", "energies", "packing",
        "forces", "forces_friction", "forces_coordination", "forces_chains", "solid_fraction_map",
        "pressure_map", "profile"})
    for (const std::string suffix : {".png", ".svg"}) fs::remove(out / (figure + suffix), ignored);
  for (const std::string kind : {"bodies", "spheres", "contacts"})
    for (const auto& entry : fs::directory_iterator(out / "vtk", ignored)) {
      const auto name = entry.path().filename().string();
      const auto suffix = entry.path().extension();
      if (name.rfind(kind + ".", 0) == 0 && (suffix == ".vtp" || suffix == ".pvd"))
        fs::remove(entry.path(), ignored);
    }
}

}  // namespace

Json analyse_run(const std::string& run_folder, bool all_frames) {
  const fs::path run(run_folder);
  if (!fs::is_directory(run)) throw DataError(run_folder + ": no such run folder");
  const auto parameters = read_parameters((run / "parameters.json").string());
  const auto body_files = dumps_of(run, "bodies");
  const auto sphere_files = dumps_of(run, "spheres");

  PackingOptions options;
  options.parameters = parameters.file;
  const auto bodies = last_frame(body_files);
  const auto packing = read_packing(bodies, options);
  const auto spheres = last_frame(sphere_files);
  // Bad columns and tables show before anything is written.
  for (const std::string name : {"x", "y", "radius", "fx", "fy", "fz"}) spheres.column(name);
  if (const auto table = run / "energies.csv"; fs::exists(table)) Energies{table.string()};
  const Contacts contacts(run, bodies, parameters.file);

  const fs::path out = run / "analysis";
  std::error_code error;
  fs::create_directories(out, error);
  if (error) throw DataError(out.string() + ": cannot be created (" + error.message() + ")");

  remove_own_outputs(out);

  const double dt = parameters.values.contains("timestep_s") ? parameters.number("timestep_s") : 0;
  Json summary;
  summary["format"] = "rodpack-analysis 1";
  summary["timestep"] = packing.timestep;
  if (dt > 0) summary["time_s"] = static_cast<double>(packing.timestep) * dt;
  summary["particles"] = packing.size();
  summary["bed_height_m"] = packing.surface - packing.walls.floor;
  summary["notes"] = Json::array();
  using Analysis = void (*)(const Packing&, const fs::path&, Json&);
  for (const Analysis analysis : {analyse_orientation, analyse_rdf, analyse_solid_fraction}) try {
      analysis(packing, out, summary);
    } catch (const TooFewParticles& reason) {
      summary["notes"].push_back(reason.what());
    }
  options.particle_diameter = packing.particle_diameter;
  analyse_contacts(contacts, options, out, summary);
  const bool stressed = contacts.frame.rows > 0 && contacts.frame.timestep == bodies.timestep;
  analyse_fields(packing, bodies, stressed ? &contacts.frame : nullptr,
                 static_cast<double>(packing.timestep) * (dt > 0 ? dt : 1), out, summary);
  analyse_energies(run, out, summary);

  RenderOptions render;
  render.packing = options;
  render_spheres(spheres, render, (out / "packing").string());

  auto exported = all_frames ? body_files : std::vector<std::string>{body_files.back()};
  const auto add = [&](const std::vector<std::string>& files) {
    exported.insert(exported.end(), all_frames ? files.begin() : files.end() - 1, files.end());
  };
  add(sphere_files);
  if (!contacts.files.empty()) add(contacts.files);
  export_vtk(exported, (out / "vtk").string(), dt);

  summary["parameters"] = parameters.values;
  write_text((out / "summary.json").string(), summary.dump(2) + "\n");
  return summary;
}

}  // namespace rodpack
