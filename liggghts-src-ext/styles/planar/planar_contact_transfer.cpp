// SPDX-License-Identifier: GPL-2.0-or-later
#include "planar_contact_transfer.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "atom.h"
#include "comm.h"
#include "contact_model_constants.h"
#include "fix_contact_history.h"
#include "fix_property_atom.h"
#include "fix_property_global.h"
#include "fix_wall_gran.h"
#include "force.h"
#include "modify.h"
#include "mpi_ranks.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "pair_gran.h"
#include "planar_stop.h"
#include "rodpack/contact/planar_history.h"
#include "update.h"
#include "wall_shape.h"

namespace LAMMPS_NS {

using rodpack::CapHistory;
using rodpack::NormalHistory;
using rodpack::TangentialHistory;

namespace {

struct WallAccess : FixWallGran {
  static double** histories(FixWallGran* wall) {
    return (wall->*(&WallAccess::fix_history_primitive_))->array_atom;
  }
};

/// The histories of contacts by atom, which LIGGGHTS keeps there while it builds new lists.
struct HistoryAccess : FixContactHistory {
  static void reset(FixContactHistory* fix) {
    (fix->*(&HistoryAccess::ipage_))->reset();
    (fix->*(&HistoryAccess::dpage_))->reset();
  }
  static int*& partners(FixContactHistory* fix, int i) {
    return (fix->*(&HistoryAccess::partner_))[i];
  }
  static int& count(FixContactHistory* fix, int i) {
    return (fix->*(&HistoryAccess::npartner_))[i];
  }
  /// Makes room for `count` partners of atom i, which then has none; false if memory is short.
  static bool allocate(FixContactHistory* fix, int i, int count) {
    int*& tags = partners(fix, i);
    double*& values = (fix->*(&HistoryAccess::contacthistory_))[i];
    tags = (fix->*(&HistoryAccess::ipage_))->get(count);
    values = (fix->*(&HistoryAccess::dpage_))->get(count * fix->get_dnum());
    HistoryAccess::count(fix, i) = 0;
    int& most = fix->*(&HistoryAccess::maxtouch_);
    most = std::max(most, count);
    return tags && values;
  }
};

template <class Style>
bool has_known_models(Style* style) {
  return style->contact_match("normal", "spring_dashpot") &&
         style->contact_match("tangential", "spring_dashpot") &&
         style->contact_match("surface", "default") && style->contact_match("cohesion", "off") &&
         style->contact_match("rolling_friction", "off");
}

const char* const needed_models =
    "'model spring_dashpot tangential spring_dashpot' alone, without other models";

// The number of values tells the caps apart: another multistepOrder takes three more or less.
static_assert(rodpack::stored_cap_values % 3 != 0, "taken for another multistepOrder");

}  // namespace

void PlanarContactTransfer::connect() {
  pair_ = static_cast<PairGran*>(force->pair_match("gran", 1));
  if (!pair_ || pair_ != force->pair)
    refuse(lmp, std::string("pair_style gran is needed, not in a hybrid, with ") + needed_models);
  if (!has_known_models(pair_))
    refuse(lmp, std::string("pair_style gran has other models, expected ") + needed_models);
  values_ = pair_->dnum();
  // The number of values counts those of totalForceCap too, if it is on.
  slots_ = (values_ - rodpack::stored_history_values(0)) / 3;
  has_total_cap_ = values_ != rodpack::stored_history_values(slots_);
  if (has_total_cap_)
    slots_ = (values_ - rodpack::stored_history_values(0) - rodpack::stored_cap_values) / 3;
  if (slots_ < 1 || slots_ > rodpack::max_multistep_order ||
      values_ != rodpack::stored_history_values(slots_) +
                     (has_total_cap_ ? rodpack::stored_cap_values : 0))
    refuse(lmp, "pair_style gran keeps other values in the history of contacts");
  walls_.clear();
  for (int k = 0; k < modify->n_fixes_style("wall/gran"); ++k) {
    FixWallGran* wall = static_cast<FixWallGran*>(modify->find_fix_style("wall/gran", k));
    const std::string name = std::string("fix ") + wall->style + " (id " + wall->id + ") ";
    if (!has_known_models(wall)) refuse(lmp, name + "has other models, expected " + needed_models);
    const WallShape plane = shape_of(*wall);
    if (plane.kind != WallShape::Kind::plane || plane.axis > 1)
      refuse(lmp, name + "is no plane, expected 'primitive ... xplane' or 'yplane'");
    if (wall->is_moving()) refuse(lmp, name + "moves ('shear'), expected a wall at rest");
    if (wall->igroup != 0) refuse(lmp, name + "acts on a group, expected all");
    if (wall->heattransfer_flag() || wall->store_force_contact() ||
        wall->store_force_contact_stress() || wall->store_sum_normal_force())
      refuse(lmp, name + "stores values of contacts or transfers heat, which the engine does not");
    if (wall->dnum() != values_)
      refuse(lmp, name +
                      "has another history than pair_style gran: give both the same "
                      "multistepOrder and totalForceCap");
    walls_.push_back(wall);
  }
}

std::vector<rodpack::PlanarLaw> PlanarContactTransfer::laws() const {
  const int types = atom->ntypes;
  const char* const names[] = {"kn", "kt", "dampingRatioNormal", "dampingRatioTangential",
                               "coefficientFriction"};
  std::vector<rodpack::PlanarLaw> laws(types * types);
  for (int k = 0; k < 5; ++k) {
    FixPropertyGlobal* property = static_cast<FixPropertyGlobal*>(modify->find_fix_property(
        names[k], "property/global", "peratomtypepair", types, types, planar_run_style));
    for (int pair = 0; pair < types * types; ++pair) {
      rodpack::PlanarLaw& law = laws[pair];
      double* const values[] = {&law.kn, &law.kt, &law.eta_n, &law.eta_t, &law.friction};
      *values[k] = property->compute_array(pair / types, pair % types);
    }
  }
  return laws;
}

std::vector<rodpack::PlanarWall> PlanarContactTransfer::walls() const {
  std::vector<rodpack::PlanarWall> planes;
  for (FixWallGran* wall : walls_) {
    const WallShape shape = shape_of(*wall);
    rodpack::PlanarWall plane;
    plane.axis = shape.axis;
    plane.position = shape.position;
    plane.free_side = shape.free_side;
    plane.type = wall->atom_type_wall() - 1;
    planes.push_back(plane);
  }
  return planes;
}

/// What LIGGGHTS keeps of a contact.
struct PlanarContactTransfer::Record {
  NormalHistory normal;
  TangentialHistory tangential;
  bool has_cap;
  CapHistory cap;  // of totalForceCap

