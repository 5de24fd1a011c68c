// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_MPI_RANKS_H
#define RODPACK_MPI_RANKS_H

#include <mpi.h>
#include <utility>
#include <vector>
#include "rodpack/planar/ranks.h"

namespace LAMMPS_NS {

/// Sends to[r] to rank r and returns what all ranks sent here, in their order; collective.
/// `starts`, if given, is set to where the records of each rank begin, and to the end.
template <class Record>
std::vector<Record> exchange_records(MPI_Comm world, std::vector<std::vector<Record> > to,
                                     std::vector<size_t>* starts = NULL) {
  const int ranks = static_cast<int>(to.size());
  if (ranks == 1) {
    if (starts) *starts = {0, to[0].size()};
    return std::move(to[0]);
  }
  std::vector<int> out(ranks), in(ranks), out_starts(ranks + 1, 0), in_starts(ranks + 1, 0);
  for (int r = 0; r < ranks; ++r) out[r] = static_cast<int>(to[r].size());
  MPI_Alltoall(out.data(), 1, MPI_INT, in.data(), 1, MPI_INT, world);
  for (int r = 0; r < ranks; ++r) {
    out_starts[r + 1] = out_starts[r] + out[r];
    in_starts[r + 1] = in_starts[r] + in[r];
  }
  std::vector<Record> sent, received(in_starts[ranks]);
  sent.reserve(out_starts[ranks]);
  for (const std::vector<Record>& part : to) sent.insert(sent.end(), part.begin(), part.end());
  MPI_Datatype type;
  MPI_Type_contiguous(sizeof(Record), MPI_BYTE, &type);
  MPI_Type_commit(&type);
  MPI_Alltoallv(sent.data(), out.data(), out_starts.data(), type, received.data(), in.data(),
                in_starts.data(), type, world);
  MPI_Type_free(&type);
  if (starts) starts->assign(in_starts.begin(), in_starts.end());
  return received;
}

/// Sends the messages of the planar engine by MPI.
class MpiRanks : public rodpack::PlanarRanks {
 public:
  explicit MpiRanks(MPI_Comm world) : world_(world) {
    MPI_Comm_rank(world_, &rank_);
    MPI_Comm_size(world_, &count_);
  }

  int rank() const override { return rank_; }
  int count() const override { return count_; }

  std::vector<double> gather(const std::vector<double>& own) override {
    const int size = static_cast<int>(own.size());
    std::vector<double> all(own.size() * count_);
    MPI_Allgather(own.data(), size, MPI_DOUBLE, all.data(), size, MPI_DOUBLE, world_);
    return all;
  }

  void largest(double* values, int count) override {
    MPI_Allreduce(MPI_IN_PLACE, values, count, MPI_DOUBLE, MPI_MAX, world_);
  }

  void exchange(const std::vector<std::vector<double> >& to,
                std::vector<std::vector<double> >& from) override {
    std::vector<size_t> starts;
    const std::vector<double> all = exchange_records(world_, to, &starts);
    from.resize(count_);
    for (int r = 0; r < count_; ++r)
      from[r].assign(all.begin() + starts[r], all.begin() + starts[r + 1]);
  }

  void swap(std::vector<rodpack::PlanarLink>& links) override {
    requests_.clear();
    for (rodpack::PlanarLink& link : links) {
      if (link.in.empty()) continue;
      requests_.push_back(MPI_REQUEST_NULL);
      MPI_Irecv(link.in.data(), static_cast<int>(link.in.size()), MPI_DOUBLE, link.rank, 0, world_,
                &requests_.back());
    }
    for (rodpack::PlanarLink& link : links) {
      if (link.out_count == 0) continue;
      requests_.push_back(MPI_REQUEST_NULL);
      MPI_Isend(link.out.data(), link.out_count, MPI_DOUBLE, link.rank, 0, world_,
                &requests_.back());
    }
    MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE);
  }

 private:
  MPI_Comm world_;
  int rank_ = 0, count_ = 1;
  std::vector<MPI_Request> requests_;
};

}  // namespace LAMMPS_NS

#endif
