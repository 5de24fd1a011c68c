// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/edges/undisturbed.h"

#include <algorithm>
#include <limits>

namespace rodpack {

double kernel_reach(const AveragingKernel& kernel) {
  return std::min(3 * kernel.scale(), kernel.cutoff());
}

Rectangle undisturbed_part(const Packing& packing, double reach, Normalisation normalisation) {
  constexpr double endless = std::numeric_limits<double>::infinity();
  const auto& walls = packing.walls;
  // The paper's container leaves exactly 3 w beside its slice.
  const double away = reach * (1 - length_rounding);
  Rectangle part{-endless, endless, -endless, endless};
  if (normalisation == Normalisation::none) {
    if (walls.sides) {
      part.left = walls.left + away;
      part.right = walls.right - away;
    }
    if (walls.bottom) part.bottom = walls.floor + away;
  }
  if (normalisation != Normalisation::walls_and_surface && walls.bottom)
    part.top = packing.surface - away;
  return part;
}

bool slice_is_undisturbed(const Packing& packing, double reach, Normalisation normalisation) {
  const auto part = undisturbed_part(packing, reach, normalisation);
  const double middle = 0.5 * (packing.walls.left + packing.walls.right);
  return part.left <= middle - packing.axial_length() &&
         part.right >= middle + packing.axial_length();
}

std::array<double, 2> undisturbed_heights(const Packing& packing, double reach,
                                          Normalisation normalisation) {
  const auto part = undisturbed_part(packing, reach, normalisation);
  const double from = std::max(part.bottom, packing.walls.floor);
  if (!slice_is_undisturbed(packing, reach, normalisation)) return {from, from};
  return {from, std::min(part.top, packing.surface)};
}

std::vector<Rectangle> parts_outside(const Rectangle& inner, const Rectangle& whole) {
  const Rectangle kept{std::max(inner.left, whole.left), std::min(inner.right, whole.right),
                       std::max(inner.bottom, whole.bottom), std::min(inner.top, whole.top)};
  if (!(kept.left < kept.right && kept.bottom < kept.top)) return {whole};
  std::vector<Rectangle> parts;
  for (const Rectangle& part : {Rectangle{whole.left, whole.right, whole.bottom, kept.bottom},
                                {whole.left, whole.right, kept.top, whole.top},
                                {whole.left, kept.left, kept.bottom, kept.top},
                                {kept.right, whole.right, kept.bottom, kept.top}})
    if (part.left < part.right && part.bottom < part.top) parts.push_back(part);
  return parts;
}

}  // namespace rodpack
