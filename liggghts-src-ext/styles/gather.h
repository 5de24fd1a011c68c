// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_GATHER_H
#define RODPACK_GATHER_H

#include <mpi.h>
#include <vector>

namespace LAMMPS_NS {

/// The ranks' lists one after the other, on every rank; collective.
inline std::vector<int> gather_on_all(MPI_Comm world, const std::vector<int>& own) {
  int ranks = 1;
  MPI_Comm_size(world, &ranks);
  const int size = static_cast<int>(own.size());
  std::vector<int> sizes(ranks), starts(ranks, 0);
  MPI_Allgather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, world);
  for (int rank = 1; rank < ranks; ++rank) starts[rank] = starts[rank - 1] + sizes[rank - 1];
  std::vector<int> all(starts.back() + sizes.back());
  MPI_Allgatherv(own.data(), size, MPI_INT, all.data(), sizes.data(), starts.data(), MPI_INT,
                 world);
  return all;
}

}  // namespace LAMMPS_NS

#endif
