// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef NORMAL_MODEL
// clang-format off
NORMAL_MODEL(SPRING_DASHPOT,spring_dashpot,41)
// clang-format on
#else
#ifndef NORMAL_MODEL_SPRING_DASHPOT_H_
#define NORMAL_MODEL_SPRING_DASHPOT_H_

#include <cstdio>
#include "contact_counts.h"
#include "contact_events.h"
#include "contact_models.h"
#include "contact_recorder.h"
#include "error.h"
#include "force.h"
#include "global_properties.h"
#include "normal_model_base.h"
#include "rodpack/contact/contact_history.h"
#include "rodpack/contact/contact_law.h"
#include "rodpack/contact/normal_history.h"
#include "running_dashpots.h"
#include "stop_run.h"
#include "style_arguments.h"
#include "update.h"

namespace LIGGGHTS {
namespace ContactModels {

// Inline, so that every translation unit registers the same function: the registry compares them.
inline MatrixProperty* create_damping_ratio_normal(PropertyRegistry& registry, const char* caller,
                                                   bool) {
  return MODEL_PARAMS::createPerTypePairProperty(registry, "dampingRatioNormal", caller);
}
inline MatrixProperty* create_damping_ratio_tangential(PropertyRegistry& registry,
                                                       const char* caller, bool) {
  return MODEL_PARAMS::createPerTypePairProperty(registry, "dampingRatioTangential", caller);
}

/// Stops unless the value for every pair of types lies in the interval that `expected` names.
inline void check_type_pairs(LAMMPS* lmp, int ntypes, double** values, const char* property,
                             const char* expected) {
  for (int i = 1; i <= ntypes; ++i) {
    for (int j = 1; j <= ntypes; ++j) {
      if (in_interval(values[i][j], expected)) continue;
      char text[256];
      std::snprintf(text, sizeof text,
                    "property/global %s is '%.15g' for types %d and %d, expected %s", property,
                    values[i][j], i, j, expected);
      stop_run(lmp, text);
    }
  }
}

// Linear spring and dashpot, F_n = max(0, k_n delta - 2 eta_n sqrt(m_ij k_n) v_n), of Lu et al.,
// Granular Matter 18:34 (2016), section 2; the formula is rodpack::normal_force. It also owns what
// the tangential models read: sidata.kt, sidata.gammat.
template <>
class NormalModel<SPRING_DASHPOT> : public NormalModelBase {
 public:
  NormalModel(LAMMPS* lmp, IContactHistorySetup* hsetup, ContactModelBase* c)
      : NormalModelBase(lmp, hsetup, c),
        // These labels stay for the sake of old restart files, in which they stand: "uncut" is the
        // viscoelastic force, "fresh" is set where the contact has just touched.
        offset_(hsetup->add_history_value("spring_dashpot_uncut", "0")),
        kn_(NULL),
        kt_(NULL),
        eta_n_(NULL),
        eta_t_(NULL) {
    hsetup->add_history_value("spring_dashpot_touch_rate", "0");
    hsetup->add_history_value("spring_dashpot_fresh", "0");
    hsetup->add_history_value("spring_dashpot_normal_step", "0");
  }

  void registerSettings(Settings&) {}
  void postSettings(IContactHistorySetup*, ContactModelBase*) {}

  void connectToProperties(PropertyRegistry& registry) {
    const char* caller = "model spring_dashpot";
    registry.registerProperty("k_n", &MODEL_PARAMS::createKn);
    registry.registerProperty("k_t", &MODEL_PARAMS::createKt);
    registry.registerProperty("dampingRatioNormal", &create_damping_ratio_normal);
    registry.registerProperty("dampingRatioTangential", &create_damping_ratio_tangential);
    registry.connect("k_n", kn_, caller);
    registry.connect("k_t", kt_, caller);
    registry.connect("dampingRatioNormal", eta_n_, caller);
    registry.connect("dampingRatioTangential", eta_t_, caller);

    const int ntypes = registry.max_type();
    const char *stiffness = "a stiffness (N/m) in (0, 1e15]", *ratio = "a ratio in [0, 1)";
    check_type_pairs(lmp, ntypes, kn_, "kn", stiffness);
    check_type_pairs(lmp, ntypes, kt_, "kt", stiffness);
    check_type_pairs(lmp, ntypes, eta_n_, "dampingRatioNormal", ratio);
    check_type_pairs(lmp, ntypes, eta_t_, "dampingRatioTangential", ratio);
    dashpots_.connect(lmp);
    if (force->cg_active()) error->cg(FLERR, caller);
  }

