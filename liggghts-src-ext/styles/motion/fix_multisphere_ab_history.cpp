// SPDX-License-Identifier: GPL-2.0-or-later
// The rates of the past: storage, start-up, restart files.
#include <string>

#include "fix_multisphere_ab.h"
#include "mpi_liggghts.h"
#include "multisphere_fix.h"
#include "rodpack/motion/multistep.h"
#include "update.h"

using namespace LAMMPS_NS;

// What the records of a body hold, as one number: order, short records or long ones, planar rates
// in them or spatial ones. A stock restart file may go on with other properties in its place; none
// of those is negative.
int FixMultisphereAB::layout() const {
  return -(2000 + 100 * order_ + 10 * options_.always_planar() + planar_);
}

/// Values per body that a history of this layout takes in a restart file; 0 if it is none of ours.
int FixMultisphereAB::history_size(int layout) {
  const int order = -layout / 100 - 20;
  if (layout >= 0 || order < 0 || order > rodpack::max_multistep_order) return 0;
  const bool short_records = -layout / 10 % 10 == 1;
  return 3 + 12 + std::max(0, order - 1) * (short_records ? 6 : 13);
}

void FixMultisphereAB::add_history() {
  CustomValueTracker& properties = data().prop();
  stock_restart_size_ = properties.elemBufSize(OPERATION_RESTART, NULL, false, false, false);
  layout_ = properties.addElementProperty<ScalarContainer<int> >(
      "ab_layout", "comm_exchange_borders", "frame_invariant", "restart_yes");
  evaluations_ = properties.addElementProperty<ScalarContainer<int> >(
      "ab_evaluations", "comm_exchange_borders", "frame_invariant", "restart_yes");
  timestep_ = properties.addElementProperty<ScalarContainer<double> >(
      "ab_timestep", "comm_exchange_borders", "frame_invariant", "restart_yes");
  missed_motion_ = properties.addElementProperty<StoredMissedMotion>(
      "ab_missed_motion", "comm_exchange_borders", "frame_invariant", "restart_yes");
  missed_motion_->setDefaultValue(0.0);
  planar_load_ = properties.addElementProperty<VectorContainer<double, 3> >(
      "ab_planar_load", "comm_exchange_borders", "frame_invariant", "restart_no");
  planar_load_->setDefaultValue(0.0);
  contact_weight_ = NULL;
  if (mass_scaling_ > 0.0) {
    contact_weight_ = properties.addElementProperty<ScalarContainer<double> >(
        "ab_contact_weight", "comm_exchange_borders", "frame_invariant", "restart_no");
    contact_weight_->setDefaultValue(0.0);
  }
  prescribed_ = properties.addElementProperty<ScalarContainer<int> >(
      prescribed_motion, "comm_exchange_borders", "frame_invariant", "restart_no");
  prescribed_->setDefaultValue(0);
  evaluations_->setDefaultValue(0);
  timestep_->setDefaultValue(0.0);
  if (options_.always_planar())
    add_records(past_planar_);
  else
    add_records(past_spatial_);
}

template <class Record>
void FixMultisphereAB::add_records(std::vector<Record*>& past) {
  for (int k = 0; k < order_ - 1; ++k) {
    const std::string name = "ab_rates_" + std::to_string(order_ - 1 - k);
    past.push_back(data().prop().addElementProperty<Record>(name.c_str(), "comm_exchange_borders",
                                                            "frame_invariant", "restart_yes"));
    past.back()->setDefaultValue(0.0);
  }
}

void FixMultisphereAB::restart_history_after_change() {
  int restarted = 0;
  for (int body = 0; body < n_body(); ++body) {
    const bool same = layout_->get(body) == layout() && timestep_->get(body) == update->dt;
    if (evaluations_->get(body) > 0 && !same) {
      evaluations_->set(body, 0);
      ++restarted;
    }
    layout_->set(body, layout());
  }
  layout_->setDefaultValue(layout());
  MPI_Sum_Scalar(restarted, world);
  if (restarted > 0)
    warn_of_new_histories(*this, lmp, "another time step or planarity",
                          std::to_string(restarted) + " bodies");
}

/// Reads bodies from a restart file. Where the file holds no history like ours (built-in
/// multisphere, another order), an empty one is put in and every body starts anew.
void FixMultisphereAB::restart(char* buf) {
  const int stock_header = 4;  // record size and bounding sphere centre, ahead of the properties
  const double* in = reinterpret_cast<const double*>(buf);
  const int bodies = static_cast<int>(in[0]);
  std::vector<double> list(1, *in++);
  bool anew = false;
  for (int body = 0; body < bodies; ++body) {
    const double* end = in + static_cast<int>(in[0]);
    const double* ours = in + stock_header + stock_restart_size_;
    const size_t begin = list.size();
    list.insert(list.end(), in, ours);
    const int in_file = ours < end ? static_cast<int>(*ours) : 0;
    if (history_size(in_file) != history_size(layout())) {
      list.push_back(layout());
      list.resize(list.size() + history_size(layout()) - 1, 0.0);
      ours += history_size(in_file);
      anew = true;
    }
    list.insert(list.end(), ours, end);
    list[begin] = static_cast<double>(list.size() - begin);
    in = end;
  }
  if (anew)
    warn_of_new_histories(*this, lmp, "the restart file holds none for this order and planarity",
                          "every body");
  FixMultisphere::restart(reinterpret_cast<char*>(list.data()));
}
