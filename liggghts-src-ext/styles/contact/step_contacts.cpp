// SPDX-License-Identifier: GPL-2.0-or-later
#include "step_contacts.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

#include "atom.h"
#include "fix_wall_gran.h"
#include "modify.h"
#include "output.h"
#include "pair_gran.h"
#include "style_laws.h"
#include "update.h"
#include "vector_liggghts.h"
#ifdef RODPACK_STAGED
#include "contact_reports.h"
#endif

namespace LAMMPS_NS {
namespace step_contacts {

namespace {

struct Kept {
  bigint step = -1;
  std::vector<ContactRecord> records;
};

std::map<const void*, Kept>& kept() {
  static std::map<const void*, Kept> of_styles;
  return of_styles;
}

std::vector<const ContactRecorder*>& recorders() {
  static std::vector<const ContactRecorder*> all;
  return all;
}

const std::vector<ContactRecord>* find(const void* style, bigint step) {
  const auto found = kept().find(style);
  return found != kept().end() && found->second.step == step ? &found->second.records : nullptr;
}

#ifdef RODPACK_STAGED

bool is_wanted(const LAMMPS& lmp) {
  const Update& update = *lmp.update;
  const bigint step = update.ntimestep;
  if (update.setupflag || step == update.laststep || step == lmp.output->next) return true;
  // It may end the run there, with output that nobody has announced.
  for (int k = 0; k < lmp.modify->nfix; ++k) {
    const Fix& fix = *lmp.modify->fix[k];
    if (std::strcmp(fix.style, "halt") == 0 && step % fix.nevery == 0) return true;
  }
  return std::any_of(recorders().begin(), recorders().end(),
                     [&](const ContactRecorder* one) { return one->is_asked(step); });
}

/// Takes a record of a pair that does not touch for what it is: no spring, no dashpot, and the
/// geometry that models set for touching surfaces alone.
void complete_bridge(const Atom& atom, const LCM::SurfacesIntersectData& pair,
                     ContactRecord& record) {
  const double distance = std::sqrt(pair.rsq);
  record.overlap = pair.radsum - distance;
  for (int d = 0; d < 3; ++d) {
    record.normal[d] = pair.delta[d] / distance;
    record.point[d] = atom.x[pair.i][d] - (pair.radi - 0.5 * record.overlap) * record.normal[d];
  }
  record.kn = record.kt = record.damping_n = record.damping_t = record.effective_mass = 0.0;
}

class Reports : public rodpack::ContactReports {
 public:
  bool begin(LAMMPS* lmp, PairGran* style, int spring) override {
    return begin_style(lmp, style, spring);
  }
  bool begin(LAMMPS* lmp, FixWallGran* style, int spring) override {
    return begin_style(lmp, style, spring);
  }

  void add(const LCM::SurfacesIntersectData& contact, const LCM::ForceData& on_i) override {
    ContactRecord record = record_of(*atom_, contact, on_i, exponent_);
    if (contact.rsq >= contact.radsum * contact.radsum) {
      complete_bridge(*atom_, contact, record);
    } else if (spring_ >= 0 && contact.contact_history && exponent_ > 0.0) {
      record.spring = vectorMag3D(contact.contact_history + spring_);
      record.kt = contact.kt;
    }
    records_->push_back(record);
  }

 private:
  template <class Style>
  bool begin_style(LAMMPS* lmp, Style* style, int spring) {
    if (reports_itself(style) || !is_wanted(*lmp)) return false;
    Kept& now = kept()[style];
    now.step = lmp->update->ntimestep;
    now.records.clear();
    records_ = &now.records;
    atom_ = lmp->atom;
    spring_ = spring;
    exponent_ = exponent_of(style);
    return true;
  }

  // What is known of the style that has begun.
  std::vector<ContactRecord>* records_ = nullptr;
  const Atom* atom_ = nullptr;
  int spring_ = -1;
  double exponent_ = 0.0;
};

Reports& reports() {
  static Reports one;
  return one;
}

// It is told from the start of the program on: `write_dump` makes its recorder after the run.
const bool told = (rodpack::contact_reports() = &reports(), true);

#else

const bool told = false;

#endif

}  // namespace

bool are_told() { return told; }

const std::vector<ContactRecord>* of(const PairGran* style, bigint step) {
  return find(style, step);
}

const std::vector<ContactRecord>* of(const FixWallGran* style, bigint step) {
  return find(style, step);
}

void follow(const ContactRecorder* recorder) { recorders().push_back(recorder); }

void forget(const ContactRecorder* recorder) {
  recorders().erase(std::remove(recorders().begin(), recorders().end(), recorder),
                    recorders().end());
}

}  // namespace step_contacts
}  // namespace LAMMPS_NS