  double stressStrainExponent() { return 1.0; }

  void surfacesIntersect(SurfacesIntersectData& sidata, ForceData& i_forces, ForceData& j_forces) {
    if (sidata.contact_flags) *sidata.contact_flags |= CONTACT_NORMAL_MODEL;
    // sidata.meff comes from the bodies: each sphere of a clump carries the clump's mass in rmass.
    set_coefficients(sidata);
    sidata.Fn = force_on_its_history(sidata);
    ContactCounts* const counts = ContactCounts::active();
    if (counts && sidata.computeflag) counts->add(sidata);

    const double force_magnitude = sidata.is_wall ? sidata.Fn * sidata.area_ratio : sidata.Fn;
    for (int d = 0; d < 3; ++d) {
      const double component = force_magnitude * sidata.en[d];
      i_forces.delta_F[d] += component;
      if (!sidata.is_wall) j_forces.delta_F[d] -= component;
    }
    if (ContactRecorder* recorder = ContactRecorder::armed())
      recorder->add_contact(sidata, i_forces);
  }

  void surfacesClose(SurfacesCloseData& scdata, ForceData&, ForceData&) {
    if (scdata.contact_flags) *scdata.contact_flags &= ~CONTACT_NORMAL_MODEL;
    if (!scdata.contact_history) return;
    double* const stored = scdata.contact_history + offset_;
    const rodpack::NormalHistory history = rodpack::unpack_normal(stored);
    if (history.next_step == 0) return;
    ContactEvents* const events = ContactEvents::armed();
    if (events && history.next_step == update->ntimestep) {
      SurfacesIntersectData contact = events->as_if_in_contact(scdata);
      set_coefficients(contact);
      rodpack::end_normal_force(contact, history, update->dt, *events);
    }
    rodpack::pack(rodpack::NormalHistory(), stored);
  }
  void beginPass(SurfacesIntersectData&, ForceData&, ForceData&) {}
  void endPass(SurfacesIntersectData&, ForceData&, ForceData&) {}

 private:
  void set_coefficients(SurfacesIntersectData& contact) const {
    const int i = contact.itype, j = contact.jtype;
    contact.kn = kn_[i][j];
    contact.kt = kt_[i][j];
    contact.gamman = rodpack::damping_coefficient(eta_n_[i][j], contact.meff, contact.kn);
    contact.gammat = rodpack::damping_coefficient(eta_t_[i][j], contact.meff, contact.kt);
  }

  /// The normal force of a contact, N, with its history brought to this step and its events
  /// reported; where no forces are wanted, without a trace.
  double force_on_its_history(const SurfacesIntersectData& contact) const {
    double* const stored = contact.contact_history + offset_;
    rodpack::NormalHistory history = rodpack::unpack_normal(stored);
    const bool alive = history.next_step == update->ntimestep;
    // At set-up the evaluation of the last step is repeated, except after `restart N`, which saves
    // the contacts of pairs as they were one evaluation before.
    const bool renewed =
        contact.computeflag && (contact.shearupdate || history.next_step == 0 || alive);
    double velocity = history.relaxes ? history.felt_velocity : contact.vn;
    if (renewed)
      velocity = rodpack::follow_velocity(contact, history, alive, dashpots_.kept(update->dt));
    const rodpack::NormalForce normal =
        rodpack::normal_force(contact.kn, contact.gamman, contact.deltan, velocity);
    if (renewed)
      rodpack::follow_normal_force(contact, history, normal.viscoelastic, alive, update->dt,
                                   ContactEvents::armed());
    if (contact.computeflag) {
      history.next_step = update->ntimestep + 1;
      rodpack::pack(history, stored);
    }
    return normal.total;
  }

  int offset_;      // of its values in a contact's history
  double** kn_;     // contact stiffness k_n,ij per type pair, N/m
  double** kt_;     // tangential stiffness k_t,ij, N/m
  double** eta_n_;  // damping ratios
  double** eta_t_;
  RunningDashpots dashpots_;
};

}  // namespace ContactModels
}  // namespace LIGGGHTS

#endif
#endif
