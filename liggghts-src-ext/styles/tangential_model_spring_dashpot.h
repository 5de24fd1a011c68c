// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef TANGENTIAL_MODEL
// clang-format off
TANGENTIAL_MODEL(TANGENTIAL_SPRING_DASHPOT,spring_dashpot,41)
// clang-format on
#else
#ifndef TANGENTIAL_MODEL_SPRING_DASHPOT_H_
#define TANGENTIAL_MODEL_SPRING_DASHPOT_H_

#include <algorithm>
#include <cmath>
#include <string>
#include "contact_events.h"
#include "contact_models.h"
#include "contact_recorder.h"
#include "error.h"
#include "fix.h"
#include "global_properties.h"
#include "modify.h"
#include "normal_model_spring_dashpot.h"
#include "rodpack/friction_step.h"
#include "rodpack/multistep.h"
#include "tangential_model_base.h"
#include "update.h"

namespace LIGGGHTS {
namespace ContactModels {

using rodpack::ForceChange;
using rodpack::FrictionForce;
using rodpack::FrictionStep;

// Spring and dashpot in the plane of contact, capped at mu times the elastic normal force (Lu et
// al., Granular Matter 18:34, 2016, section 2; the formula is rodpack::tangential_force). The
// spring is the integral of the tangential velocity over the life of the contact, by the multistep
// formula of the integrator that runs.
//
// History of a contact: spring (3), the last N tangential velocities, newest first (3 N), number of
// velocities known (negative while sliding), step of the last update, time between touch and the
// end of its step. Vectors change sign when the partners swap, so their flag is "1".
template <>
class TangentialModel<TANGENTIAL_SPRING_DASHPOT> : public TangentialModelBase {
 public:
  TangentialModel(LAMMPS* lmp, IContactHistorySetup* hsetup, ContactModelBase* c)
      : TangentialModelBase(lmp, hsetup, c),
        friction_(NULL),
        slots_setting_(3.0),
        slots_(0),
        offset_(-1),
        order_(0),
        events_(NULL) {}

  void registerSettings(Settings& settings) {
    settings.registerDoubleSetting("multistepOrder", slots_setting_, 3.0);
  }

  void postSettings(IContactHistorySetup* hsetup, ContactModelBase*) {
    slots_ = static_cast<int>(slots_setting_);
    if (slots_ != slots_setting_ || slots_ < 1 || slots_ > rodpack::max_multistep_order) {
      const std::string text = "tangential spring_dashpot: multistepOrder is " +
                               std::to_string(slots_setting_) + ", expected 1, 2, 3 or 4";
      error->all(FLERR, text.c_str());
    }
    for (int value = 0; value < 3 * (slots_ + 1); ++value) {
      const int index = hsetup->add_history_value("spring_dashpot_" + std::to_string(value), "1");
      if (value == 0) offset_ = index;
    }
    hsetup->add_history_value("spring_dashpot_count", "0");
    hsetup->add_history_value("spring_dashpot_step", "0");
    hsetup->add_history_value("spring_dashpot_since", "0");
    hsetup->add_history_value("spring_dashpot_friction", "0");
    hsetup->add_history_value("spring_dashpot_kt", "0");
    hsetup->add_history_value("spring_dashpot_damping", "0");
  }

  void connectToProperties(PropertyRegistry& registry) {
    if (offset_ < 0)
      error->all(FLERR,
                 "tangential spring_dashpot: repeat the pair_style command after read_restart");
    registry.registerProperty("coeffFrict", &MODEL_PARAMS::createCoeffFrict);
    registry.connect("coeffFrict", friction_, "tangential_model spring_dashpot");
    check_type_pairs(error, registry.max_type(), friction_, "coefficientFriction", false, 1e300,
                     "a coefficient >= 0");
    order_ = running_order();
    events_ = followed_events();
    if (order_ > slots_) {
      const std::string order = std::to_string(order_);
      const std::string text = "tangential spring_dashpot: the integrator that runs is of order " +
                               order + ", but the contact history is made for multistepOrder " +
                               std::to_string(slots_) + ": append 'multistepOrder " + order +
                               "' to pair_style gran and every fix wall/gran";
      error->all(FLERR, text.c_str());
    }
  }

