// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_STEP_CONTACTS_H
#define RODPACK_STEP_CONTACTS_H

#include <vector>
#include "contact_recorder.h"

namespace LAMMPS_NS {

class FixWallGran;
class PairGran;

/// The contacts that a step has evaluated itself, of the styles whose models do not report to a
/// ContactRecorder: LIGGGHTS's own tell of them (stock/contact_reports.h). They are kept in the
/// first and last step of a run, in those of output, where a fix halt looks, and where a recorder
/// is asked.
namespace step_contacts {

/// Whether styles tell: not in a LIGGGHTS that is not mended.
bool are_told();

/// The contacts of pair_style gran or of a fix wall/gran in this step; null if none were kept.
const std::vector<ContactRecord>* of(const PairGran* style, bigint step);
const std::vector<ContactRecord>* of(const FixWallGran* style, bigint step);

void follow(const ContactRecorder* recorder);
void forget(const ContactRecorder* recorder);

}  // namespace step_contacts
}  // namespace LAMMPS_NS

#endif
