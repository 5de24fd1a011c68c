// SPDX-License-Identifier: GPL-2.0-or-later
// What all lanes of two blocks have in common; included by their headers after each_two().

/// The same of four numbers.
inline void each_four(const double* const (&of)[lane_blocks], int index, Lanes& first,
                      Lanes& second, Lanes& third, Lanes& fourth) {
  each_two(of, index, first, second);
  each_two(of, index + 2, third, fourth);
}

/// Whether the bodies of some block, i and j as PlanarGroupHeads has them, have travelled as far as
/// its gap together, m.
inline bool any_has_met(const double* travelled, const std::uint32_t* i, const std::int32_t* j,
                        const float* gap) {
  bool any = false;
  for (int b = 0; b < lane_blocks; ++b) {
    const std::uint32_t of_j = static_cast<std::uint32_t>(j[b]) / planar_stride;
    any |= !(travelled[i[b] / planar_stride] + travelled[of_j] < gap[b]);
  }
  return any;
}
