// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_SPACE_FABRIC_H
#define RODPACK_ANALYSIS_SPACE_FABRIC_H

#include <string>
#include <vector>

#include "analysis/space/direction_histogram.h"
#include "analysis/space/order_tensor.h"

namespace rodpack {

/// How the contact normals lie in space, and what they carry. The fabric tensor <n n> is
/// 1/3 + 2/3 S with the order tensor S of the normals; a density 1 + a P_2(cos) of their polar
/// angle has the order a / 5 about the vertical.
struct Fabric {
  std::size_t vertical = 2;  // axis that the polar angle is measured from, 0 to 2
  OrderTensor order;
  OrderAbout about_vertical{};
  DirectionHistogram polar;
  std::vector<double> force;  // mean normal force of the bin's contacts over that of all; 0 without
  std::vector<double> force_standard_error;  // of that mean; 0 for fewer than 2 contacts
};

/// Measures it, over so many `bins` of equal solid angle. `normals`: unit vectors, one per contact;
/// `forces`: their normal forces, N. Contacts are taken as independent.
/// @throws TooFewParticles when there are fewer than 2 contacts.
Fabric measure_fabric(const std::vector<Vector3>& normals, const std::vector<double>& forces,
                      std::size_t vertical, std::size_t bins = 18);

/// Writes a CSV table as write_direction_table() does, with the further columns
/// normal_force_over_mean, its_standard_error.
void write_fabric_table(const Fabric& fabric, const std::string& file);

}  // namespace rodpack

#endif
