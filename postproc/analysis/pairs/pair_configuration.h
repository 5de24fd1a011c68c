// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_PAIRS_PAIR_CONFIGURATION_H
#define RODPACK_ANALYSIS_PAIRS_PAIR_CONFIGURATION_H

#include <string>
#include <vector>

#include "rodpack/geometry/chain_geometry.h"

namespace rodpack {

// What counts as equal in the names of configurations.
constexpr double same_place = 0.25;  // d_p
constexpr double parallel = 10;      // degrees, at most
constexpr double upright = 75;       // degrees, at least

/// " shifted by 0.5 d_p", or nothing where that is no shift in names.
std::string shift_in_words(double along);

enum class ParticleKind { sphere, straight, curved };

/// How two alike particles lie to each other: the neighbour in the frame of the centre particle,
/// whose origin is the centre of mass, whose x axis ("along") is parallel to the chord between the
/// particle's ends, and to whose y axis ("across") a curved one bulges. Lengths in d_p.
struct PairConfiguration {
  double along = 0, across = 0;  // of the neighbour's centre of mass
  double angle = 0;              // of its own x axis, rad; spheres have none
};

/// Returns the configuration of two particles whose x axes point to `angle_centre` and
/// `angle_neighbour`, rad; (dx, dy): from centre to neighbour, in d_p.
PairConfiguration pair_configuration(double dx, double dy, double angle_centre,
                                     double angle_neighbour);

/// Returns the same pair seen from the neighbour.
PairConfiguration from_neighbour(const PairConfiguration& pair);

/// Returns everything that `pair` is equal to, itself first: seen from either particle, and through
/// the mirrors of their shape. Straight particles (no head or tail) have eight, curved ones four;
/// two spheres are described by their distance alone. Entry k comes from the same operation for
/// every pair of one kind.
std::vector<PairConfiguration> equal_configurations(const PairConfiguration& pair,
                                                    ParticleKind kind);

/// Returns `angle` - `reference` between -1/2 and 1/2 of the turn after which a particle looks the
/// same: pi for a straight one, 2 pi for a curved one; rad.
double angle_from(double reference, double angle, ParticleKind kind);

/// Picks of equal_configurations() the one that is reported: along >= 0, for straight particles
/// across >= 0 too; seen from the particle that the other lies more beside than ahead of (smaller
/// `along`), if that decides, else from the one with the larger `across`. The angle is in (-90, 90]
/// degrees for straight particles, (-180, 180] for curved ones.
PairConfiguration reported_configuration(const PairConfiguration& pair, ParticleKind kind);

/// Returns the name of a reported configuration in plain words, by the rules of postproc/README.md
/// (Definitions); `shape`: of the particles, `common`: of two spheres, how many others are next to
/// both.
std::string configuration_name(const PairConfiguration& pair, ParticleKind kind,
                               const ChainShape& shape, int common);

/// Makes the shape of a particle of the bodies' dump: so many `spheres`, l_axial = `aspect_ratio`
/// `nominal_diameter`, drawn `diameter`, arc angle `curvature` (rad); lengths in one unit.
/// @throws std::invalid_argument when there is no such chain.
ChainShape shape_of_body(int spheres, double aspect_ratio, double nominal_diameter, double diameter,
                         double curvature);

}  // namespace rodpack

#endif
