#pragma once

#include <cstdint>
#include <map>
#include <memory>

#include "mpi/mumps_factor.hpp"

namespace bempd::mpi {

// Factorized matrices, found by the numbers that rank 0 gave them; all ranks use the same numbers.
class Factors {
 public:
  explicit Factors(MPI_Comm comm) : comm_(comm) {}

  // Carries out an order on all ranks at once. `task` has the arrays of rank 0 and is null on all other ranks.
  Verdict perform(const Order& order, bempd_sparse_task* task) {
    if (order.request == BEMPD_SPARSE_FORGET) {
      factors_.erase(order.factor);
      return {};
    }
    if (order.request == BEMPD_SPARSE_ANALYSE) {
      factors_[order.factor] = std::make_unique<MumpsFactor>(comm_);
      return factors_[order.factor]->analyse(order, task);
    }
    const auto known = factors_.find(order.factor);
    if (known == factors_.end()) return {BEMPD_ERROR_INTERNAL, "there is no such factor"};
    return order.request == BEMPD_SPARSE_FACTORIZE ? known->second->factorize(order, task)
                                                   : known->second->solve(order, task);
  }
  bool has(std::int64_t factor) const { return factors_.contains(factor); }
  void clear() { factors_.clear(); }
  // Leaves the factors in memory, because MPI has ended and is needed to free them.
  void abandon() {
    for (auto& [number, factor] : factors_) static_cast<void>(factor.release());
  }

 private:
  MPI_Comm comm_;
  std::map<std::int64_t, std::unique_ptr<MumpsFactor>> factors_;
};

}  // namespace bempd::mpi
