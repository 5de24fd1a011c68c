// SPDX-License-Identifier: GPL-2.0-or-later
#include "timestep/run_network.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "analysis/fields.h"
#include "reading/checks/contacts_of_bodies.h"
#include "reading/checks/planar.h"
#include "reading/data_error.h"
#include "reading/dump.h"
#include "reading/number_text.h"
#include "reading/parameters.h"
#include "reading/run_folder.h"
#include "rodpack/contact/contact_law.h"
#include "rodpack/geometry/mass_properties.h"

namespace rodpack {
namespace {

/// Moment of inertia about the axis across the plane over the mass, of the nominal particle, m^2.
double squared_gyration_radius(const RunParameters& parameters) {
  const double diameter = parameters.number("particle_diameter_m");
  const ChainShape shape{parameters.number("aspect_ratio"), diameter, parameters.number("overlap"),
                         parameters.number("curvature_deg") * std::acos(-1.0) / 180, diameter};
  try {
    const MassProperties solid =
        mass_properties(shape, parameters.number("density_kg_m3"), MassRule::reference, false);
    return solid.inertia[2] / solid.mass;
  } catch (const std::invalid_argument& reason) {
    throw DataError(parameters.file + ": " + reason.what());
  }
}

/// Two particles, or one and a wall, and a direction.
void require_sound(const SphereContact& contact, const VectorColumns& normal, std::size_t row,
                   const std::string& file) {
  if (!contact.wall && contact.i == contact.j)
    throw DataError(file + ": a contact of particle " + std::to_string(contact.i) +
                    " with itself, expected two particles");
  double square = 0;
  for (const auto* column : normal) square += (*column)[row] * (*column)[row];
  if (std::fabs(square - 1) > 1e-3)
    throw DataError(file + ": columns nx ny nz: expected a unit vector, found one of length " +
                    number_text(std::sqrt(square), 4) + " in a contact of particle " +
                    std::to_string(contact.i));
}

}  // namespace

RunNetwork read_network(const std::string& run) {
  const RunParameters parameters = read_parameters(run + "/parameters.json");
  for (const char* key :
       {"normal_stiffness_N_m", "tangential_stiffness_N_m", "damping_ratio_normal",
        "damping_ratio_tangential", "aspect_ratio", "overlap", "curvature_deg"})
    if (!parameters.values.contains(key))
      throw DataError(parameters.file +
                      ": expected a deposition's parameters of particles and of a " +
                      "linear contact law (model spring_dashpot), found no key '" + key + "'");
  const Frame frame = last_frame(dumps_of_run(run, "bodies"));
  const Frame contacts = frame_beside(frame, dumps_of_run(run, "contacts"));
  require_planar_bodies(frame, parameters.number("particle_diameter_m"));
  require_planar_contacts(contacts);
  require_contacts_of_bodies(contacts, frame);

  RunNetwork network;
  network.stiffness = parameters.number("normal_stiffness_N_m");
  network.damping_ratio = parameters.number("damping_ratio_normal");
  network.timestep = parameters.number("timestep_s");
  if (parameters.values.contains("mass_scaling"))
    network.mass_scaling = parameters.number("mass_scaling");
  const double gyration = squared_gyration_radius(parameters);
  const auto &ids = frame.column("id"), &mass = frame.column("mass");
  if (frame.rows == 0) throw DataError(frame.file + ": no particle in the last frame");
  network.lightest = *std::min_element(mass.begin(), mass.end());
  std::map<long, int> index;
  for (std::size_t k = 0; k < frame.rows; ++k) {
    index[std::lround(ids[k])] = static_cast<int>(k);
    NetworkBody body = {};
    body.mass = mass[k];
    for (auto& row : body.moments) std::fill(row, row + 3, 0.0);
    for (int d = 0; d < 3; ++d) body.moments[d][d] = gyration * body.mass;
    body.is_free = {true, true, false, false, false, true};
    network.bodies.push_back(body);
  }

  const bool sticks = parameters.number("friction") > 0;
  const double kt = sticks ? parameters.number("tangential_stiffness_N_m") : 0;
  const double eta_t = sticks ? parameters.number("damping_ratio_tangential") : 0;
  const auto body_of = [&](long id) {
    const auto found = index.find(id);
    if (found == index.end())
      throw DataError(contacts.file + ": a contact of particle " + std::to_string(id) +
                      ", expected those of " + frame.file);
    return found->second;
  };
  const VectorColumns normal = vector_columns(contacts, {"nx", "ny", "nz"});
  const std::vector<SphereContact> all = read_contacts(contacts);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const SphereContact& each = all[k];
    require_sound(each, normal, k, contacts.file);
    NetworkContact one = {};
    one.i = body_of(each.i);
    one.j = each.wall ? -1 : body_of(each.j);
    for (int d = 0; d < 3; ++d) {
      one.normal[d] = (*normal[d])[k];
      one.arm_i[d] = each.point[d] - each.centre_i[d];
      one.arm_j[d] = each.point[d] - each.centre_j[d];
    }
    // Two springs in a row have half of the stiffness; a wall has that of the particle (physics of
    // the paper, section 2).
    const double share = each.wall ? 1 : 0.5;
    const double between = each.wall ? mass[one.i] : effective_mass(mass[one.i], mass[one.j]);
    one.stiffness_n = share * network.stiffness;
    one.damping_n = damping_coefficient(network.damping_ratio, between, one.stiffness_n);
    one.stiffness_t = share * kt;
    one.damping_t = damping_coefficient(eta_t, between, one.stiffness_t);
    network.contacts.push_back(one);
  }
  return network;
}

}  // namespace rodpack
