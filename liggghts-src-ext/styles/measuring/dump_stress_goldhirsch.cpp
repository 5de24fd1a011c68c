// SPDX-License-Identifier: GPL-2.0-or-later
#include "dump_stress_goldhirsch.h"

#include <fstream>
#include "compute_stress_goldhirsch.h"
#include "modify.h"
#include "stop_run.h"
#include "update.h"
#ifdef LAMMPS_VTK
#include "rodpack/vtk/field_image.h"
#endif

namespace LAMMPS_NS {

DumpStressGoldhirsch::DumpStressGoldhirsch(LAMMPS* lmp, int narg, char** arg)
    : FileDump(lmp, narg, arg), compute_(NULL), image_(ends_in(".vti")) {
  if (narg != 6)
    stop_run(lmp, *this, "expected a file and the id of one compute stress/goldhirsch");
  compute_id_ = arg[5];
  if (compute_id_.compare(0, 2, "c_") == 0) compute_id_.erase(0, 2);
  require_ending({".vti", ".csv"});
#ifndef LAMMPS_VTK
  if (image_) stop_run(lmp, *this, "LIGGGHTS was built without VTK: write .csv");
#endif
}

void DumpStressGoldhirsch::init_style() {
  require_si_and_folder("columns");
  const int index = modify->find_compute(compute_id_.c_str());
  compute_ = index < 0 ? NULL : dynamic_cast<ComputeStressGoldhirsch*>(modify->compute[index]);
  if (!compute_)
    stop_run(lmp, *this, "there is no compute stress/goldhirsch with the id '" + compute_id_ + "'");
  if (image_ && !compute_->places().grid())
    stop_run(lmp, *this, "places at single points have no image: write .csv");
}

void DumpStressGoldhirsch::write() {
  const std::vector<rodpack::Field>& fields = compute_->current_fields();
  if (me != 0) return;
  const std::string name = file_name();
  bool written = false;
  if (image_) {
#ifdef LAMMPS_VTK
    written = rodpack::write_field_image(*compute_->places().grid(), fields,
                                         static_cast<double>(update->ntimestep) * update->dt, name);
#endif
  } else {
    std::ofstream file(name);
    file << rodpack::csv_text(compute_->places(), fields);
    file.close();
    written = !file.fail();
  }
  if (!written) stop_run_from_one_rank(lmp, *this, "Cannot write dump file " + name);
}

}  // namespace LAMMPS_NS