  void surfacesIntersect(const SurfacesIntersectData& sidata, ForceData& i_forces,
                         ForceData& j_forces) {
    if (sidata.contact_flags) *sidata.contact_flags |= CONTACT_TANGENTIAL_MODEL;
    double* const history = &sidata.contact_history[offset_];
    const bool renewed =
        sidata.computeflag && (sidata.shearupdate || missed_update_at_setup(history));
    Past past;
    if (renewed) past = advance(sidata, history);

    const double velocity[3] = {sidata.vtr1, sidata.vtr2, sidata.vtr3};
    double spring[3] = {history[0], history[1], history[2]};
    double tangential[3];
    const double friction = friction_[sidata.itype][sidata.jtype] * sidata.kn;
    bool sliding = count(history) < 0.0 && sidata.kt > 0.0;
    FrictionForce law;
    law.changed = false;
    if (renewed && events_ && past.alive && sidata.gammat > 0.0 &&
        may_change_branch(sidata, past, spring, velocity, friction * sidata.deltan)) {
      law = follow_through_step(sidata, past, history, friction, update->dt, spring);
      std::copy(law.force, law.force + 3, tangential);
      sliding = law.slides;
    } else if (renewed || !sliding) {
      sliding = rodpack::tangential_force(sidata.kt, sidata.gammat,
                                          std::max(friction * sidata.deltan, 0.0), spring, velocity,
                                          tangential);
    }
    // A sliding contact's spring alone carries the force: taken from it, the force is the same when
    // it is evaluated again in the same step.
    if (sliding && sidata.kt > 0.0)
      for (int d = 0; d < 3; ++d) tangential[d] = -sidata.kt * spring[d];
    if (renewed) {
      std::copy(spring, spring + 3, history);
      if (sliding) count(history) = -count(history);
      double* const kept = constants(history);
      kept[0] = friction;
      kept[1] = sidata.kt;
      kept[2] = sidata.gammat;
      if (ContactEvents* events = ContactEvents::armed())
        report(sidata, past, law, tangential, sliding, *events);
    }
    apply(sidata, tangential, i_forces, j_forces);
    if (ContactRecorder* recorder = ContactRecorder::armed())
      recorder->add_tangential(spring, sidata.kt, i_forces);
  }

  void surfacesClose(SurfacesCloseData& scdata, ForceData&, ForceData&) {
    if (scdata.contact_flags) *scdata.contact_flags &= ~CONTACT_TANGENTIAL_MODEL;
    if (!scdata.contact_history) return;
    double* const history = &scdata.contact_history[offset_];
    if (count(history) == 0.0) return;
    ContactEvents* const events = ContactEvents::armed();
    if (events && step(history) == static_cast<double>(update->ntimestep) - 1.0)
      report_end(events->as_if_in_contact(scdata), history, *events);
    std::fill_n(history, 3 * (slots_ + 1) + 6, 0.0);
  }
  void beginPass(SurfacesIntersectData&, ForceData&, ForceData&) {}
  void endPass(SurfacesIntersectData&, ForceData&, ForceData&) {}

 private:
  double& count(double* history) const { return history[3 * (slots_ + 1)]; }
  double& step(double* history) const { return history[3 * (slots_ + 1) + 1]; }
  double& since(double* history) const { return history[3 * (slots_ + 1) + 2]; }
  double* constants(double* history) const { return history + 3 * (slots_ + 1) + 3; }

  /// Order of the multistep integrator among the fixes, 0 if none: velocity Verlet.
  int running_order() const {
    int order = 0;
    for (int i = 0; i < modify->nfix; ++i) {
      int dim = 0;
      const int* found = static_cast<int*>(modify->fix[i]->extract("multistep_order", dim));
      if (!found) continue;
      if (order != 0 && order != *found)
        error->all(FLERR,
                   "tangential spring_dashpot: all multistep integrators need the same order");
      order = *found;
    }
    return order;
  }

  /// The events that the integrator follows, null if it follows none.
  ContactEvents* followed_events() const {
    int dim = 0;
    for (int i = 0; i < modify->nfix; ++i)
      if (void* found = modify->fix[i]->extract("contact_events", dim))
        return static_cast<ContactEvents*>(found);
    return NULL;
  }

