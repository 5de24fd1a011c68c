// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/analyse_run.h"

#include <filesystem>
#include <functional>
#include <vector>

#include "analysis/energies.h"
#include "analysis/orientation.h"
#include "analysis/stock/stock_dumps.h"
#include "figures/force_chains_figure.h"
#include "figures/render.h"
#include "figures/space/packing_picture.h"
#include "figures/space/ray_tracing.h"
#include "figures/vtk_export.h"
#include "reading/checks/contacts_of_bodies.h"
#include "reading/checks/planar.h"
#include "reading/data_error.h"
#include "reading/json_file.h"
#include "reading/packing.h"
#include "reading/parameters.h"
#include "reading/run_folder.h"
#include "reading/scene/run_scene.h"
#include "report/measures.h"
#include "report/mixture_measures.h"
#include "report/run_files.h"
#include "report/scene.h"
#include "report/spatial_measures.h"

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
  for (const std::string table :
       {"orientation", "rdf", "solid_fraction", "forces", "forces_friction", "forces_coordination",
        "fields", "fields_rings", "profile", "orientation_azimuth", "orientation_order",
        "rdf_axial", "forces_friction_types", "forces_fabric", "forces_fabric_order", "mixture",
        "rdf_partial"})
    fs::remove(out / (table + ".csv"), ignored);
  for (const std::string figure : {"orientation",
                                   "orientation_polar",
                                   "rdf",
                                   "solid_fraction",
                                   "energies",
                                   "packing",
                                   "forces",
                                   "forces_friction",
                                   "forces_coordination",
                                   "forces_chains",
                                   "solid_fraction_map",
                                   "pressure_map",
                                   "profile",
                                   "orientation_azimuth",
                                   "rdf_axial",
                                   "forces_fabric",
                                   "rdf_partial",
                                   "solid_fraction_map_across",
                                   "solid_fraction_map_rings",
                                   "pressure_map_across",
                                   "pressure_map_rings"})
    for (const std::string suffix : {".png", ".svg"}) fs::remove(out / (figure + suffix), ignored);
  for (const std::string kind : {"bodies", "capsules", "spheres", "contacts"})
    for (const auto& entry : fs::directory_iterator(out / "vtk", ignored)) {
      const auto name = entry.path().filename().string();
      const auto suffix = entry.path().extension();
      if (name.rfind(kind + ".", 0) == 0 && (suffix == ".vtp" || suffix == ".pvd"))
        fs::remove(entry.path(), ignored);
    }
}

// What the bodies alone tell; what the bed is too small for is noted. Returns how many were made.
int measure_bodies(const Frame& bodies, const Packing& packing, const fs::path& out,
                   Json& summary) {
  using Report = std::function<void(const Packing&, const fs::path&, Json&)>;
  const Report report_bonds = [&](const Packing& all, const fs::path&, Json& numbers) {
    try {
      report_bond_order(bodies, all, numbers);
    } catch (const DataError& reason) {  // particles that are no chains have none
      numbers["notes"].push_back(reason.what());
    }
  };
  int made = 0;
  for (const Report& report : {Report(report_orientation), report_bonds, Report(report_rdf),
                               Report(report_solid_fraction)})
    try {
      report(packing, out, summary);
      ++made;
    } catch (const TooFewParticles& reason) {
      summary["notes"].push_back(reason.what());
    } catch (const MixedParticles& reason) {
      summary["notes"].push_back(std::string("orientation: ") + reason.what());
    }
  return made;
}

// One analysis: what there is, what the user says of it, and where the results go.
class Analysis {
 public:
  Analysis(const std::string& run_folder, AnalyseOptions options)
      : run_(run_folder),
        out_(run_ / "analysis"),
        options_(std::move(options)),
        files_(find_run_files(run_folder, options_.packing.parameters)) {
    if (files_.parameters) options_.packing.parameters = files_.parameters->file;
    has_scene_ = find_scene(files_.bodies).has_value();
    dt_ = find_timestep(files_.bodies, options_.packing.parameters).value_or(0);
  }

