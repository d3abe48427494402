#pragma once

#include <dmumps_c.h>
#include <mpi.h>

#include <cstdint>
#include <string>
#include <vector>

#include "bempd.h"
#include "mpi/messages.hpp"

namespace bempd::mpi {

// Factor of one matrix by MUMPS, distributed over the ranks of a communicator. All ranks call the same functions in the
// same order. `task` has the arrays of rank 0 and is null on all other ranks.
class MumpsFactor {
 public:
  explicit MumpsFactor(MPI_Comm comm);
  ~MumpsFactor();
  MumpsFactor(const MumpsFactor&) = delete;
  MumpsFactor& operator=(const MumpsFactor&) = delete;

  Verdict analyse(const Order& order, const bempd_sparse_task* task);
  Verdict factorize(const Order& order, bempd_sparse_task* task);
  Verdict solve(const Order& order, bempd_sparse_task* task);

 private:
  void set_controls();
  Verdict use_scratch(const std::string& folder);
  Verdict share_pattern(const Order& order, const bempd_sparse_task* task);
  Verdict share_values(const Order& order, const bempd_sparse_task* task);
  void name_kept(const Order& order, const bempd_sparse_task* task);
  Verdict run(int job);
  Verdict verdict(const char* doing) const;
  // Index of the first of the matrix entries that a rank holds; for the rank number `ranks_`, the number of all
  // entries.
  std::int64_t first_entry(std::int64_t entries, int rank) const {
    return entries / ranks_ * rank + std::min<std::int64_t>(entries % ranks_, rank);
  }

  MPI_Comm comm_;
  int rank_ = 0, ranks_ = 1;
  DMUMPS_STRUC_C mumps_{};
  bool is_started_ = false;
  std::string scratch_;
  std::vector<int> rows_, columns_;  // rows and columns of this rank's entries, counted from 1
  std::vector<double> values_;       // values of this rank's entries, during a factorization
  // Position of each unknown in the order of elimination; and the numbers of the kept unknowns. Both are on rank 0 and
  // count from 1.
  std::vector<int> position_, kept_;
};

}  // namespace bempd::mpi