  /// Whether a contact still needs the update of this step when a run is set up. It does after
  /// `restart N`, which saves the contacts of pairs as they were before the forces of its step.
  bool missed_update_at_setup(double* history) const {
    const double now = static_cast<double>(update->ntimestep);
    if (count(history) == 0.0 || step(history) == now - 1.0) return true;
    // The neighbour lists are new, so whatever has history is touching: it lives on even where the
    // time step was reset.
    step(history) = now;
    return false;
  }

  /// What a contact was at the last evaluation, turned into the present plane of contact.
  struct Past {
    bool alive = false, fresh = false, sliding = false;  // fresh: that evaluation was its first
    int known = 0;       // velocities in the history, that of now included, at most 3
    double since = 0.0;  // touch, in the step that it or the last evaluation made, s
    bool moved = false;  // whether events changed the motion of its bodies in the last step, to:
    ContactEvents::Motion change;
    double spring[3] = {0.0, 0.0, 0.0}, velocity[3] = {0.0, 0.0, 0.0};
  };

  /// Brings the spring from the last step to this one and stores this step's velocity.
  Past advance(const SurfacesIntersectData& sidata, double* history) const {
    const double now = static_cast<double>(update->ntimestep);
    const double dt = update->dt;
    const double velocity[3] = {sidata.vtr1, sidata.vtr2, sidata.vtr3};
    double* const newest = history + 3;

    // LIGGGHTS tells a model of a separation only if the spheres are still close then. A contact
    // that was not updated in the last step is a new one, whatever is in its history.
    Past past;
    past.alive = count(history) != 0.0 && step(history) == now - 1.0;
    step(history) = now;
    if (!past.alive) {
      past.since = since(history) = start_spring(sidata, dt, history);
      if (!ContactEvents::touched_in_step(sidata, dt)) past.since = since(history) = 0.0;
      std::fill_n(newest, 3 * slots_, 0.0);
      std::copy(velocity, velocity + 3, newest);
      count(history) = 1.0;
      return past;
    }

    const int known = static_cast<int>(std::fabs(count(history)));
    past.fresh = known == 1;
    past.since = since(history);
    past.known = std::min({known + 1, slots_, 3});
    past.sliding = count(history) < 0.0;
    turn_with_contact(sidata.en, history);
    if (order_ == 0) {
      // Velocity Verlet shows the velocity at half the step, where the midpoint rule wants it.
      for (int d = 0; d < 3; ++d) history[d] += dt * velocity[d];
      std::copy(velocity, velocity + 3, newest);
      count(history) = 1.0;
      return past;
    }
    const rodpack::MultistepWeights& weights = rodpack::multistep_weights(order_, known);
    for (int k = 0; k < slots_; ++k) turn_with_contact(sidata.en, newest + 3 * k);
    if (events_) {
      past.moved = events_->motion_changed(sidata, past.change);
      if (past.moved) follow_bodies(sidata.en, known, past.change, history);
    }
    std::copy(history, history + 3, past.spring);
    std::copy(newest, newest + 3, past.velocity);
    for (int d = 0; d < 3; ++d)
      history[d] += rodpack::multistep_increment(weights, order_, dt,
                                                 [&](int k) { return newest[3 * k + d]; });
    std::copy_backward(newest, newest + 3 * (slots_ - 1), newest + 3 * slots_);
    std::copy(velocity, velocity + 3, newest);
    count(history) = std::min(known, slots_) + 1.0;
    return past;
  }