  Json run() {
    if (is_in_space(files_.bodies, options_.packing, options_.space))
      in_space();
    else
      in_plane();
    report_energies(run_, out_, summary_);
    draw_packing();
    export_frames();
    if (files_.parameters) summary_["parameters"] = files_.parameters->values;
    write_json((out_ / "summary.json").string(), summary_);
    return summary_;
  }

 private:
  // Bad columns and tables show before anything is written.
  void read_the_rest() {
    if (files_.spheres && files_.own_parameters)
      for (const std::string name : {"x", "y", "radius", "fx", "fy", "fz"})
        files_.spheres->column(name);
    if (const auto table = run_ / "energies.csv"; fs::exists(table)) read_energies(table.string());
    std::function<Frame(const Frame&)> stock;
    if (!options_.local.words.empty())
      stock = [&](const Frame& pairs) { return contacts_of_stock(pairs); };
    contacts_ = measure_contacts(run_.string(), files_.bodies, stock, options_.packing.parameters,
                                 options_.friction);
    if (files_.own_parameters || contacts_.frame.rows == 0) return;
    require_contacts_of_bodies(contacts_.frame, files_.bodies);
    const auto why = packing_ ? why_contacts_not_planar(contacts_.frame) : "";
    if (why.empty()) return;
    contacts_.forces.reset();
    contacts_.frame = {};
    contacts_.note = why + "; rodpack forces measures what holds in space too";
  }

  void start(long timestep, std::size_t particles) {
    make_folder(out_);
    remove_own_outputs(out_);
    summary_["format"] = analysis_format;
    summary_["timestep"] = timestep;
    if (dt_ > 0) summary_["time_s"] = static_cast<double>(timestep) * dt_;
    summary_["particles"] = particles;
  }

  // What a folder without parameters.json, or with a scene, says in its place.
  void put_setting(const std::string& walls, double particle_diameter, double aspect_ratio) {
    summary_["walls_from"] = walls;
    summary_["particle_diameter_m"] = particle_diameter;
    summary_["aspect_ratio"] = aspect_ratio;
  }

  // Walls that nobody stated are the dump's box, which may be larger than the container.
  void start_notes(const std::string& walls, const std::vector<std::string>& notes,
                   const std::string& options) {
    summary_["notes"] = files_.notes;
    if (!options_.local.words.empty() && contacts_.frame.rows > 0)
      summary_["notes"].push_back("contacts: " + note_on_local_contacts(options_.local));
    for (const auto& note : notes) summary_["notes"].push_back(note);
    if (walls.find("box bounds") != std::string::npos)
      summary_["notes"].push_back("walls: " + walls + "; " + options +
                                  " where the container is another");
    first_measure_note_ = summary_["notes"].size();
  }

  void require_any(int made) {
    if (made > 0) return;
    remove_own_outputs(out_);
    std::error_code not_empty;
    fs::remove(out_, not_empty);
    throw DataError(run_.string() + ": nothing could be measured: " +
                    summary_["notes"][first_measure_note_].get<std::string>());
  }

  void in_plane() {
    refuse_of_space();
    packing_ = read_packing(files_.bodies, options_.packing);
    const auto& packing = *packing_;
    read_the_rest();
    start(packing.timestep, packing.size());
    if (packing.walls.bottom) summary_["bed_height_m"] = packing.surface - packing.walls.floor;
    if (!files_.own_parameters || has_scene_)
      put_setting(packing.walls.source, packing.particle_diameter, packing.aspect_ratio);
    if (files_.parameters) {
      const auto scene = scene_unlike_the_papers(files_.parameters->values);
      if (!scene.empty()) summary_["scene"] = scene;
    }
    start_notes(packing.walls.source, packing.walls.notes, "--walls");
    if (packing.inclination != 0) summary_["notes"].push_back(note_on_slope(packing));
    first_measure_note_ = summary_["notes"].size();
    int made = measure_bodies(files_.bodies, packing, out_, summary_);
    options_.packing.particle_diameter = packing.particle_diameter;
    report_contacts(contacts_, out_, summary_);
    if (contacts_.forces) {
      ++made;
      draw_force_chains(contacts_.frame, options_.packing, (out_ / "forces_chains").string());
    }
    report_mixture(packing, files_.bodies, contacts_, out_, summary_);
    const bool stressed =
        contacts_.frame.rows > 0 && contacts_.frame.timestep == files_.bodies.timestep;
    try {
      if (const auto why = why_no_motion(files_.bodies); !why.empty()) throw TooFewParticles(why);
      report_fields(packing, files_.bodies, stressed ? &contacts_.frame : nullptr,
                    time_of(packing.timestep), out_, summary_);
      ++made;
    } catch (const TooFewParticles& reason) {
      summary_["notes"].push_back(std::string("fields: ") + reason.what());
    }
    require_any(made);
  }

