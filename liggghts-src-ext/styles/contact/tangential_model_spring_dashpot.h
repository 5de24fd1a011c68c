// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef TANGENTIAL_MODEL
// clang-format off
TANGENTIAL_MODEL(TANGENTIAL_SPRING_DASHPOT,spring_dashpot,41)
// clang-format on
#else
#ifndef TANGENTIAL_MODEL_SPRING_DASHPOT_H_
#define TANGENTIAL_MODEL_SPRING_DASHPOT_H_

#include <algorithm>
#include <string>
#include "contact_events.h"
#include "contact_models.h"
#include "contact_recorder.h"
#include "fix.h"
#include "global_properties.h"
#include "input.h"
#include "modify.h"
#include "normal_model_spring_dashpot.h"
#include "rodpack/motion/multistep.h"
#include "rodpack/contact/tangential_history.h"
#include "running_dashpots.h"
#include "stop_run.h"
#include "style_arguments.h"
#include "tangential_model_base.h"
#include "update.h"

namespace LIGGGHTS {
namespace ContactModels {

using rodpack::TangentialHistory;

// Spring and dashpot in the plane of contact, capped at mu times the elastic normal force (Lu et
// al., Granular Matter 18:34, 2016, section 2; the formula is rodpack::tangential_force) or, with
// totalForceCap, at mu times the whole one (rodpack/contact/friction_cap.h). The spring is the
// integral of the tangential velocity over the life of the contact, by the multistep formula of the
// integrator that runs.
//
// The history of a contact is stored as rodpack/contact/contact_history.h has it. Vectors change
// sign when the partners swap, so their flag is "1".
template <>
class TangentialModel<TANGENTIAL_SPRING_DASHPOT> : public TangentialModelBase {
 public:
  TangentialModel(LAMMPS* lmp, IContactHistorySetup* hsetup, ContactModelBase* c)
      : TangentialModelBase(lmp, hsetup, c),
        friction_(NULL),
        slots_setting_(3.0),
        slots_(0),
        offset_(-1),
        total_cap_(false),
        cap_offset_(-1),
        order_(0),
        events_(NULL) {
    ContactEvents::ask_for_ends();
  }

  void registerSettings(Settings& settings) {
    settings.registerDoubleSetting("multistepOrder", slots_setting_, 3.0);
    settings.registerOnOff("totalForceCap", total_cap_, false);
    // Settings would take any word for a number, and read on where there is none.
    StyleArguments order(lmp, "tangential spring_dashpot", input->narg, input->arg, 0);
    if (order.find("multistepOrder") >= 0)
      order.integer("multistepOrder", "a whole number in [1, 4]");
    StyleArguments cap(lmp, "tangential spring_dashpot", input->narg, input->arg, 0);
    if (cap.find("totalForceCap") >= 0) cap.choice("totalForceCap", {"off", "on"});
  }

  void postSettings(IContactHistorySetup* hsetup, ContactModelBase* model) {
    slots_ = static_cast<int>(slots_setting_);
    for (int value = 0; value < 3 * (slots_ + 1); ++value) {
      const int index = hsetup->add_history_value("spring_dashpot_" + std::to_string(value), "1");
      if (value == 0) offset_ = index;
    }
    model->add_history_offset("tangential_spring", offset_);
    hsetup->add_history_value("spring_dashpot_count", "0");
    hsetup->add_history_value("spring_dashpot_step", "0");
    hsetup->add_history_value("spring_dashpot_since", "0");
    hsetup->add_history_value("spring_dashpot_friction", "0");
    hsetup->add_history_value("spring_dashpot_kt", "0");
    hsetup->add_history_value("spring_dashpot_damping", "0");
    // They also tell the restart files of the two caps apart.
    for (int value = 0; total_cap_ && value < rodpack::stored_cap_values; ++value) {
      const int index =
          hsetup->add_history_value("spring_dashpot_cap_" + std::to_string(value), "0");
      if (value == 0) cap_offset_ = index;
    }
  }

  void connectToProperties(PropertyRegistry& registry) {
    if (offset_ < 0)
      stop_run(lmp, "tangential spring_dashpot: repeat the pair_style command after read_restart");
    registry.registerProperty("coeffFrict", &MODEL_PARAMS::createCoeffFrict);
    registry.connect("coeffFrict", friction_, "tangential_model spring_dashpot");
    check_type_pairs(lmp, registry.max_type(), friction_, "coefficientFriction",
                     "a coefficient in [0, 1e15]");
    order_ = highest_running_order(lmp);
    for (const int order : running_orders(lmp))
      if (order != order_)
        stop_run(lmp, "tangential spring_dashpot: all multistep integrators need the same order");
    dashpots_.connect(lmp);
    events_ = followed_events();
    if (order_ > slots_) {
      const std::string order = std::to_string(order_);
      stop_run(lmp, "tangential spring_dashpot: the integrator that runs is of order " + order +
                        ", but the contact history is made for multistepOrder " +
                        std::to_string(slots_) + ": append 'multistepOrder " + order +
                        "' to pair_style gran and every fix wall/gran");
    }
  }

