// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_GEOMETRY_PI_H
#define RODPACK_GEOMETRY_PI_H

namespace rodpack {

constexpr double pi = 3.14159265358979323846;

}  // namespace rodpack

#endif
