// SPDX-License-Identifier: GPL-2.0-or-later
#include "page/run_page.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "page/figures_section.h"
#include "page/frame.h"
#include "page/html.h"
#include "page/tables.h"
#include "page/words.h"
#include "reading/data_error.h"
#include "reading/text_file.h"
#include "reading/json_file.h"
#include "report/scene.h"

namespace rodpack {
namespace {
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// Scenes in a plane and in space have these two figures alike.
const FigureText distribution_of_forces{"forces",
                                        "Distributions of the normal and tangential contact forces",
                                        "Each is divided by its mean.", false};
const FigureText mobilised_friction{
    "forces_friction",
    "Mobilised friction <i>f</i><sub>t</sub> / (μ <i>f</i><sub>n</sub>) of the contacts", "",
    false};
const FigureText coordination{"forces_coordination",
                              "How many particles, and in how many contacts, a particle touches",
                              "", false};

const FigureText partial_rdf_figure{
    "rdf_partial", "Partial radial distribution functions of the mixture",
    "1: as in an ideal gas; weighted by the pairs of an ideal gas they add up to the grey curve.",
    false};

const std::vector<FigureText>& run_figures() {
  static const std::string hatched =
      "Hatched: nearer than 3ω to a wall or the surface (line), where the kernel averages over the "
      "empty space beyond.";
  static const std::vector<FigureText> texts{
      {"packing", "The packing",
       "Each sphere is shaded by the magnitude of the net contact force on it; each particle has "
       "one "
       "outline.",
       true},
      {"forces_chains", "Force chains",
       "A line for each touching pair, between the centres of mass, for the sum of its contacts; "
       "at "
       "a wall it ends in the mean contact point.",
       true},
      {"solid_fraction_map", "Solid fraction, coarse-grained with ω", hatched, false},
      {"pressure_map", "Pressure and its principal directions, coarse-grained with ω", hatched,
       false},
      {"solid_fraction", "Solid fraction over height in the central slice",
       "Grey: as hatched above. The dashed line is the area that the particles cover below the "
       "surface over that of the bed, walls included.",
       false},
      {"profile", "Pressure <i>P</i><sub>0</sub> over depth below the surface in the central slice",
       "Grey: as hatched above.", false},
      {"orientation", "Distribution of the angle γ between long axis and horizontal",
       "Particles closer than AR <i>d</i><sub>p</sub> to a wall are left out.", false},
      {"orientation_polar", "The same as a rose", "", false},
      {"rdf", "Radial distribution function of the centres of mass", "", false},
      partial_rdf_figure,
      distribution_of_forces,
      mobilised_friction,
      coordination,
      {"energies", "Energies over time while the bed is filled and comes to rest", "", false}};
  return texts;
}

const std::vector<FigureText>& space_figures() {
  static const std::string isotropic =
      "1: as of isotropic directions. Particles closer than AR <i>d</i><sub>p</sub> to a wall are "
      "left out.";
  static const std::string grey =
      "Of the container's whole cross-section, smoothed along the vertical by a Gaussian of ω = AR "
      "<i>d</i><sub>p</sub> / 2. Grey: nearer than 3ω to the floor or the surface.";
  static const std::string hatched =
      "ω = AR <i>d</i><sub>p</sub> / 2. Hatched: nearer than 3ω to a wall or the surface (line), "
      "where the kernel averages over the empty space beyond.";
  static const std::string upright = "on an upright slice through the middle of the container";
  static const std::string level = "on a level slice at half the height of the bed";
  static const std::string rings = "mean over rings about the axis of the container";
  static const std::string crosses =
      " Crosses: principal values and directions of the stress within the section.";
  static const std::vector<FigureText> texts{
      {"packing", "The packing",
       "In perspective. Each particle is shaded by the sum of the magnitudes of all contact forces "
       "on it.",
       true},
      {"solid_fraction_map", "Solid fraction " + upright, hatched, false},
      {"solid_fraction_map_across", "Solid fraction " + level, hatched, false},
      {"solid_fraction_map_rings", "Solid fraction, " + rings, hatched, false},
      {"pressure_map", "Pressure, a third of the trace of the contact stress, " + upright,
       hatched + crosses, false},
      {"pressure_map_across", "Pressure " + level, hatched + crosses, false},
      {"pressure_map_rings", "Pressure, " + rings, hatched + crosses, false},
      {"orientation", "Angle of the long axis to the vertical", isotropic, false},
      {"orientation_azimuth", "Azimuth of the long axis about the vertical", isotropic, false},
      {"rdf", "Radial distribution function of the centres of mass, in shells", "", false},
      partial_rdf_figure,
      {"rdf_axial", "Pair correlation along and across the axis of the centre particle",
       "1: as in an ideal gas of the same density.", false},
      {"solid_fraction", "Solid fraction over height", grey, false},
      {"profile", "Stresses over depth below the surface", grey, false},
      distribution_of_forces,
      mobilised_friction,
      coordination,
      {"forces_fabric", "Angle of the contact normals to the vertical, and their normal force", "",
       false},
      {"energies", "Energies over time", "", false}};
  return texts;
}

bool is_in_space(const Json& summary) { return summary.contains("vertical_axis"); }

// The picture that can be zoomed is one of a plane.
std::string packing_html(const std::string& name, const std::string& run_folder,
                         const Json& summary) {
  if (!is_in_space(summary)) return viewer_html({{name, run_folder}});
  return "<p>The picture is among the figures: the scene is in space, and the viewer shows planes. "
         "<code>analysis/vtk/</code> holds the packing for ParaView.</p>\n";
}

// parameters.json of the run, else what the analysis took in its place.
Json parameters_of_run(const fs::path& run, const Json& summary) {
  const auto file = run / "parameters.json";
  if (fs::exists(file)) return read_json_object(file.string());
  return summary.value("parameters", Json::object());
}

// The numbers of the summary, without what the page says elsewhere.
Json results_of(const Json& summary) {
  Json results;
  for (const auto& [key, value] : summary.items())
    if (key != "format" && key != "timestep" && key != "scene" && !value.is_structured())
      results[key] = value;
  return results;
}

// Of a mixture, what is known by kind of particles.
std::string mixture_html(const fs::path& analysis) {
  const auto file = analysis / "mixture.csv";
  return fs::exists(file) ? csv_table(file.string(), "By kind of particles") : std::string();
}

Json parameters_of(Json parameters) {
  parameters.erase("format");
  parameters.erase("rodpack");  // the page's first lines tell
  return parameters;
}

std::string made_by(const Json& values) {
  const auto found = values.find("rodpack");
  if (found == values.end() || !found->is_object()) return "an unknown version of rodpack";
  return "rodpack " + escaped(found->value("version", "?")) + " (commit " +
         escaped(found->value("commit", "?")) + ")";
}

std::string lead_of(const fs::path& run, const Json& summary, const Json& parameters) {
  const auto scene = is_in_space(summary)  // the paper's scenes are in a plane
                         ? std::string()
                         : scene_unlike_the_papers(nlohmann::json(parameters));
  std::string text = number_html(summary.value("particles", 0.0), 12) + " " +
                     escaped(particles_in_words(parameters));
  if (parameters.contains("seed")) text += ", seed " + escaped(parameters["seed"].dump());
  text += ", at timestep " + number_html(summary.value("timestep", 0.0), 12);
  if (summary.contains("time_s"))
    text += " (" + number_html(summary["time_s"].get<double>(), 4) + " s)";
  return text + ". Run folder <code>" + escaped(run.filename().string()) + "</code>" +
         (parameters.empty() ? "" : ", simulated by " + made_by(parameters)) + ", analysed by " +
         made_by(summary) + "." + (scene.empty() ? "" : " <b>" + escaped(scene) + "</b>");
}

}  // namespace

std::string write_run_page(const std::string& run_folder) {
  const fs::path run = fs::path(run_folder).lexically_normal() / "";
  const fs::path name = run.parent_path(), analysis = run / "analysis";
  const auto summary_file = analysis / "summary.json";
  if (!fs::exists(summary_file))
    throw DataError(summary_file.string() + ": no such file; \"rodpack analyse " + run_folder +
                    "\" makes it");
  const Json summary = read_json_object(summary_file.string());
  const Json parameters = parameters_of_run(run, summary);

  std::vector<Note> notes;
  for (const auto& note : summary.value("notes", Json::array()))
    notes.push_back({"", note.is_string() ? note.get<std::string>() : note.dump()});
  int figure = 0;
  const std::string figures =
      figures_html(analysis, is_in_space(summary) ? space_figures() : run_figures(), figure);

  Page page;
  page.title = "Packing of " + particles_in_words(parameters);
  page.lead = lead_of(name, summary, parameters);
  page.sections = {
      {"results", "Results", values_table(results_of(summary), "") + mixture_html(analysis)},
      {"packing", "The packing", packing_html(name.filename().string(), run_folder, summary)},
      {"figures", "Figures",
       figures.empty() ? "<p>None: \"rodpack analyse\" draws them.</p>\n" : figures},
      {"notes", "What was left out, and why",
       notes.empty() ? "<p>Nothing: all measures were possible.</p>\n" : notes_html(notes)},
      {"parameters", "Parameters of the run",
       parameters.empty() ? "<p>Unknown: the folder has no <code>parameters.json</code>.</p>\n"
                          : values_table(parameters_of(parameters), "")}};
  auto file = (analysis / "report.html").string();
  write_text(file, page_html(page));
  return file;
}

}  // namespace rodpack