  void surfacesIntersect(const SurfacesIntersectData& sidata, ForceData& i_forces,
                         ForceData& j_forces) {
    if (sidata.contact_flags) *sidata.contact_flags |= CONTACT_TANGENTIAL_MODEL;
    TangentialHistory history = unpacked(sidata.contact_history);
    const bool renewed =
        sidata.computeflag && (sidata.shearupdate || missed_update_at_setup(history));
    const double mu = friction_[sidata.itype][sidata.jtype];
    const rodpack::TangentialForce tangential =
        total_cap_ ? under_total_cap(sidata, mu, history, renewed)
                   : rodpack::tangential_contact_force(
                         sidata, history, rodpack::ElasticCap{mu * sidata.kn}, renewed, this_step(),
                         events_, ContactEvents::armed());
    if (sidata.computeflag) rodpack::pack(history, sidata.contact_history + offset_);
    apply(sidata, tangential.force, i_forces, j_forces);
    if (ContactRecorder* recorder = ContactRecorder::armed())
      recorder->add_tangential(tangential.spring, sidata.kt, i_forces);
  }

  void surfacesClose(SurfacesCloseData& scdata, ForceData&, ForceData&) {
    if (scdata.contact_flags) *scdata.contact_flags &= ~CONTACT_TANGENTIAL_MODEL;
    if (!scdata.contact_history) return;
    TangentialHistory history = unpacked(scdata.contact_history);
    if (history.known == 0) return;
    ContactEvents* const events = ContactEvents::armed();
    if (events && history.step == update->ntimestep - 1) report_end(scdata, history, *events);
    rodpack::pack(TangentialHistory(slots_), scdata.contact_history + offset_);
    if (total_cap_) rodpack::pack(rodpack::CapHistory(), scdata.contact_history + cap_offset_);
  }
  void beginPass(SurfacesIntersectData&, ForceData&, ForceData&) {}
  void endPass(SurfacesIntersectData&, ForceData&, ForceData&) {}

 private:
  TangentialHistory unpacked(const double* contact_history) const {
    return rodpack::unpack_tangential(contact_history + offset_, slots_);
  }

  rodpack::TangentialForce under_total_cap(const SurfacesIntersectData& sidata, double mu,
                                           TangentialHistory& history, bool renewed) const {
    double* const stored = sidata.contact_history + cap_offset_;
    rodpack::CapHistory memory = rodpack::unpack_cap(stored);
    // The force that the models along the normal have set, and how far below 0 it would be.
    const double viscoelastic =
        sidata.Fn > 0.0
            ? sidata.Fn
            : std::min(sidata.Fn, rodpack::viscoelastic_force(sidata.kn, sidata.deltan,
                                                              sidata.gamman, sidata.vn));
    const rodpack::TangentialForce result = rodpack::tangential_contact_force(
        sidata, history, rodpack::TotalCap(mu, viscoelastic, memory), renewed, this_step(), events_,
        ContactEvents::armed());
    if (sidata.computeflag) rodpack::pack(memory, stored);
    return result;
  }

  /// Reports the end of a contact that has opened within the step.
  void report_end(const SurfacesCloseData& scdata, TangentialHistory& history,
                  ContactEvents& events) const {
    SurfacesIntersectData contact = events.as_if_in_contact(scdata);
    if (total_cap_) {
      rodpack::CapHistory cap = rodpack::unpack_cap(scdata.contact_history + cap_offset_);
      contact.kn = cap.stiffness;
      contact.gamman = cap.damping;
      rodpack::end_tangential_force(contact, history, rodpack::TotalCap(history.friction, 0.0, cap),
                                    this_step(), events);
    } else {
      rodpack::end_tangential_force(contact, history, rodpack::ElasticCap{history.friction},
                                    this_step(), events);
    }
  }

  rodpack::TangentialStep this_step() const {
    return rodpack::TangentialStep{order_, update->ntimestep, update->dt,
                                   dashpots_.kept(update->dt)};
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
  bool missed_update_at_setup(TangentialHistory& history) const {
    if (history.known == 0 || history.step == update->ntimestep - 1) return true;
    // The neighbour lists are new, so whatever has history is touching: it lives on even where the
    // time step was reset.
    history.step = update->ntimestep;
    return false;
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
  bool total_cap_;         // whether the cap is that of the whole normal force
  int cap_offset_;         // of what that cap remembers
  int order_;              // of the integrator that runs, 0: velocity Verlet
  ContactEvents* events_;  // that the integrator follows, or null
  RunningDashpots dashpots_;
};

}  // namespace ContactModels
}  // namespace LIGGGHTS

#endif
#endif
