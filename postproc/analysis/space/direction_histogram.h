// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_SPACE_DIRECTION_HISTOGRAM_H
#define RODPACK_ANALYSIS_SPACE_DIRECTION_HISTOGRAM_H

#include <string>
#include <utility>
#include <vector>

#include "analysis/space/order_tensor.h"
#include "reading/checks/body_axes.h"

namespace rodpack {

/// Distribution of an angle over bins that isotropic directions fill evenly; one entry per bin.
struct DirectionHistogram {
  std::vector<double> from, to;        // degrees
  std::vector<double> count;           // directions in the bin
  std::vector<double> density;         // over that of isotropic directions; its mean is 1
  std::vector<double> standard_error;  // binomial, of the density
};

/// Angles of directions without head or tail about one coordinate axis.
///
/// Polar angle: [0, 90] degrees from that axis, in bins of equal solid angle, that is of equal
/// steps of its cosine. Azimuth: [0, 180) degrees about it, from the next axis in the order x, y,
/// z, x towards the one after; bins of equal width, centred on its multiples, so that the first one
/// goes half a width over either end of the range, which are one direction.
struct DirectionAngles {
  double polar;    // degrees
  double azimuth;  // degrees; nan along the axis itself
};
/// `direction`: a unit vector; `vertical`: the coordinate axis, 0 to 2.
DirectionAngles direction_angles(const Vector3& direction, std::size_t vertical);

/// The bin of the polar angle that a direction, a unit vector, falls into.
std::size_t polar_bin(const Vector3& direction, std::size_t vertical, std::size_t bins);
DirectionHistogram polar_histogram(const std::vector<Vector3>& directions, std::size_t vertical,
                                   std::size_t bins);
/// Leaves out the directions along the axis itself.
DirectionHistogram azimuth_histogram(const std::vector<Vector3>& directions, std::size_t vertical,
                                     std::size_t bins);

/// Writes a CSV table with the columns `angle`_from_deg, `angle`_to_deg, count,
/// density_over_isotropic, standard_error, then further ones with one entry per bin. `angle`:
/// "polar" or "azimuth".
void write_direction_table(
    const DirectionHistogram& histogram, const std::string& angle, const std::string& file,
    const std::vector<std::pair<std::string, std::vector<double>>>& further = {});

/// Writes a CSV table of the three principal values, largest first: order, standard_error,
/// direction_x, direction_y, direction_z (pointing up), polar_deg, azimuth_deg.
void write_order_table(const OrderTensor& order, std::size_t vertical, const std::string& file);

}  // namespace rodpack

#endif
