// SPDX-License-Identifier: GPL-2.0-or-later
// example FOLDER: writes the run folder of a small made-up packing, for the test of the page in a
// browser.
#include <iostream>

#include "../postproc/synthetic_packing.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: example FOLDER\n";
    return 2;
  }
  rodpack::test::SyntheticPacking packing;
  packing.fill();
  packing.write_run(argv[1]);
  return 0;
}