  /// The life of a contact begins within a step, when the gap closes: sets the integral of the
  /// tangential velocity from then on, with the velocities taken as constant. Returns the time
  /// since.
  static double start_spring(const SurfacesIntersectData& sidata, double dt, double* spring) {
    const double now[3] = {sidata.vtr1, sidata.vtr2, sidata.vtr3};
    if (sidata.is_wall) {
      const double since_touch = sidata.vn < 0.0 ? std::min(dt, -sidata.deltan / sidata.vn) : 0.0;
      for (int d = 0; d < 3; ++d) spring[d] = since_touch * now[d];
      return since_touch;
    }
    double velocity[3];
    vectorSubtract3D(sidata.v_i, sidata.v_j, velocity);
    // |delta - t velocity| = r_i + r_j
    const double approach = vectorDot3D(sidata.delta, velocity);
    const double closed = sidata.radsum * sidata.radsum - sidata.rsq;
    const double root = std::sqrt(approach * approach + vectorMag3DSquared(velocity) * closed);
    const double since_touch = root > approach ? std::min(dt, closed / (root - approach)) : 0.0;

    double normal[3], roll[3], spin[3], at_touch[3];
    for (int d = 0; d < 3; ++d) {
      normal[d] = sidata.delta[d] - since_touch * velocity[d];
      spin[d] = sidata.radi * sidata.omega_i[d] + sidata.radj * sidata.omega_j[d];
    }
    vectorNormalize3D(normal);
    vectorCross3D(spin, normal, roll);
    const double closing = vectorDot3D(velocity, normal);
    for (int d = 0; d < 3; ++d) at_touch[d] = velocity[d] - closing * normal[d] - roll[d];
    turn_with_contact(sidata.en, at_touch);
    for (int d = 0; d < 3; ++d) spring[d] = 0.5 * since_touch * (at_touch[d] + now[d]);
    return since_touch;
  }

  /// Whether a contact that lives on is not simply stuck, before and now.
  static bool may_change_branch(const SurfacesIntersectData& contact, const Past& past,
                                const double (&spring)[3], const double (&velocity)[3],
                                double cap) {
    if (past.sliding) return true;
    double squared = 0.0;
    for (int d = 0; d < 3; ++d) {
      const double component = contact.kt * spring[d] + contact.gammat * velocity[d];
      squared += component * component;
    }
    return squared > cap * cap;
  }

  /// `friction`: mu k_n. Sets the spring.
  static FrictionForce follow_through_step(const SurfacesIntersectData& contact, const Past& past,
                                           const double* history, double friction, double dt,
                                           double (&spring)[3]) {
    FrictionStep step;
    step.stiffness = contact.kt;
    step.damping = contact.gammat;
    step.cap = friction * contact.deltan;
    step.cap_rate = -friction * contact.vn;
    step.dt = dt;
    step.known = past.known;
    step.slid = past.sliding;
    std::copy(past.spring, past.spring + 3, step.spring_before);
    for (int k = 0; k < past.known; ++k)
      std::copy(history + 3 * (k + 1), history + 3 * (k + 2), step.velocity[k]);
    return rodpack::friction_force(step, spring);
  }

  /// Puts into the spring and the velocities of the past what an event in the last step, which they
  /// could not know of, did to the bodies.
  void follow_bodies(const double* en, int known, ContactEvents::Motion& change,
                     double* history) const {
    in_plane(en, change.acceleration);
    in_plane(en, change.velocity);
    in_plane(en, change.displacement);
    for (int d = 0; d < 3; ++d) {
      history[d] += change.displacement[d];
      for (int k = 0; k < std::min(known, slots_); ++k)
        history[3 * (k + 1) + d] += change.velocity[d] - k * update->dt * change.acceleration[d];
    }
  }

  /// Reports the events of a contact under `force`.
  void report(const SurfacesIntersectData& contact, const Past& past, const FrictionForce& law,
              const double (&force)[3], bool sliding, ContactEvents& events) const {
    if (past.alive && !law.changed && (sliding || past.sliding || !past.moved)) return;
    const double dt = update->dt, kt = contact.kt, gamma = contact.gammat;
    double now[3], rate[3];
    if (!past.alive) {
      if (!(past.since > 0.0)) return;
      const double velocity[3] = {contact.vtr1, contact.vtr2, contact.vtr3};
      for (int d = 0; d < 3; ++d) rate[d] = sliding ? force[d] / past.since : -kt * velocity[d];
      events.add(contact, force, rate, past.since, !sliding && gamma > 0.0);
      return;
    }
    if (law.changed) {
      if (law.since > 0.0) events.add(contact, law.gain, law.gain_rate, law.since, law.jumps);
      return;
    }
    const ContactEvents::Motion& change = past.change;
    ForceChange of_dashpot = rodpack::dashpot_change(gamma, change.acceleration, change.velocity,
                                                     change.displacement, dt);
    events.add(contact, of_dashpot);
    if (!past.fresh) return;
    // Two evaluations after touch give the rate that was guessed at touch, as constant since then.
    ForceChange missed;
    const double since = past.since;
    for (int d = 0; d < 3; ++d) {
      const double at_touch = -(kt * past.spring[d] + gamma * past.velocity[d]);
      const double applied =
          -kt * (past.velocity[d] - change.velocity[d]) - gamma * change.acceleration[d];
      missed.rate[d] = (force[d] - at_touch) / dt - applied;
      missed.now[d] = missed.rate[d] * dt;
      missed.impulse[d] = 0.5 * missed.rate[d] * (dt * dt - since * since);
      missed.sweep[d] =
          missed.rate[d] * (dt * dt * dt / 6.0 - since * since * (0.5 * dt + since / 3.0));
    }
    events.add(contact, missed, true);
  }

