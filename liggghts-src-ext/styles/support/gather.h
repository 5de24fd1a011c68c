// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_GATHER_H
#define RODPACK_GATHER_H

#include <mpi.h>
#include <vector>

namespace LAMMPS_NS {

/// Returns the records of all ranks, one after the other, on every rank; collective.
template <class Record>
std::vector<Record> gather_on_all(MPI_Comm world, const std::vector<Record>& own) {
  int ranks = 1;
  MPI_Comm_size(world, &ranks);
  const int bytes = static_cast<int>(own.size() * sizeof(Record));
  std::vector<int> sizes(ranks), starts(ranks, 0);
  MPI_Allgather(&bytes, 1, MPI_INT, sizes.data(), 1, MPI_INT, world);
  for (int rank = 1; rank < ranks; ++rank) starts[rank] = starts[rank - 1] + sizes[rank - 1];
  std::vector<Record> all((starts.back() + sizes.back()) / sizeof(Record));
  MPI_Allgatherv(own.data(), bytes, MPI_BYTE, all.data(), sizes.data(), starts.data(), MPI_BYTE,
                 world);
  return all;
}

/// Returns the records of all ranks, one after the other, on rank 0, and none elsewhere;
/// collective.
template <class Record>
std::vector<Record> gather_on_first(MPI_Comm world, const std::vector<Record>& own) {
  int rank = 0, ranks = 1;
  MPI_Comm_rank(world, &rank);
  MPI_Comm_size(world, &ranks);
  const int bytes = static_cast<int>(own.size() * sizeof(Record));
  std::vector<int> sizes(ranks), starts(ranks, 0);
  MPI_Gather(&bytes, 1, MPI_INT, sizes.data(), 1, MPI_INT, 0, world);
  for (int k = 1; k < ranks; ++k) starts[k] = starts[k - 1] + sizes[k - 1];
  std::vector<Record> all(rank == 0 ? (starts.back() + sizes.back()) / sizeof(Record) : 0);
  MPI_Gatherv(own.data(), bytes, MPI_BYTE, all.data(), sizes.data(), starts.data(), MPI_BYTE, 0,
              world);
  return all;
}

}  // namespace LAMMPS_NS

#endif
