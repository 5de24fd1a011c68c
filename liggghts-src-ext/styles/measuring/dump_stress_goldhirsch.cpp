// SPDX-License-Identifier: GPL-2.0-or-later
#include "dump_stress_goldhirsch.h"

#include <fstream>
#include "compute_stress_goldhirsch.h"
#include "modify.h"
#include "stop_run.h"
#include "dump_files.h"
#include "update.h"
#ifdef LAMMPS_VTK
#include "rodpack/vtk/field_image.h"
#endif

namespace LAMMPS_NS {

namespace {

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

}  // namespace

DumpStressGoldhirsch::DumpStressGoldhirsch(LAMMPS* lmp, int narg, char** arg)
    : Dump(lmp, narg, arg), compute_(NULL), image_(ends_with(filename, ".vti")) {
  if (narg != 6)
    stop_run(lmp, *this, "expected a file and the id of one compute stress/goldhirsch");
  compute_id_ = arg[5];
  if (compute_id_.compare(0, 2, "c_") == 0) compute_id_.erase(0, 2);
  if (multiproc || (!image_ && !ends_with(filename, ".csv")))
    stop_run(lmp, *this,
             std::string("file is ") + filename +
                 ", expected a name that ends in .vti or .csv, without %");
#ifndef LAMMPS_VTK
  if (image_) stop_run(lmp, *this, "LIGGGHTS was built without VTK: write .csv");
#endif
}

void DumpStressGoldhirsch::init_style() {
  if (std::string(update->unit_style) != "si")
    stop_run(lmp, *this,
             std::string("its columns are named with units of SI: the deck's units are ") +
                 update->unit_style + ", expected si");
  require_folder(lmp, *this, filename);
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
  const std::string name = name_at_step(filename, update->ntimestep, padflag);
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
