// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_PALETTE_H
#define RODPACK_FIGURES_PALETTE_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace rodpack {

// Colours of pictures; for the rooms that draw packings: this one and page.

using Rgb = std::array<double, 3>;  // 0 to 255

/// Sequential, perceptually even and colour-blind-safe ("viridis"): nine of its colours.
inline constexpr std::array<Rgb, 9> viridis{{{68, 1, 84},
                                             {71, 44, 122},
                                             {59, 81, 139},
                                             {44, 113, 142},
                                             {33, 144, 141},
                                             {39, 173, 129},
                                             {92, 200, 99},
                                             {170, 220, 50},
                                             {253, 231, 37}}};

/// Sequential, from a light grey to dark red: for lines on a white background, where the weak ones
/// should fade.
inline constexpr std::array<Rgb, 9> embers{{{205, 200, 192},
                                            {232, 192, 148},
                                            {250, 178, 112},
                                            {250, 141, 89},
                                            {239, 101, 72},
                                            {215, 48, 31},
                                            {179, 0, 0},
                                            {127, 0, 0},
                                            {70, 0, 10}}};

/// Cyclic ("twilight", shifted), for angles: both ends are the same colour, dark so that the flat
/// majority keeps clear of the white background.
inline constexpr std::array<Rgb, 9> twilight{{{47, 20, 54},
                                              {130, 31, 79},
                                              {178, 81, 82},
                                              {204, 156, 133},
                                              {226, 217, 226},
                                              {158, 187, 201},
                                              {103, 133, 190},
                                              {94, 67, 165},
                                              {47, 20, 54}}};

/// Colour at `position` in [0, 1] (clamped), as "#rrggbb".
inline std::string palette_colour(const std::array<Rgb, 9>& knots, double position) {
  const double at = std::clamp(position, 0.0, 1.0) * static_cast<double>(knots.size() - 1);
  const auto k = std::min(static_cast<std::size_t>(at), knots.size() - 2);
  const double part = at - static_cast<double>(k);
  int channel[3];
  for (std::size_t c = 0; c < 3; ++c)
    channel[c] =
        static_cast<int>(std::lround(knots[k][c] + part * (knots[k + 1][c] - knots[k][c])));
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", channel[0], channel[1], channel[2]);
  return text;
}

}  // namespace rodpack

#endif
