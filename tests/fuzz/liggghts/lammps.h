// SPDX-License-Identifier: GPL-2.0-or-later
// What the readers of style options take from LIGGGHTS: the part of its classes that they look at,
// with values of a small run, so that a million inputs are read without a simulation.
#ifndef RODPACK_FUZZ_LAMMPS_H
#define RODPACK_FUZZ_LAMMPS_H

#include <cstdint>

namespace LAMMPS_NS {

using bigint = std::int64_t;
#define MAXBIGINT INT64_MAX

struct Atom {
  int ntypes = 2, sphere_flag = 1;
};

struct Domain {
  int box_exist = 1, triclinic = 0, periodicity[3] = {1, 0, 0};
  double boxlo[3] = {0, 0, -0.01}, boxhi[3] = {0.1, 0.2, 0.01}, prd[3] = {0.1, 0.2, 0.02};
};

struct Force {
  double cg(int) const { return 1; }
};

class LAMMPS {
 public:
  Atom* atom;
  Domain* domain;
  Force* force;
};

class Pointers {
 public:
  explicit Pointers(LAMMPS* ptr) : lmp(ptr) {}

 protected:
  LAMMPS* lmp;
};

}  // namespace LAMMPS_NS

#endif
