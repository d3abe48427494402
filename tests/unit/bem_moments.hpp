// What tests of pairs of elements ask of their moments.
#pragma once

#include "bem/pair_integrals.hpp"

namespace bempd::bem {

inline double total(const PairMoments::Block& block) {
  double sum = 0;
  for (const auto& row : block)
    for (const double value : row) sum += value;
  return sum;
}

}  // namespace bempd::bem
