// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef FIX_CLASS
// clang-format off
FixStyle(check/timestep/multisphere,FixCheckTimestepMultisphere)
// clang-format on
#else
#ifndef RODPACK_FIX_CHECK_TIMESTEP_MULTISPHERE_H
#define RODPACK_FIX_CHECK_TIMESTEP_MULTISPHERE_H

#include <vector>

#include "contact_recorder.h"
#include "fix.h"
#include "multistep_options.h"
#include "rodpack/contact/contact_network.h"

namespace LAMMPS_NS {

/// fix check/timestep/multisphere: compares the time step with the stability limit of the
/// integrator that runs, for the contacts that are there. Its scalar, and the first component of
/// its vector, is the time step over the limit; the others are the steps that a collision takes and
/// the number of contacts of the stiffest particle.
class FixCheckTimestepMultisphere : public Fix {
 public:
  FixCheckTimestepMultisphere(class LAMMPS*, int, char**);
  int setmask() override;
  void init() override;
  void setup(int) override;
  void end_of_step() override;
  double compute_scalar() override { return fraction_; }
  double compute_vector(int n) override;

 private:
  struct Limit {
    double timestep;   // s
    double stiffness;  // square of the highest frequency, 1/s^2
    int particle;      // id of the stiffest one; 0: the single contact of the lightest one
    int contacts;      // of the stiffest one
  };
  struct IdentifiedBody {
    int id;
    rodpack::NetworkBody body;
  };

  void check();
  double dashpot_share() const;
  double property(const char* name, int i, int j) const;
  double scalar_property(const char* name) const;
  int groups_of(const char* of_style) const;
  double lightest_mass() const;
  Limit limit_of_single_contact(double mass);
  std::vector<rodpack::NetworkContact> contacts_here(const class ParticleIdentity& particles);
  void add_rolling(const ContactRecord& record, rodpack::NetworkContact& contact) const;
  std::vector<IdentifiedBody> bodies_here(const class ParticleIdentity& particles) const;
  Limit limit_of_contacts();
  void report(const Limit& limit);

  MultistepOptions options_;
  ContactRecorder recorder_;
  double warn_;  // fraction
  bool error_;
  double warned_;            // fraction of the last warning of this run
  int order_;                // of the integrator that runs, 0: velocity Verlet
  double relaxation_ = 0.0;  // of all dashpots, s; 0: none

  bool single_contact_;  // is known by its properties, whatever the contacts that are there
  double shortest_;      // half a period of the contacts of this rank, s

  double fraction_, steps_per_collision_;
  int contacts_;
};

}  // namespace LAMMPS_NS

#endif
#endif
