// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/scene.h"

#include "analysis/edges/undisturbed.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {

constexpr double papers_width = 20;  // of the container, in l_axial
constexpr double papers_height = 2;  // of the container, m

}  // namespace

std::string scene_unlike_the_papers(const nlohmann::json& parameters) {
  const auto number = [&](const char* name) {
    const auto found = parameters.find(name);
    return found != parameters.end() && found->is_number() ? found->get<double>() : 0.0;
  };
  const double diameter = number("particle_diameter_m"), ratio = number("aspect_ratio");
  const double width = number("container_width_m"), height = number("container_height_m");
  if (!(diameter > 0 && ratio > 0 && width > 0 && height > 0)) return {};
  const double lengths = width / (ratio * diameter);
  if (lengths >= papers_width * (1 - length_rounding) &&
      height >= papers_height * (1 - length_rounding))
    return {};
  return "Not the paper's scene: the container is " + number_text(width / diameter, 3) +
         " d_p wide (" + number_text(lengths, 3) + " particle lengths) and " +
         number_text(height, 3) + " m high, the paper's " + number_text(papers_width * ratio, 3) +
         " d_p (20 lengths) and 2 m. Walls, floor and the low "
         "fall order such a bed otherwise: coarse particles of AR = 2 prefer 0, 60 and 120 degrees "
         "in the quick preset, 30, 90 and 150 in the paper. Its numbers are not to be compared "
         "with the paper's.";
}

}  // namespace rodpack
