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
#include "stop_run.h"
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

template <class Style>
bool reports(Style* style) {
  return style->contact_match("normal", "spring_dashpot") &&
         (style->contact_match("tangential", "spring_dashpot") ||
          style->contact_match("tangential", "off"));
}

}  // namespace

void ContactRecorder::check_models() const {
  const char* needs =
      " lists contacts of 'model spring_dashpot' with 'tangential spring_dashpot' or none; ";
  Pair* pair = force->pair_match("gran", 0);
  if (!pair) stop_run(lmp, caller_ + needs + "there is no pair_style gran");
  if (!reports(static_cast<PairGran*>(pair)))
    stop_run(lmp, caller_ + needs + "pair_style gran has another");
  for (int k = 0; k < modify->n_fixes_style("wall/gran"); ++k) {
    FixWallGran* wall = static_cast<FixWallGran*>(modify->find_fix_style("wall/gran", k));
    if (!reports(wall))
      stop_run(lmp, caller_ + needs + "fix wall/gran " + wall->id + " has another");
  }
}

const std::vector<ContactRecord>& ContactRecorder::collect() {
  check_models();
  records_.clear();
  PairGran* pair = static_cast<PairGran*>(force->pair_match("gran", 0));
  // The list is good from the evaluation of the forces on until atoms move to other places in
  // memory, which takes the flag back: before the first run, after write_restart.
  const int stale = !pair->list || pair->list->inum != atom->nlocal || !pair->computeflag();
  int any_stale = 0;
  MPI_Allreduce(&stale, &any_stale, 1, MPI_INT, MPI_MAX, world);
  if (any_stale) stop_run(lmp, caller_ + ": contacts are not known here, put a 'run 0' before");

  armed_ = this;
  PairAccess::evaluate(pair);
  for (int k = 0; k < modify->n_fixes_style("wall/gran"); ++k)
    evaluate_wall(static_cast<FixWallGran*>(modify->find_fix_style("wall/gran", k)));
  armed_ = NULL;
  return records_;
}

void ContactRecorder::evaluate_wall(FixWallGran* wall) {
  // With 'store_force yes' an evaluation that applies no forces would overwrite the stored ones by
  // 0.
  std::vector<double> stored;
  double** stored_array = wall->store_force() ? wall->fix_wallforce()->array_atom : NULL;
  if (stored_array && atom->nlocal)
    stored.assign(stored_array[0], stored_array[0] + 3 * atom->nlocal);
  WallAccess::evaluate(wall);
  if (!stored.empty()) std::copy(stored.begin(), stored.end(), stored_array[0]);
}

bool ContactRecorder::is_primary(int i, int j) const {
  if (j < 0 || j < atom->nlocal) return true;
  if (atom->tag[i] != atom->tag[j]) return atom->tag[i] < atom->tag[j];
  // A sphere that touches its own periodic image sees it on both sides.
  for (int d = 0; d < 3; ++d) {
    const double distance = atom->x[j][d] - atom->x[i][d];
    if (distance != 0.0) return distance > 0.0;
  }
  return true;
}

void ContactRecorder::add_contact(const LIGGGHTS::ContactModels::SurfacesIntersectData& sidata,
                                  const LIGGGHTS::ContactModels::ForceData& i_forces) {
  ContactRecord record;
  record.i = sidata.i;
  record.j = sidata.is_wall ? -1 : sidata.j;
  record.primary = is_primary(record.i, record.j);
  vectorCopy3D(sidata.en, record.normal);
  for (int d = 0; d < 3; ++d)
    record.point[d] = rodpack::lever_component(atom->x[sidata.i][d], sidata.cri, sidata.en[d]);
  vectorCopy3D(i_forces.delta_F, record.force);
  record.overlap = sidata.deltan;
  record.spring = 0.0;
  record.kn = sidata.kn;
  record.kt = 0.0;
  record.damping_n = sidata.gamman;
  record.damping_t = sidata.gammat;
  record.effective_mass = sidata.meff;
  record.type_i = sidata.itype;
  record.type_j = sidata.jtype;
  records_.push_back(record);
}

void ContactRecorder::add_tangential(const double* spring, double kt,
                                     const LIGGGHTS::ContactModels::ForceData& i_forces) {
  ContactRecord& record = records_.back();
  record.spring = vectorMag3D(spring);
  record.kt = kt;
  vectorCopy3D(i_forces.delta_F, record.force);
}

}  // namespace LAMMPS_NS
