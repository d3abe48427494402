#pragma once

#include <vector>

#include "coupling/terms.hpp"
#include "pd/weakened_term.hpp"

namespace bempd::fracture {

// Stiffness of all terms (bonds and cell squares) in the intact lattice: terms that are weakened at the end of a crack
// have their whole stiffness.
inline std::vector<double> whole_stiffness(const coupling::Terms& terms,
                                           const std::vector<pd::WeakenedTerm>& weakened) {
  std::vector<double> stiffness = terms.stiffness;
  for (const pd::WeakenedTerm& weak : weakened) stiffness[static_cast<std::size_t>(weak.term)] /= weak.share;
  return stiffness;
}

}  // namespace bempd::fracture
