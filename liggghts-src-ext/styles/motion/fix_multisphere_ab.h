// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef FIX_CLASS

// clang-format off
FixStyle(multisphere/ab,FixMultisphereAB)
// clang-format on

#else

#ifndef RODPACK_FIX_MULTISPHERE_AB_H
#define RODPACK_FIX_MULTISPHERE_AB_H

#include <algorithm>
#include <memory>
#include <vector>

#include "contact_counts.h"
#include "contact_events.h"
#include "fix_multisphere.h"
#include "multistep_options.h"

namespace rodpack {
struct PlanarBody;
struct PlanarRates;
}  // namespace rodpack

namespace LAMMPS_NS {

/// Rigid bodies advanced by Adams-Bashforth steps of order 1 to 4, or of order 0 by leapfrog, in
/// place of velocity Verlet.
///
/// The whole step, velocities and positions, is made in initial_integrate from the rates now and at
/// the steps before; forces then see positions and velocities of the same time. The rates of the
/// past live in per-body properties, which migrate with the body and enter restarts by themselves.
class FixMultisphereAB : public FixMultisphere {
 public:
  FixMultisphereAB(class LAMMPS*, int, char**);

  void post_create() override;
  void init() override;
  void pre_neighbor() override;
  void setup_pre_neighbor() override;
  void initial_integrate(int) override;
  void setup(int) override;
  void pre_force(int) override;
  void final_integrate() override;
  void reset_dt() override;
  void restart(char*) override;

  using FixMultisphere::extract;
  /// Tells contact models the "multistep_order", an int*, and the "contact_events", a
  /// ContactEvents*, which is null unless events are followed.
  void* extract(const char*, int&) override;

  /// Whether a fix move/multisphere moves the body.
  bool is_prescribed(int body) const { return (*prescribed_)(body) != 0; }
  /// Sets the bodies free that this fix moves, which is about to end.
  void set_free(const class FixMoveMultisphere* mover);

  /// By how much the inertia of the body is larger at present than its mass says
  /// (rodpack/motion/mass_scaling.h); 1 without mass scaling.
  double inertia_factor(int body) const;

  // The planar engine takes bodies over and gives them back (fix_multisphere_ab_planar.cpp).
  int order() const { return order_; }
  bool planar() const { return planar_; }
  double mass_scaling() const { return mass_scaling_; }  // 0: none
  bool follows_events() const { return events_ != NULL; }
  rodpack::PlanarBody to_planar(int body, const std::vector<int>& atoms);
  void begin_planar();
  void from_planar(int body, const std::vector<int>& atoms, const rodpack::PlanarBody& planar);
  void finish_planar();
  // Bodies do not take the forces of this step along to another rank by themselves.
  void keep_loads();
  void restore_loads();

 private:
  // A record of a body has as many values as rodpack::PlanarRates, or rodpack::SpatialRates.
  typedef VectorContainer<double, 6> PlanarRecord;
  typedef VectorContainer<double, 13> SpatialRecord;

  // What events of the last step have changed. It waits for the next step, so that bodies, spheres
  // and forces of a step, and of a restart file, belong together.
  struct MissedMotion {
    double displacement[3];      // m
    double rotation[3];          // rad
    double velocity[3];          // m/s
    double angular_momentum[3];  // kg m^2/s
  };
  typedef VectorContainer<double, 12> StoredMissedMotion;

  void parse(int narg, char** arg);
  void add_history();
  template <class Record>
  void add_records(std::vector<Record*>& past);
  template <class Record, class Rates, class Birth>
  void update_history(const std::vector<Record*>& past, int body, Rates* history,
                      Birth fill_before_birth);

  int records() const { return std::max(1, order_); }  // of rates that a step needs
  int layout() const;
  static int history_size(int layout);
  void restart_history_after_change();
  void require_planar(int body);
  void require_inertia(int body);
  [[noreturn]] void body_error(int body, const char* what);
  double moment_about_z(int body) const;
  void advance_planar(int body);
  void advance_spatial(int body);
  void set_axes_planar(int body);
  void move_planar(int body);
  void move_spatial(int body);
  rodpack::PlanarRates* planar_record(int body, int age);
  void read_jump(const std::vector<int>& atoms, rodpack::PlanarBody& planar);
  void publish_jump(int body, const std::vector<int>& atoms, const rodpack::PlanarBody& planar);

  void sum_contact_weights();

  // Bodies whose motion is prescribed (fix_multisphere_ab_prescribed.cpp).
  void find_prescribed();
  void prescribe(int body, int by);
  void move_prescribed(int body);

  // What events of contacts do to the bodies (fix_multisphere_ab_events.cpp).
  void apply_events();
  void sum_changes();
  rodpack::SpatialJump correct_planar(int body, const rodpack::BodyChange& sum);
  rodpack::SpatialJump correct_spatial(int body, const rodpack::BodyChange& sum);
  MissedMotion& missed_motion(int body) const;
  void keep_missed_motion(int body, const rodpack::SpatialJump& jump, const double* momentum);
  void publish(const std::vector<rodpack::SpatialJump>& jumps);

  MultistepOptions options_;
  int order_;  // 0: leapfrog
  bool planar_;
  std::unique_ptr<ContactEvents> events_;              // none with `events no` or below order 2
  double mass_scaling_ = 0.0;                          // S of mass_scaling.h; 0: none
  std::unique_ptr<ContactCounts> counts_;              // with mass scaling alone
  std::vector<int> changed_bodies_;                    // whose contacts had events in this step,
  std::vector<ContactEvents::SphereChanges> changes_;  // and the sum over these
  std::vector<int> place_;                             // of a body in both; -1: not there
  /// Values per body that the base class writes to a restart file ahead of ours.
  int stock_restart_size_;

  // The history of each body. The newest rates are not kept: they follow from the state.
  ScalarContainer<int>* layout_;       // what the records below hold; negative
  ScalarContainer<int>* evaluations_;  // force evaluations since birth, capped at records() + 1
  ScalarContainer<double>* timestep_;  // the rates are this far apart, s
  StoredMissedMotion* missed_motion_;
  std::vector<class FixMoveMultisphere*> movers_;  // NULL for one that has ended
  bool spheres_lag_ = false;          // whether spheres do not know velocities that were prescribed
  ScalarContainer<int>* prescribed_;  // which of these moves the body, counted from 1; 0: none
  VectorContainer<double, 3>* planar_load_;  // force x, y, torque z; while bodies change their rank
  ScalarContainer<double>* contact_weight_;  // of the present contacts; with mass scaling alone
  // Records of the past, oldest first. Short ones only with `planar yes`: with `planar auto` the
  // question is open until the run starts, and planar rates then fill the front of the long ones.
  std::vector<PlanarRecord*> past_planar_;
  std::vector<SpatialRecord*> past_spatial_;

  // The state of each body, which the base class keeps.
  typedef VectorContainer<double, 3> Vectors;
  ScalarContainer<double>& mass_;
  Vectors &xcm_, &vcm_, &fcm_, &torque_, &angmom_, &omega_, &inertia_, &ex_, &ey_, &ez_;
  VectorContainer<double, 4>& quat_;
  VectorContainer<bool, 3>&fflag_, &tflag_;
  ScalarContainer<int>& image_;
};

}  // namespace LAMMPS_NS

#endif
#endif
