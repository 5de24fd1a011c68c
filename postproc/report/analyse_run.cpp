// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/analyse_run.h"

#include <filesystem>
#include <functional>
#include <vector>

#include "analysis/energies.h"
#include "figures/render.h"
#include "figures/vtk_export.h"
#include "reading/data_error.h"
#include "reading/json_file.h"
#include "reading/packing.h"
#include "reading/parameters.h"
#include "reading/run_folder.h"
#include "report/measures.h"
#include "report/scene.h"

namespace rodpack {
namespace {
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

void make_folder(const fs::path& out) {
  std::error_code error;
  fs::create_directories(out, error);
  if (error) throw DataError(out.string() + ": cannot be created (" + error.message() + ")");
}

// Removes what an earlier analysis wrote, so that nothing of it stays beside the new results.
void remove_own_outputs(const fs::path& out) {
  std::error_code ignored;
  fs::remove(out / "summary.json", ignored);
  fs::remove(out / "fields.vti", ignored);
  fs::remove(out / "report.html", ignored);  // the page of them all, which write_run_page() makes
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

// What the bodies alone tell; what the bed is too small for is noted.
void measure_bodies(const Frame& bodies, const Packing& packing, const fs::path& out,
                    Json& summary) {
  using Report = std::function<void(const Packing&, const fs::path&, Json&)>;
  const Report report_bonds = [&](const Packing& all, const fs::path&, Json& numbers) {
    try {
      report_bond_order(bodies, all, numbers);
    } catch (const DataError& reason) {  // particles that are no chains have none
      numbers["notes"].push_back(reason.what());
    }
  };
  for (const Report& report : {Report(report_orientation), report_bonds, Report(report_rdf),
                               Report(report_solid_fraction)})
    try {
      report(packing, out, summary);
    } catch (const TooFewParticles& reason) {
      summary["notes"].push_back(reason.what());
    }
}

}  // namespace

Json analyse_run(const std::string& run_folder, bool all_frames) {
  const fs::path run(run_folder);
  if (!fs::is_directory(run)) throw DataError(run_folder + ": no such run folder");
  const auto parameters = read_parameters((run / "parameters.json").string());
  const auto body_files = dumps_of_run(run_folder, "bodies");
  const auto sphere_files = dumps_of_run(run_folder, "spheres");

  PackingOptions options;
  options.parameters = parameters.file;
  const auto bodies = last_frame(body_files);
  const auto packing = read_packing(bodies, options);
  const auto spheres = last_frame(sphere_files);
  // Bad columns and tables show before anything is written.
  for (const std::string name : {"x", "y", "radius", "fx", "fy", "fz"}) spheres.column(name);
  if (const auto table = run / "energies.csv"; fs::exists(table)) read_energies(table.string());
  const ContactReport contacts = read_contact_report(run_folder, bodies, parameters.file);

  const fs::path out = run / "analysis";
  make_folder(out);
  remove_own_outputs(out);

  const double dt = parameters.values.contains("timestep_s") ? parameters.number("timestep_s") : 0;
  Json summary;
  summary["format"] = analysis_format;
  summary["timestep"] = packing.timestep;
  if (dt > 0) summary["time_s"] = static_cast<double>(packing.timestep) * dt;
  summary["particles"] = packing.size();
  summary["bed_height_m"] = packing.surface - packing.walls.floor;
  if (const auto scene = scene_unlike_the_papers(parameters.values); !scene.empty())
    summary["scene"] = scene;
  summary["notes"] = Json::array();
  measure_bodies(bodies, packing, out, summary);
  options.particle_diameter = packing.particle_diameter;
  report_contacts(contacts, options, out, summary);
  const bool stressed = contacts.frame.rows > 0 && contacts.frame.timestep == bodies.timestep;
  report_fields(packing, bodies, stressed ? &contacts.frame : nullptr,
                static_cast<double>(packing.timestep) * (dt > 0 ? dt : 1), out, summary);
  report_energies(run, out, summary);

  RenderOptions render;
  render.packing = options;
  render_spheres(spheres, render, (out / "packing").string());

  std::vector<std::string> exported;
  for (const auto* files : {&body_files, &sphere_files, &contacts.files})
    if (!files->empty())
      exported.insert(exported.end(), all_frames ? files->begin() : files->end() - 1, files->end());
  export_vtk(exported, (out / "vtk").string(), dt);

  summary["parameters"] = parameters.values;
  write_json((out / "summary.json").string(), summary);
  return summary;
}

}  // namespace rodpack
