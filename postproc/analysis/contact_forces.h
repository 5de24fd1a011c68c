// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_CONTACT_FORCES_H
#define RODPACK_ANALYSIS_CONTACT_FORCES_H

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/mixture/mobilised_friction.h"
#include "reading/checks/body_axes.h"
#include "reading/dump.h"

namespace rodpack {

struct ContactForceOptions {
  double bin_width = 0.25;  // of the force distributions, in mean forces
  bool walls_too = false;   // contacts with walls count as well
  FrictionFound friction;   // none: no mobilised friction
};

/// Distribution of one component of the force, scaled by its mean. One entry per bin.
struct ForceDistribution {
  double mean = 0;                     // N
  std::vector<double> count;           // contacts in the bin
  std::vector<double> density;         // of f / mean; integrates to 1, 0 if all forces are 0
  std::vector<double> standard_error;  // binomial, of the density
};

/// Who touches whom, forces aside: contacts that carry nothing count too. Means over all particles.
struct Coordination {
  std::size_t particles = 0;      // all frames together
  double touching_particles = 0;  // mean number of different particles that one touches
  double contacts = 0;            // mean number of sphere contacts of a particle
  /// Particles without contact, with a wall neither; none without a dump of bodies, where they are
  /// missed in all that stands here.
  std::optional<std::size_t> rattlers;
  std::vector<double> number;                   // 0, 1, 2, ...
  std::vector<double> with_touching_particles;  // particles that touch so many others
  std::vector<double> with_contacts;            // particles that have so many sphere contacts
};

struct ContactForces {
  std::size_t carrying = 0;             // contacts with a normal force, those that are measured
  std::size_t not_carrying = 0;         // contacts without
  std::size_t at_walls = 0;             // left out: contacts with a wall; 0 if they count
  std::vector<double> force_over_mean;  // middle of the bin, common to both components
  ForceDistribution normal, tangential;
  std::optional<MobilisedFriction> friction;  // none without mu
  std::string why_no_friction;
  Coordination coordination;
};

/// Collects the contacts of one or several frames of the contacts' dump (columns `body_i body_j
/// wall fx fy fz nx ny nz`, and `type_i type_j` where these decide on friction). f_n = f n is the
/// normal force, f_t = |f - f_n n| the tangential one, both of single sphere contacts.
class ContactForceSample {
 public:
  /// @throws DataError when the bin's width is not positive, or a friction coefficient negative.
  explicit ContactForceSample(const ContactForceOptions& options);
  /// `bodies`: the frame of the bodies' dump with all particles (column `id`), if there is one.
  /// @throws DataError when a column is missing, n is not a unit vector, `bodies` is of another
  ///   timestep or lacks a particle; TooFewParticles when there are no contacts.
  void add(const Frame& contacts, const Frame* bodies = nullptr);
  /// @throws TooFewParticles when no contact carries a force.
  ContactForces result() const;
  /// Unit normals n of the contacts that are measured, and their normal forces, N, in one order.
  const std::vector<Vector3>& normals() const { return normals_; }
  const std::vector<double>& normal_forces() const { return normal_; }

 private:
  struct Neighbours;
  void add_forces(const Frame& contacts);
  void add_coordination(const Frame& contacts, const Frame* bodies);

  ContactForceOptions options_;
  std::vector<double> normal_, tangential_;    // N, carrying contacts
  std::vector<FrictionalContact> frictional_;  // the same, where friction is known
  std::vector<Vector3> normals_;
  std::size_t not_carrying_ = 0, at_walls_ = 0;
  std::map<std::size_t, double> with_touching_, with_contacts_;  // particles by number
  std::size_t particles_ = 0, rattlers_ = 0;
  bool all_particles_known_ = true;
};

/// Measures one frame. @throws as ContactForceSample.
ContactForces measure_contact_forces(const Frame& contacts, const Frame* bodies,
                                     const ContactForceOptions& options);

/// Writes CSV tables: `stem`.csv with the columns f_over_mean, then count, density and standard
/// error of the normal and of the tangential force; `stem`_friction.csv if mu is known, and
/// `stem`_friction_types.csv where it differs; `stem`_coordination.csv. Returns the name of the
/// last but one, or nothing.
std::string write_contact_force_tables(const ContactForces& forces, const std::string& stem);
}  // namespace rodpack

#endif
