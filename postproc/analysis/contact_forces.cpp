// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/contact_forces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>

#include "reading/checks/contacts_of_bodies.h"
#include "reading/checks/number_range.h"
#include "reading/csv_file.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// Turns counts of bins into a probability density and its binomial error.
void normalise(const std::vector<double>& count, double total, double width,
               std::vector<double>& density, std::vector<double>& standard_error) {
  for (const double each : count) {
    const double p = total > 0 ? each / total : 0;
    density.push_back(p / width);
    standard_error.push_back(total > 0 ? std::sqrt(p * (1 - p) / total) / width : 0);
  }
}

std::size_t bin_of(double value, double width) { return static_cast<std::size_t>(value / width); }

ForceDistribution distribution(const std::vector<double>& forces, double width, std::size_t bins) {
  ForceDistribution result;
  result.mean = mean_of(forces);
  result.count.assign(bins, 0);
  if (result.mean > 0)
    for (const double force : forces) result.count[bin_of(force / result.mean, width)] += 1;
  const double total = result.mean > 0 ? static_cast<double>(forces.size()) : 0;
  normalise(result.count, total, width, result.density, result.standard_error);
  return result;
}

}  // namespace

ContactForceSample::ContactForceSample(const ContactForceOptions& options) : options_(options) {
  require_positive(options.bin_width, "width of the bins of the contact forces");
  for (const auto& row : options.friction.table)
    for (const double each : row)
      if (!(each >= 0))
        throw DataError("friction coefficient: expected a value of at least 0, found " +
                        number_text(each));
}

void ContactForceSample::add(const Frame& contacts, const Frame* bodies) {
  require_any_contact(contacts);
  if (bodies && bodies->timestep != contacts.timestep)
    throw DataError(bodies->file + ": expected bodies of timestep " +
                    std::to_string(contacts.timestep) + " as the contacts of " + contacts.file +
                    ", found timestep " + std::to_string(bodies->timestep));
  add_forces(contacts);
  add_coordination(contacts, bodies);
  if (bodies) require_contacts_of_bodies(contacts, *bodies);
}

void ContactForceSample::add_forces(const Frame& contacts) {
  const auto& wall = contacts.column("wall");
  const auto f = vector_columns(contacts, {"fx", "fy", "fz"});
  const auto n = vector_columns(contacts, {"nx", "ny", "nz"});
  std::optional<FrictionOfContacts> friction;
  if (!options_.friction.table.empty()) friction.emplace(contacts, options_.friction.table);
  for (std::size_t i = 0; i < contacts.rows; ++i) {
    const double length = std::hypot((*n[0])[i], (*n[1])[i], (*n[2])[i]);
    if (!(std::abs(length - 1) < 1e-3))  // a dump may print few digits
      throw DataError(at_row(contacts, i) +
                      "columns 'nx ny nz': expected a unit vector, found one of length " +
                      number_text(length, 6));
    if (wall[i] != 0 && !options_.walls_too) {
      ++at_walls_;
      continue;
    }
    double normal = 0;
    for (std::size_t c = 0; c < 3; ++c) normal += (*f[c])[i] * (*n[c])[i] / length;
    if (!(normal > 0)) {
      ++not_carrying_;
      continue;
    }
    std::array<double, 3> rest{};
    for (std::size_t c = 0; c < 3; ++c) rest[c] = (*f[c])[i] - normal * (*n[c])[i] / length;
    const double tangential = std::hypot(rest[0], rest[1], rest[2]);
    normal_.push_back(normal);
    normals_.push_back({(*n[0])[i] / length, (*n[1])[i] / length, (*n[2])[i] / length});
    // Without friction only rounding errors are left, whose distribution would mean nothing.
    tangential_.push_back(tangential > 1e-12 * normal ? tangential : 0);
    if (friction) frictional_.push_back(friction->of(i, normal, tangential_.back()));
  }
}

struct ContactForceSample::Neighbours {
  std::set<double> particles;
  std::size_t contacts = 0;
  bool touches_wall = false;
};