  /// Reports that a contact has opened within the step: `contact` goes on with negative overlap.
  void report_end(const SurfacesIntersectData& contact, double* history,
                  ContactEvents& events) const {
    const double dt = update->dt;
    if (!(contact.vn > 0.0)) return;
    const double since = std::min(dt, -contact.deltan / contact.vn);
    const double friction = constants(history)[0], kt = constants(history)[1];
    const double gamma = constants(history)[2];
    double now[3], rate[3];
    if (count(history) < 0.0) {
      // A sliding contact's force has fallen to zero with the cap, which would go on below it.
      turn_with_contact(contact.en, history);
      const double length = vectorMag3D(history);
      if (!(length > 0.0)) return;
      for (int d = 0; d < 3; ++d) {
        const double direction = -history[d] / length;
        now[d] = -friction * contact.deltan * direction;
        rate[d] = friction * contact.vn * direction;
      }
      events.add(contact, now, rate, since);
      return;
    }
    const Past past = advance(contact, history);
    const double velocity[3] = {contact.vtr1, contact.vtr2, contact.vtr3};
    for (int d = 0; d < 3; ++d) {
      now[d] = kt * history[d] + gamma * velocity[d];
      rate[d] = (now[d] - kt * past.spring[d] - gamma * past.velocity[d]) / dt;
    }
    events.add(contact, now, rate, since, true);
  }

  static void in_plane(const double* en, double (&vector)[3]) {
    const double normal = vectorDot3D(vector, en);
    for (int d = 0; d < 3; ++d) vector[d] -= normal * en[d];
  }

  /// Turns a vector of the former plane of contact into the present one, of normal `en`, by
  /// projection and a return to its length: projection alone would shrink it at first order in dt.
  static void turn_with_contact(const double* en, double* vector) {
    const double before = vectorMag3DSquared(vector);
    if (before == 0.0) return;
    const double normal = vectorDot3D(vector, en);
    for (int d = 0; d < 3; ++d) vector[d] -= normal * en[d];
    const double after = vectorMag3DSquared(vector);
    if (after == 0.0) return;
    vectorScalarMult3D(vector, std::sqrt(before / after));
  }

  static void apply(const SurfacesIntersectData& sidata, const double (&tangential)[3],
                    ForceData& i_forces, ForceData& j_forces) {
    const double share = sidata.is_wall ? sidata.area_ratio : 1.0;
    double moment[3];  // en x F_t; both surfaces lie against the normal from j to i
    vectorCross3D(sidata.en, tangential, moment);
    for (int d = 0; d < 3; ++d) {
      i_forces.delta_F[d] += share * tangential[d];
      i_forces.delta_torque[d] -= share * sidata.cri * moment[d];
      if (sidata.is_wall) continue;
      j_forces.delta_F[d] -= tangential[d];
      j_forces.delta_torque[d] -= sidata.crj * moment[d];
    }
  }

  double** friction_;      // mu per type pair
  double slots_setting_;   // as read; Settings knows only doubles
  int slots_;              // N: velocities held per contact
  int offset_;             // of the spring in a contact's history
  int order_;              // of the integrator that runs, 0: velocity Verlet
  ContactEvents* events_;  // that the integrator follows, or null
};

}  // namespace ContactModels
}  // namespace LIGGGHTS

#endif
#endif
