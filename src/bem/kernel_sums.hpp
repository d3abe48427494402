#pragma once

#include "bem/pair_integrals.hpp"

namespace bempd::bem {

// Adds the integrals over a pair of intervals apart by the product of their
// rules.
void add_kernel_sums(const ElementPoints& outer, const ElementPoints& inner, PairPart part, PairMoments& moments);

}  // namespace bempd::bem
