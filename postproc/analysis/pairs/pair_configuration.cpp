// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/pairs/pair_configuration.h"

#include <algorithm>
#include <cmath>

#include "reading/angles.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {

bool about(double value, double expected) { return std::abs(value - expected) <= same_place; }

std::string sphere_name(double distance, int common) {
  if (distance <= 1 + same_place / 2) return "touching";
  if (common >= 2 && std::abs(distance - std::sqrt(3.0)) <= same_place / 2)
    return "across two triangles";
  if (common == 1 && std::abs(distance - 2) <= same_place / 2) return "in a row of three";
  if (common == 0) return "no sphere next to both";
  return common == 1 ? "both next to one sphere"
                     : "both next to " + std::to_string(common) + " spheres";
}

// Where the spheres of one chain sit in the hollows of the other.
std::string in_hollows(const PairConfiguration& pair) {
  static const char* const shifts[] = {"half a sphere", "one and a half spheres",
                                       "two and a half spheres"};
  const double spheres = std::round(pair.along - 0.5);
  const bool sits = std::abs(pair.along - 0.5 - spheres) <= same_place / 2 &&
                    std::abs(pair.across - std::sqrt(0.75)) <= 0.1;
  return sits && spheres < 3 ? std::string(" shifted by ") + shifts[static_cast<int>(spheres)] : "";
}

std::string parallel_name(const PairConfiguration& pair, double aspect_ratio) {
  if (pair.across <= same_place)
    return pair.along <= aspect_ratio + same_place ? "end to end" : "in line and apart";
  const auto shift = shift_in_words(pair.along);
  if (pair.across > 2 + same_place) return "parallel and apart" + shift;
  if (pair.across > 1 + same_place) return "parallel with one between" + shift;
  if (pair.along > aspect_ratio - same_place) return "end to end with a step";
  const auto hollow = in_hollows(pair);
  return "side by side" + (hollow.empty() ? shift : hollow);
}

std::string straight_name(const PairConfiguration& pair, double turn, double aspect_ratio) {
  if (turn <= parallel) return parallel_name(pair, aspect_ratio);
  const double half = aspect_ratio / 2;
  if (turn >= upright) {
    if (!about(pair.across, half + 0.5)) return "at right angles";
    if (pair.along <= same_place) return "T";
    return pair.along > half - 0.5 - same_place ? "L" : "T off the middle";
  }
  // The neighbour's axis against the line between the centres.
  const double line = std::atan2(pair.across, pair.along);
  const bool end_on = std::abs(angle_from(line, pair.angle, ParticleKind::straight)) <= pi / 4;
  return "oblique at " + number_text(std::round(turn)) + (end_on ? "° end on" : "° flank on");
}

std::string curved_name(const PairConfiguration& pair, double turn, double curvature) {
  const double off = std::min(turn, 180 - turn);  // from alike or opposed
  if (off > 45) return "turned by " + number_text(std::round(turn)) + "°";
  auto ending = shift_in_words(pair.along);
  if (off > parallel) ending += " turned by " + number_text(std::round(off)) + "°";
  if (turn > 90) return (pair.across > 0 ? "back to back" : "open sides facing") + ending;
  const double across = std::abs(pair.across);
  if (across <= same_place) return "end to end" + ending;
  // Arcs that are stacked touch near their ends, where a step across is cos(theta / 2) of it.
  const double nested = 1 / std::cos(std::min(curvature, pi * 2 / 3) / 2);
  return (across <= nested + same_place ? "nested arcs" : "nested arcs apart") + ending;
}

double full_turn(ParticleKind kind) { return kind == ParticleKind::curved ? 2 * pi : pi; }

}  // namespace

std::string shift_in_words(double along) {
  if (along <= same_place) return "";
  return " shifted by " + number_text(std::round(10 * along) / 10) + " d_p";
}

PairConfiguration pair_configuration(double dx, double dy, double angle_centre,
                                     double angle_neighbour) {
  const double c = std::cos(angle_centre), s = std::sin(angle_centre);
  return {c * dx + s * dy, c * dy - s * dx, angle_neighbour - angle_centre};
}

PairConfiguration from_neighbour(const PairConfiguration& pair) {
  return pair_configuration(-pair.along, -pair.across, pair.angle, 0);
}

std::vector<PairConfiguration> equal_configurations(const PairConfiguration& pair,
                                                    ParticleKind kind) {
  if (kind == ParticleKind::sphere) return {{std::hypot(pair.along, pair.across), 0, 0}};
  std::vector<PairConfiguration> all;
  for (const auto& view : {pair, from_neighbour(pair)})
    for (const double x : {1.0, -1.0})
      for (const double y : {1.0, -1.0}) {
        // The mirror across the axis turns a curved particle's open side: no symmetry.
        if (y < 0 && kind == ParticleKind::curved) continue;
        all.push_back({x * view.along, y * view.across, x * y * view.angle});
      }
  return all;
}

double angle_from(double reference, double angle, ParticleKind kind) {
  return std::remainder(angle - reference, full_turn(kind));
}

PairConfiguration reported_configuration(const PairConfiguration& pair, ParticleKind kind) {
  if (kind == ParticleKind::sphere) return equal_configurations(pair, kind).front();
  constexpr double rounding = 1e-6;  // keeps equal views from being told apart by their last digits
  PairConfiguration best;
  bool found = false;
  for (auto view : equal_configurations(pair, kind)) {
    const bool folded = view.along >= 0 && (kind == ParticleKind::curved || view.across >= 0);
    if (!folded) continue;
    const double gain = best.along - view.along;
    if (found && !(gain > rounding || (gain > -rounding && view.across > best.across + rounding)))
      continue;
    best = view;
    found = true;
  }
  const double turn = full_turn(kind);
  best.angle = angle_from(0, best.angle, kind);
  if (best.angle <= -turn / 2 * (1 - rounding)) best.angle += turn;
  // Rounding would leave a sign where there is no angle.
  if (std::abs(best.angle) < rounding * rounding) best.angle = 0;
  return best;
}

std::string configuration_name(const PairConfiguration& pair, ParticleKind kind,
                               const ChainShape& shape, int common) {
  const double turn = std::abs(pair.angle) / degree;
  if (kind == ParticleKind::sphere) return sphere_name(pair.along, common);
  return kind == ParticleKind::curved ? curved_name(pair, turn, shape.curvature_angle)
                                      : straight_name(pair, turn, shape.aspect_ratio);
}

ChainShape shape_of_body(int spheres, double aspect_ratio, double nominal_diameter, double diameter,
                         double curvature) {
  ChainShape shape{aspect_ratio, nominal_diameter, 0, curvature, diameter};
  if (spheres < 2) {
    shape.aspect_ratio = 1;
    shape.curvature_angle = 0;
    return shape;
  }
  // A little more overlap than the spacing, so that rounding makes no sphere more of it.
  shape.overlap = std::max(0.0, 1 - (aspect_ratio - 1) / (spheres - 1) * (1 + 1e-12));
  validate(shape);
  return shape;
}

}  // namespace rodpack
