// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "figures/packings/picture_sheet.h"
#include "figures/render.h"
#include "figures/packings/voids_figure.h"
#include "reading/number_text.h"
#include "reading/run_folder.h"
#include "study/study_case.h"
#include "study/study_figures.h"

namespace rodpack {
namespace {
namespace fs = std::filesystem;

constexpr double window_width = 44, window_height = 33;  // d_p

struct RunFrame {
  Frame spheres;
  Walls walls;
  double diameter = 0;      // d_p, m
  double surface = 0;       // of the bed, m
  double axial_length = 0;  // AR d_p, m
};

// The last frame of the first run of a case whose dumps are there.
std::optional<RunFrame> last_frame(const EnsembleCase& each, const std::string& study) {
  for (const auto& run : each.runs) {
    std::string folder = (fs::path(study) / run).string();
    if (!fs::exists(folder)) folder = run;
    if (!fs::exists(fs::path(folder) / "dumps")) continue;
    RunFrame result;
    const auto last = [&](const char* kind) {
      Frame frame;
      DumpReader reader(dumps_of_run(folder, kind).back());
      while (reader.next(frame)) {
      }
      return frame;
    };
    try {
      result.spheres = last("spheres");
      const Packing packing = read_packing(last("bodies"));
      result.walls = packing.walls;
      result.diameter = packing.particle_diameter;
      result.surface = packing.surface;
      result.axial_length = packing.axial_length();
    } catch (const DataError&) {
      continue;  // without dumps of both kinds there is nothing to draw
    }
    return result;
  }
  return std::nullopt;
}

// In the middle between the side walls, from a third of the bed's height on.
std::array<double, 4> central_window(const RunFrame& frame) {
  const double d = frame.diameter;
  const double width = std::min(window_width * d, frame.walls.width());
  const double height = window_height * d * width / (window_width * d);
  const double middle = 0.5 * (frame.walls.left + frame.walls.right);
  const double bed = frame.surface - frame.walls.floor;
  const double low = frame.walls.floor + std::max(0.0, std::min(bed / 3, bed - height));
  return {middle - width / 2, middle + width / 2, low, low + height};
}

std::string title_of(const StudyCase& each) {
  std::string text = each.surface == Surface::coarse ? "coarse" : "smooth";
  if (each.surface == Surface::sphere) return "spheres";
  text += ", AR = " + number_text(each.aspect_ratio, 4);
  return each.theta > 0 ? text + ", θ = " + number_text(each.theta, 4) + "°" : text;
}

// The longest and most curved case; null when none is curved.
const EnsembleCase* most_curved(const Ensemble& ensemble) {
  const auto ratios = aspect_ratios(ensemble, true);
  if (ratios.empty()) return nullptr;
  return curved_case(ensemble, ratios.back(), opening_angles(ensemble, ratios.back()).back());
}

std::vector<const EnsembleCase*> representative_cases(const Ensemble& ensemble) {
  std::vector<const EnsembleCase*> cases;
  const auto add = [&](const EnsembleCase* each) {
    if (each && std::find(cases.begin(), cases.end(), each) == cases.end()) cases.push_back(each);
  };
  const auto ratios = aspect_ratios(ensemble, false);
  if (!ratios.empty())
    for (const double ratio : {ratios.front(), ratios.back()})
      for (const auto surface : {Surface::coarse, Surface::smooth})
        add(straight_case(ensemble, surface, ratio));
  add(straight_case(ensemble, Surface::sphere, 1));
  add(most_curved(ensemble));
  return cases;
}

}  // namespace

StudyFigure draw_packings(const Ensemble& ensemble, const std::string& study,
                          const std::string& out) {
  StudyFigure figure{"fig1_packings", "Fig. 1",
                     "Parts of packings, the first run of each case; primary spheres shaded by the "
                     "sum of the contact forces on them, a scale of its own each.",
                     ""};
  struct Chosen {
    const EnsembleCase* each;
    RunFrame frame;
  };
  std::vector<Chosen> chosen;
  for (const auto* each : representative_cases(ensemble))
    if (auto frame = last_frame(*each, study)) chosen.push_back({each, std::move(*frame)});
  if (chosen.empty()) {
    figure.not_drawn = "no dumps of spheres and bodies in the runs' folders";
    return figure;
  }
  std::vector<SheetPicture> pictures;
  for (const auto& [each, frame] : chosen) {
    RenderOptions options;
    options.window = central_window(frame);
    options.pixels = 560;
    options.colour = SphereColour::fsum;  // the net force on a sphere at rest alone is its weight
    const auto stem = (fs::path(out) / (figure.name + "_" + each->name)).string();
    render_spheres(frame.spheres, options, stem);
    pictures.push_back({stem, title_of(*study_case(each->name))});
  }
  draw_picture_sheet(pictures, 2, (fs::path(out) / figure.name).string());
  for (const auto& picture : pictures)
    for (const char* suffix : {".svg", ".png"}) fs::remove(picture.stem + suffix);
  return figure;
}

StudyFigure draw_packing_with_voids(const Ensemble& ensemble, const std::string& study,
                                    const std::string& out) {
  StudyFigure figure{"fig6b_voids", "Fig. 6b", "", ""};
  const auto* each = most_curved(ensemble);
  const auto frame = each ? last_frame(*each, study) : std::nullopt;
  if (!frame) {
    figure.not_drawn = "no curved case whose runs have dumps of spheres and bodies";
    return figure;
  }
  // Larger than the gap between four spheres in a square, (sqrt(2) - 1) d_p; the rough surface, an
  // axial length deep, is not a void.
  const VoidSearch search{0.5 * frame->diameter, frame->diameter / 20,
                          frame->surface - frame->axial_length};
  auto voids = find_voids(frame->spheres, frame->walls, search);
  // A void that reaches the top of the search goes on above it.
  voids.erase(std::remove_if(voids.begin(), voids.end(),
                             [&](const Void& one) {
                               return one.rows.back().y > search.surface - search.step;
                             }),
              voids.end());
  draw_voids(frame->spheres, voids, search, frame->walls, central_window(*frame), frame->diameter,
             (fs::path(out) / figure.name).string());
  double area = 0;
  int hollows = 0;
  for (const auto& one : voids) {
    area += one.area;
    hollows += one.in_hollow ? 1 : 0;
  }
  const double bed = frame->walls.width() * (search.surface - frame->walls.floor);
  figure.caption = "Part of a packing of " + title_of(*study_case(each->name)) +
                   ", with its voids: what a disc of diameter d_p / 2 covers without overlapping a "
                   "particle. Down from AR d_p below the surface, " +
                   std::to_string(voids.size()) + " voids cover " +
                   number_text(100 * area / bed, 3) + " % of the area; " + std::to_string(hollows) +
                   " of them lie mostly in the hollow of a particle.";
  return figure;
}

}  // namespace rodpack