void ContactForceSample::add_coordination(const Frame& contacts, const Frame* bodies) {
  const auto& body_i = contacts.column("body_i");
  const auto& body_j = contacts.column("body_j");
  const auto& wall = contacts.column("wall");
  std::map<double, Neighbours> particles;
  if (bodies)
    for (const double id : bodies->column("id")) particles[id];
  const auto particle = [&](double id) -> Neighbours& {
    if (bodies && !particles.count(id))
      throw DataError(bodies->file + ": no particle " + number_text(id) +
                      ", which has a contact in " + contacts.file);
    return particles[id];
  };
  for (std::size_t i = 0; i < contacts.rows; ++i) {
    auto& first = particle(body_i[i]);
    if (wall[i] != 0) {
      first.touches_wall = true;
      if (options_.walls_too) ++first.contacts;
      continue;
    }
    auto& second = particle(body_j[i]);
    first.particles.insert(body_j[i]);
    second.particles.insert(body_i[i]);
    ++first.contacts;
    ++second.contacts;
  }
  for (const auto& [id, neighbours] : particles) {
    with_touching_[neighbours.particles.size()] += 1;
    with_contacts_[neighbours.contacts] += 1;
    if (neighbours.particles.empty() && !neighbours.touches_wall) ++rattlers_;
  }
  particles_ += particles.size();
  all_particles_known_ = all_particles_known_ && bodies;
}

ContactForces ContactForceSample::result() const {
  if (normal_.empty())
    throw TooFewParticles(
        "contact forces: no contact carries a force; left out: " + std::to_string(not_carrying_) +
        " without normal force, " + std::to_string(at_walls_) + " with walls");
  ContactForces result;
  result.carrying = normal_.size();
  result.not_carrying = not_carrying_;
  result.at_walls = at_walls_;

  const double width = options_.bin_width;
  double largest = 0;
  for (const auto* forces : {&normal_, &tangential_})
    if (const double mean = mean_of(*forces); mean > 0)
      largest = std::max(largest, *std::max_element(forces->begin(), forces->end()) / mean);
  const auto bins = bin_of(largest, width) + 1;
  for (std::size_t k = 0; k < bins; ++k)
    result.force_over_mean.push_back((static_cast<double>(k) + 0.5) * width);
  result.normal = distribution(normal_, width, bins);
  result.tangential = distribution(tangential_, width, bins);
  result.friction = mobilised_friction(frictional_);
  if (!result.friction)
    result.why_no_friction = options_.friction.table.empty()
                                 ? options_.friction.missing
                                 : "the contacts that are measured have friction 0, so that the "
                                   "mobilised friction is left out";

  auto& coordination = result.coordination;
  coordination.particles = particles_;
  if (all_particles_known_) coordination.rattlers = rattlers_;
  const auto most = std::max(with_touching_.rbegin()->first, with_contacts_.rbegin()->first);
  coordination.with_touching_particles.assign(most + 1, 0);
  coordination.with_contacts.assign(most + 1, 0);
  for (std::size_t k = 0; k <= most; ++k) coordination.number.push_back(static_cast<double>(k));
  const double n = static_cast<double>(particles_);
  for (const auto& [number, count] : with_touching_) {
    coordination.with_touching_particles[number] = count;
    coordination.touching_particles += static_cast<double>(number) * count / n;
  }
  for (const auto& [number, count] : with_contacts_) {
    coordination.with_contacts[number] = count;
    coordination.contacts += static_cast<double>(number) * count / n;
  }
  return result;
}

ContactForces measure_contact_forces(const Frame& contacts, const Frame* bodies,
                                     const ContactForceOptions& options) {
  ContactForceSample sample(options);
  sample.add(contacts, bodies);
  return sample.result();
}

std::string write_contact_force_tables(const ContactForces& forces, const std::string& stem) {
  write_csv(stem + ".csv", {{"f_over_mean", forces.force_over_mean},
                            {"normal_count", forces.normal.count},
                            {"normal_density", forces.normal.density},
                            {"normal_standard_error", forces.normal.standard_error},
                            {"tangential_count", forces.tangential.count},
                            {"tangential_density", forces.tangential.density},
                            {"tangential_standard_error", forces.tangential.standard_error}});
  std::string of_types;
  if (forces.friction) of_types = write_friction_tables(*forces.friction, stem + "_friction");
  const auto& coordination = forces.coordination;
  write_csv(stem + "_coordination.csv",
            {{"number", coordination.number},
             {"particles_with_touching_particles", coordination.with_touching_particles},
             {"particles_with_contacts", coordination.with_contacts}});
  return of_types;
}

}  // namespace rodpack
