// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_TESTS_STOCK_MODELS_H
#define RODPACK_TESTS_STOCK_MODELS_H

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace rodpack::test {

// Decks of LIGGGHTS's own contact models, and what they are made of. SI units.

constexpr double sphere_radius = 1.5e-3, gravity = 9.81, hooke_speed = 0.5, friction = 0.3;
const double sphere_mass = 2500 * 4.0 / 3 * M_PI * std::pow(sphere_radius, 3);
/// E* = E / 2(1 - nu^2) of Deck::hertz(), Pa.
constexpr double reduced_modulus = 1e6 / (2 * (1 - 0.3 * 0.3));
constexpr double cohesion_density = 200;  // of cohesion sjkr, J/m^3

/// F = 4/3 E* sqrt(R* delta) delta.
inline double hertz_force(double overlap, double reduced_radius) {
  return 4.0 / 3 * reduced_modulus * std::sqrt(reduced_radius * overlap) * overlap;
}

/// Combinations of normal, tangential, cohesion and rolling models; the last ones have a normal
/// force that depends on what the contact has been through, or acts across gaps.
std::vector<std::string> stock_models();
const char* const bridging_model = "model hertz tangential history cohesion easo/capillary/viscous";

/// Two spheres above each other, at rest and 10 um deep in each other, the lower one (atom 2) 20 um
/// deep in a floor at y = 0: a primitive plane, or two triangles written into `mesh`. `settings` of
/// the models follow them.
std::string pressed_spheres(const std::string& models, const std::filesystem::path* mesh = nullptr,
                            const std::string& settings = "");

/// Spheres, as `create_atoms` commands, above such a floor in a box of 20 mm (40 mm high), under
/// gravity.
std::string column_of(const std::string& models, const std::string& spheres,
                      const std::filesystem::path* mesh = nullptr);

/// 36 spheres that fall and slide into a heap on a floor, x periodic, for 2000 steps; `lines` come
/// before the run, and end.dump tells of its end. Goes on from the restart file `from` if given.
std::string shaken_spheres(const std::string& models, const std::string& lines,
                           const std::string& from = "", const std::string& end = "end");

/// Twelve rods of three spheres that fall onto each other and a floor, x periodic, for 10000 steps.
std::string falling_rods(const std::string& models, const std::string& lines);

/// Dumps atoms.dump, spheres.dump and contacts.dump every so many steps.
std::string listed_every(int steps);

}  // namespace rodpack::test

#endif
