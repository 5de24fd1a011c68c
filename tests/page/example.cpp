// SPDX-License-Identifier: GPL-2.0-or-later
// example FOLDER: writes the folder of a study, for the test of its page in a browser: one run of a
// small made-up packing for each of two cases, and the ensemble of them.
#include <iostream>

#include "../postproc/synthetic_packing.h"
#include "ensemble/ensemble.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: example FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder(argv[1]);
  rodpack::Ensemble ensemble;
  for (const std::string name : {"smooth-AR5", "curved-AR5-theta60"}) {
    rodpack::test::SyntheticPacking packing;
    if (name != "smooth-AR5") packing.shape.curvature_angle = std::acos(-1.0) / 3;
    packing.fill();
    const auto run = "runs/" + name + "/seed-1";
    packing.write_run(folder / run);
    ensemble.cases.push_back(
        {name, {{"aspect_ratio", 5}}, {run}, {1}, {{"solid_fraction", {0.85, {}, 1}}}, {}});
  }
  rodpack::write_ensemble(ensemble, (folder / "ensemble").string());
  return 0;
}
