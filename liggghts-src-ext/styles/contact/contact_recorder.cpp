// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact_recorder.h"

#include "atom.h"
#include "fix_property_atom.h"
#include "fix_wall_gran.h"
#include "force.h"
#include "modify.h"
#include "neigh_list.h"
#include "pair_gran.h"
#include "particle_identity.h"
#include "rodpack/contact/contact_law.h"
#include "step_contacts.h"
#include "stop_run.h"
#include "style_laws.h"
#include "vector_liggghts.h"

namespace LAMMPS_NS {

rodpack::SphereContact contact_of(const ContactRecord& record, const ParticleIdentity& particles,
                                  const std::vector<rodpack::Vector>& centres) {
  rodpack::SphereContact contact;
  contact.wall = record.j < 0;
  contact.i = particles.id_of(record.i);
  contact.j = contact.wall ? 0 : particles.id_of(record.j);
  vectorCopy3D(record.point, contact.point.data());
  vectorCopy3D(record.force, contact.force.data());
  contact.centre_i = particles.centre_near(record.i, centres);
  contact.centre_j = contact.wall ? contact.point : particles.centre_near(record.j, centres);
  return contact;
}

ContactRecorder* ContactRecorder::armed_ = NULL;

namespace {

// LIGGGHTS's own re-evaluations (compute_pgl, post_force_pgl) also feed a compute pair/gran/local
// that happens to exist. These two set the same flags, which are protected, but leave it alone.
struct PairAccess : PairGran {
  static void evaluate(PairGran* pair) {
    int& compute = pair->*(&PairAccess::computeflag_);
    int& shear = pair->*(&PairAccess::shearupdate_);
    const int kept_compute = compute, kept_shear = shear;
    const int kept_evflag = pair->evflag, kept_fdotr = pair->vflag_fdotr;
    compute = shear = 0;
    (pair->*(&PairAccess::compute_force))(0, 0, 0);
    compute = kept_compute;
    shear = kept_shear;
    pair->evflag = kept_evflag;
    pair->vflag_fdotr = kept_fdotr;
  }
};

struct WallAccess : FixWallGran {
  static void evaluate(FixWallGran* wall) {
    int& compute = wall->*(&WallAccess::computeflag_);
    int& shear = wall->*(&WallAccess::shearupdate_);
    int& add = wall->*(&WallAccess::addflag_);
    const int kept_compute = compute, kept_shear = shear, kept_add = add;
    compute = shear = add = 0;
    (wall->*(&WallAccess::post_force_wall))(0);
    compute = kept_compute;
    shear = kept_shear;
    add = kept_add;
  }
};

/// Whether this record is the one of its contact that counts.
bool is_primary(const Atom& atom, int i, int j) {
  if (j < 0 || j < atom.nlocal) return true;
  if (atom.tag[i] != atom.tag[j]) return atom.tag[i] < atom.tag[j];
  // A sphere that touches its own periodic image sees it on both sides.
  for (int d = 0; d < 3; ++d) {
    const double distance = atom.x[j][d] - atom.x[i][d];
    if (distance != 0.0) return distance > 0.0;
  }
  return true;
}

}  // namespace

ContactRecord record_of(const Atom& atom, const LCM::SurfacesIntersectData& contact,
                        const LCM::ForceData& on_i, double exponent) {
  ContactRecord record = {};
  record.i = contact.i;
  record.j = contact.is_wall ? -1 : contact.j;
  record.primary = is_primary(atom, record.i, record.j);
  vectorCopy3D(contact.en, record.normal);
  for (int d = 0; d < 3; ++d)
    record.point[d] = rodpack::lever_component(atom.x[contact.i][d], contact.cri, contact.en[d]);
  vectorCopy3D(on_i.delta_F, record.force);
  record.overlap = contact.deltan;
  record.type_i = contact.itype;
  record.type_j = contact.jtype;
  record.exponent = exponent;
  if (!(exponent > 0.0)) return record;
  record.kn = contact.kn;
  record.damping_n = contact.gamman;
  record.damping_t = contact.gammat;
  record.effective_mass = contact.meff;
  return record;
}

ContactRecorder::ContactRecorder(LAMMPS* lmp, const std::string& caller, Asked asked)
    : Pointers(lmp), caller_(caller), asked_(std::move(asked)) {
  step_contacts::follow(this);
}

ContactRecorder::~ContactRecorder() { step_contacts::forget(this); }

/// Calls `found` with each style that evaluates contacts, and what messages call it.
template <class Found>
void ContactRecorder::for_each_style(Found found) const {
  found(static_cast<PairGran*>(force->pair_match("gran", 0)), std::string("pair_style gran"));
  for (int k = 0; k < modify->n_fixes_style("wall/gran"); ++k) {
    FixWallGran* wall = static_cast<FixWallGran*>(modify->find_fix_style("wall/gran", k));
    found(wall, std::string("fix wall/gran ") + wall->id);
  }
}

void ContactRecorder::check_models() const {
  if (!force->pair_match("gran", 0))
    stop_run(lmp, caller_ + " lists contacts of pair_style gran, which there is not");
  if (atom->shapetype_flag || atom->superquadric_flag)
    stop_run(lmp, caller_ + " lists contacts of spheres, expected 'atom_style sphere'");
  for_each_style([this](auto* style, const std::string& name) {
    if (reports_itself(style) || step_contacts::are_told()) return;
    stop_run(lmp, caller_ +
                      " lists contacts of 'model spring_dashpot' with 'tangential spring_dashpot' "
                      "or none in a LIGGGHTS that is not rodpack's own; " +
                      name + " has another");
  });
}

void ContactRecorder::check_potentials() const {
  for_each_style([this](auto* style, const std::string& name) {
    if (exponent_of(style) > 0.0) return;
    stop_run(lmp, caller_ +
                      " needs a normal force that is a function of the overlap, expected 'model' "
                      "spring_dashpot, hooke, hooke/stiffness, hertz or hertz/stiffness; " +
                      name + " has another");
  });
}

void ContactRecorder::check_springs() const {
  for_each_style([this](auto* style, const std::string& name) {
    if (has_springs_alone(style)) return;
    stop_run(lmp, caller_ +
                      " needs springs and dashpots, expected 'model' spring_dashpot, hooke, "
                      "hooke/stiffness, hertz or hertz/stiffness, 'tangential' spring_dashpot, "
                      "history or off, 'rolling_friction' cdt, epsd, epsd2, epsd3 or off; " +
                      name + " has others");
  });
}

template <class Style>
void ContactRecorder::add_contacts_of(Style* style, const std::string& name) {
  const std::size_t first = records_.size();
  if (reports_itself(style)) {
    evaluate(style);
  } else if (const auto* kept = step_contacts::of(style, update->ntimestep)) {
    records_.insert(records_.end(), kept->begin(), kept->end());
  } else if (update->setupflag) {
    stop_run(lmp, caller_ + ": the contacts of " + name +
                      " are not known yet when the run is set up: give what asks for them behind "
                      "that fix");
  } else {
    stop_run(lmp, caller_ +
                      ": the contacts of this step are not known, since nobody has announced "
                      "that they would be asked for: ask in steps of output or through a "
                      "fix that announces, as fix ave/time does; or put a 'run 0' before");
  }
  const rodpack::RollingLaw rolling = rolling_law_of(style);
  for (std::size_t k = first; k < records_.size(); ++k) records_[k].rolling = rolling;
}

const std::vector<ContactRecord>& ContactRecorder::collect() {
  check_models();
  records_.clear();
  const PairGran* pair = static_cast<PairGran*>(force->pair_match("gran", 0));
  // The list is good from the evaluation of the forces on until atoms move to other places in
  // memory, which takes the flag back: before the first run, after write_restart.
  const int stale = !pair->list || pair->list->inum != atom->nlocal || !pair->computeflag();
  int any_stale = 0;
  MPI_Allreduce(&stale, &any_stale, 1, MPI_INT, MPI_MAX, world);
  if (any_stale) stop_run(lmp, caller_ + ": contacts are not known here, put a 'run 0' before");

  armed_ = this;
  for_each_style([this](auto* style, const std::string& name) { add_contacts_of(style, name); });
  armed_ = NULL;
  return records_;
}

void ContactRecorder::evaluate(PairGran* pair) { PairAccess::evaluate(pair); }

void ContactRecorder::evaluate(FixWallGran* wall) {
  // With 'store_force yes' an evaluation that applies no forces would overwrite the stored ones by
  // 0.
  std::vector<double> stored;
  double** stored_array = wall->store_force() ? wall->fix_wallforce()->array_atom : NULL;
  if (stored_array && atom->nlocal)
    stored.assign(stored_array[0], stored_array[0] + 3 * atom->nlocal);
  WallAccess::evaluate(wall);
  if (stored_array && !stored.empty()) std::copy(stored.begin(), stored.end(), stored_array[0]);
}

void ContactRecorder::add_contact(const LCM::SurfacesIntersectData& sidata,
                                  const LCM::ForceData& i_forces) {
  records_.push_back(record_of(*atom, sidata, i_forces, 1.0));
}

void ContactRecorder::add_tangential(const double* spring, double kt,
                                     const LCM::ForceData& i_forces) {
  ContactRecord& record = records_.back();
  record.spring = vectorMag3D(spring);
  record.kt = kt;
  vectorCopy3D(i_forces.delta_F, record.force);
}

}  // namespace LAMMPS_NS
