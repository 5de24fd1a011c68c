// SPDX-License-Identifier: GPL-2.0-or-later
#include "pipeline.h"

#include <algorithm>

namespace rodpack {

PlanarDependencies::PlanarDependencies(const PlanarParts& parts)
    : parts_(parts), completed_by_(parts.count()) {
  clear();
}

void PlanarDependencies::clear() {
  for (int part = 0; part < parts_.count(); ++part) completed_by_[part] = part;
}

void PlanarDependencies::add_contact(int i, int j, int part) {
  for (const int body : {i, j}) {
    if (body < 0) continue;
    int& last = completed_by_[parts_.of(body)];
    last = std::max(last, part);
  }
}

void PlanarPipeline::run(int steps, PlanarPartStep& part_step) {
  const int parts = parts_.count();
  std::fill_n(made_, steps, 0);
  while (made_[steps - 1] < parts) {
    if (made_[0] < parts) make_next_part(0, part_step);
    for (int step = 1; step < steps; ++step)
      while (made_[step] < parts && dependencies_.completed_by(made_[step]) < made_[step - 1])
        make_next_part(step, part_step);
  }
}

void PlanarPipeline::make_next_part(int step, PlanarPartStep& part_step) {
  const int part = made_[step];
  if (part_step.move(step, part))
    for (int before = 0; before < step; ++before)
      while (made_[before] < parts_.count()) make_next_part(before, part_step);
  part_step.evaluate(step, part);
  ++made_[step];
}

}  // namespace rodpack
