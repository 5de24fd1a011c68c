// SPDX-License-Identifier: GPL-2.0-or-later
#include "study/study_figures.h"

#include <filesystem>

#include "reading/json_file.h"

namespace rodpack {

std::vector<StudyFigure> draw_study_figures(const Ensemble& ensemble, const std::string& study,
                                            const std::string& out, const std::string& published) {
  const auto values = read_published(find_published(published, study), ensemble);
  write_solid_fraction_table(ensemble, values, out + "/table2");
  std::vector<StudyFigure> figures;
  figures.push_back(draw_packings(ensemble, study, out));
  figures.push_back(draw_solid_fraction_maps(ensemble, out));
  figures.push_back(draw_slice(ensemble, out));
  figures.push_back(draw_solid_fraction_over_aspect_ratio(ensemble, values, out));
  figures.push_back(draw_orientation(ensemble, out));
  figures.push_back(draw_rdf(ensemble, out));
  figures.push_back(draw_pressure(ensemble, out));
  figures.push_back(draw_solid_fraction_over_theta(ensemble, out));
  figures.push_back(draw_packing_with_voids(ensemble, study, out));
  figures.push_back(draw_curved_slice(ensemble, out));
  figures.push_back(draw_curved_orientation(ensemble, out));
  figures.push_back(draw_curved_rdf(ensemble, out));
  figures.push_back(draw_curved_pressure(ensemble, out));
  figures.push_back(draw_pressure_over_theta(ensemble, out));
  // What an earlier run has left there would be taken for a figure of these cases.
  for (const auto& figure : figures)
    if (!figure.not_drawn.empty())
      for (const char* suffix : {".png", ".svg"})
        std::filesystem::remove(std::filesystem::path(out) / (figure.name + suffix));
  return figures;
}

void write_figure_list(const std::vector<StudyFigure>& figures, const std::string& folder) {
  nlohmann::ordered_json list;
  list["format"] = "rodpack-figures 1";
  list["figures"] = nlohmann::ordered_json::array();
  for (const auto& figure : figures) {
    nlohmann::ordered_json entry;
    entry["name"] = figure.name;
    entry["paper"] = figure.paper;
    entry["caption"] = figure.caption;
    entry["not_drawn"] = figure.not_drawn;
    list["figures"].push_back(entry);
  }
  write_json(folder + "/figures.json", list);
}

}  // namespace rodpack
