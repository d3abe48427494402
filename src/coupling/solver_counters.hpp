#pragma once

#include <cstdint>

namespace bempd::coupling {

struct SolverCounters {
  std::int64_t sparse_unknowns = 0;
  std::int64_t factor_nonzeros = 0;
  std::int64_t dense_factorizations = 0;
  std::int64_t sparse_factorizations = 0;
  std::int64_t factor_updates = 0;
  std::int64_t matrices = 0;  // rises when the factor may belong to another matrix
  std::int64_t solves = 0;
  std::int64_t iterations = 0;
  double reciprocal_condition = 1;  // smallest estimate of all factorizations
  double seconds_assembly = 0;
  double seconds_factorization = 0;
  double seconds_solve = 0;
  double seconds_update = 0;
};

}  // namespace bempd::coupling