  Record(const double* stored, int slots, bool total_cap)
      : normal(rodpack::unpack_normal(stored)),
        tangential(rodpack::unpack_tangential(stored + rodpack::stored_normal_values, slots)),
        has_cap(total_cap) {
    if (has_cap) cap = rodpack::unpack_cap(stored + rodpack::stored_history_values(slots));
  }
  Record(const PlanarContactRecord& contact, int slots, bool total_cap, std::int64_t now)
      : tangential(slots), has_cap(total_cap) {
    const rodpack::PlanarContactState::Constants& constants = contact.state.constants;
    to_space(contact.state.history, {contact.normal[0], contact.normal[1]}, normal, tangential);
    cap = to_cap(contact.state.history, normal, constants.kn, constants.gamman);
    normal.next_step = now + 1;
    tangential.step = now;
    tangential.friction = constants.friction;
    tangential.stiffness = constants.kt;
    tangential.damping = constants.gammat;
  }

  rodpack::PlanarHistory in_plane(rodpack::Vector2<double> normal_vector) const {
    rodpack::PlanarHistory history = to_plane(normal, tangential, normal_vector);
    history.earlier = cap.earlier;
    return history;
  }
  bool lives(std::int64_t now) const { return tangential.known != 0 && tangential.step == now; }
  void store(double* stored) const {
    rodpack::pack(normal, stored);
    rodpack::pack(tangential, stored + rodpack::stored_normal_values);
    if (has_cap) rodpack::pack(cap, stored + rodpack::stored_history_values(tangential.slots));
  }
};

PlanarContactTransfer::Record PlanarContactTransfer::record_of(const double* stored) const {
  return Record(stored, slots_, has_total_cap_);
}

void PlanarContactTransfer::store(const PlanarContactRecord& contact, double* stored) const {
  Record(contact, slots_, has_total_cap_, update->ntimestep).store(stored);
}

std::vector<PlanarContactRecord> PlanarContactTransfer::read(const PlanarOwners& owners) const {
  const std::int64_t now = update->ntimestep;
  std::vector<std::vector<PlanarContactRecord> > contacts(comm->nprocs);
  const auto send = [&](const PlanarContactRecord& contact, int atom_index) {
    contacts[owners.of_body(atom_index)].push_back(contact);
  };
  double** const x = atom->x;
  NeighList* const list = pair_->list;
  for (int ii = 0; ii < list->inum; ++ii) {
    const int i = list->ilist[ii];
    double* histories = list->listgranhistory->firstdouble[i];
    for (int jj = 0; jj < list->numneigh[i]; ++jj) {
      if (!list->listgranhistory->firstneigh[i][jj]) continue;
      const int j = list->firstneigh[i][jj] & NEIGHMASK;
      // The rank of j lists this contact too; one of both has to read it.
      if (j >= atom->nlocal && atom->tag[j] < atom->tag[i]) continue;
      const Record record = record_of(histories + values_ * jj);
      if (!record.lives(now)) continue;
      PlanarContactRecord contact = PlanarContactRecord();
      contact.atom = atom->tag[i];
      contact.partner = atom->tag[j];
      const double dx = x[i][0] - x[j][0], dy = x[i][1] - x[j][1], r = std::hypot(dx, dy);
      contact.state.history = record.in_plane({dx / r, dy / r});
      send(contact, i);
      if (owners.of_body(j) != owners.of_body(i)) send(contact, j);
    }
  }
  const std::vector<rodpack::PlanarWall> planes = walls();
  for (size_t w = 0; w < walls_.size(); ++w)
    for (int i = 0; i < atom->nlocal; ++i) {
      const Record record = record_of(WallAccess::histories(walls_[w])[i]);
      if (!record.lives(now)) continue;
      PlanarContactRecord contact = PlanarContactRecord();
      contact.atom = atom->tag[i];
      contact.partner = -1 - static_cast<int>(w);
      const int axis = planes[w].axis;
      const double side = planes[w].side_of(x[i][axis] - planes[w].position);
      contact.state.history = record.in_plane({axis == 0 ? side : 0.0, axis == 1 ? side : 0.0});
      send(contact, i);
    }
  return exchange_records(world, std::move(contacts));
}

int PlanarContactTransfer::local_atom(int tag) const {
  const int i = atom->map(tag);
  if (i < 0 || i >= atom->nlocal || atom->tag[i] != tag)
    refuse_from_one_rank(lmp, "a contact of atom " + std::to_string(tag) +
                                  " has come to another rank than the atom");
  return i;
}

void PlanarContactTransfer::write_to_walls(const std::vector<PlanarContactRecord>& records) {
  for (FixWallGran* wall : walls_)
    for (int i = 0; i < atom->nlocal; ++i)
      std::fill_n(WallAccess::histories(wall)[i], values_, 0.0);
  for (const PlanarContactRecord& contact : records)
    if (contact.partner < 0)
      store(contact, WallAccess::histories(walls_[-1 - contact.partner])[local_atom(contact.atom)]);
}

void PlanarContactTransfer::write_to_lists(const std::vector<PlanarContactRecord>& records) {
  using LIGGGHTS::ContactModels::CONTACT_NORMAL_MODEL;
  using LIGGGHTS::ContactModels::CONTACT_TANGENTIAL_MODEL;
  write_to_walls(records);
  NeighList* const list = pair_->list;
  for (int ii = 0; ii < list->inum; ++ii) {
    const int i = list->ilist[ii];
    int* const flags = list->listgranhistory->firstneigh[i];
    double* const histories = list->listgranhistory->firstdouble[i];
    for (int jj = 0; jj < list->numneigh[i]; ++jj) {
      if (!flags[jj]) continue;
      flags[jj] = 0;
      std::fill_n(histories + values_ * jj, values_, 0.0);
    }
  }
  // A pair is in the list of one of its atoms here; if both are, in that of either.
  int missing = 0;
  for (const PlanarContactRecord& contact : records) {
    if (contact.partner < 0) continue;
    const int i = local_atom(contact.atom), j = atom->map(contact.partner);
    const int* const neighbours = list->firstneigh[i];
    int jj = 0;
    while (jj < list->numneigh[i] && (neighbours[jj] & NEIGHMASK) != j) ++jj;
    const bool is_there = jj < list->numneigh[i];
    missing += (is_there ? -1 : 1) * (j >= 0 && j < atom->nlocal ? 1 : is_there ? 0 : 2);
    if (!is_there) continue;
    list->listgranhistory->firstneigh[i][jj] = CONTACT_NORMAL_MODEL | CONTACT_TANGENTIAL_MODEL;
    store(contact, list->listgranhistory->firstdouble[i] + values_ * jj);
  }
  if (missing != 0) refuse_from_one_rank(lmp, "a contact is not in the neighbour list");
}

void PlanarContactTransfer::write_to_atoms(const std::vector<PlanarContactRecord>& records) {
  write_to_walls(records);
  FixContactHistory* const histories = pair_->list->fix_history;
  std::vector<int> counts(atom->nlocal, 0);
  for (const PlanarContactRecord& contact : records)
    if (contact.partner >= 0) ++counts[local_atom(contact.atom)];
  HistoryAccess::reset(histories);
  int most = 0;
  for (int i = 0; i < atom->nlocal; ++i) {
    most = std::max(most, counts[i]);
    if (!HistoryAccess::allocate(histories, i, counts[i]))
      refuse_from_one_rank(lmp, "contact history overflow, boost neigh_modify one");
  }
  // Room for what an atom takes along when it changes its rank.
  comm->maxexchange_fix = std::max(comm->maxexchange_fix, (values_ + 1) * most + 1);
  for (const PlanarContactRecord& contact : records) {
    if (contact.partner < 0) continue;
    const int i = local_atom(contact.atom), entry = HistoryAccess::count(histories, i)++;
    HistoryAccess::partners(histories, i)[entry] = contact.partner;
    store(contact, histories->contacthistory(i, entry));
  }
}

}  // namespace LAMMPS_NS