  void in_space() {
    if (!options_.packing.walls.empty())
      throw DataError("--walls: expected in a scene in a plane alone");
    const auto packing = read_spatial_packing(files_.bodies, options_.packing, options_.space);
    read_the_rest();
    start(packing.timestep, packing.size());
    const auto& walls = packing.walls;
    summary_["vertical_axis"] = std::string(1, "xyz"[walls.vertical]);
    if (!walls.periodic[walls.vertical])
      summary_["bed_height_m"] = packing.surface - walls.low[walls.vertical];
    put_setting(walls.source, packing.particle_diameter, packing.aspect_ratio);
    start_notes(walls.source, walls.notes, "--container or --cylinder");
    options_.packing.particle_diameter = packing.particle_diameter;
    require_any(report_in_space(packing, files_.bodies, contacts_, time_of(packing.timestep), out_,
                                summary_));
    report_mixture(packing, files_.bodies, contacts_, out_, summary_);
  }

  // Of LIGGGHTS's own dumps, in which the bodies' are of spheres.
  Frame contacts_of_stock(const Frame& pairs) const {
    return read_local_contacts(pairs, options_.local, frame_beside(pairs, files_.body_files));
  }

  // s, or the timestep where its length is not known.
  double time_of(long timestep) const {
    return static_cast<double>(timestep) * (dt_ > 0 ? dt_ : 1);
  }

  void refuse_of_space() const {
    for (const auto& [option, values] : {std::pair{"--container", &options_.space.container},
                                         std::pair{"--cylinder", &options_.space.cylinder}})
      if (!values->empty())
        throw DataError(std::string(option) + ": expected in a scene in space alone");
  }

  void draw_packing() {
    if (!files_.spheres) return;
    RenderOptions render;
    render.packing = options_.packing;
    render.space = options_.space;
    if (!files_.spheres->has("fx")) render.colour = SphereColour::none;
    const auto stem = (out_ / "packing").string();
    if (packing_) return render_spheres(*files_.spheres, render, stem);
    if (files_.spheres->has("fsum")) render.colour = SphereColour::fsum;
    try {
      render_in_space(*files_.spheres, render, stem);
    } catch (const NoRayTracer& reason) {
      summary_["notes"].push_back(std::string("picture: ") + reason.what());
    }
  }

  void export_frames() const {
    std::vector<std::string> exported;
    for (const auto* files : {&files_.body_files, &files_.sphere_files, &contacts_.files})
      if (!files->empty())
        exported.insert(exported.end(), options_.all_frames ? files->begin() : files->end() - 1,
                        files->end());
    export_vtk(exported, (out_ / "vtk").string(), dt_, !packing_,
               [&](const Frame& pairs) { return contacts_of_stock(pairs); });
  }

  fs::path run_, out_;
  AnalyseOptions options_;
  RunFiles files_;
  double dt_ = 0;  // s; 0: unknown
  bool has_scene_ = false;
  std::optional<Packing> packing_;
  MeasuredContacts contacts_;
  Json summary_;
  std::size_t first_measure_note_ = 0;
};

}  // namespace

Json analyse_run(const std::string& run_folder, const AnalyseOptions& options) {
  return Analysis(run_folder, options).run();
}

}  // namespace rodpack
