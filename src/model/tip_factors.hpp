#pragma once

#include <vector>

#include "coupling/affine.hpp"
#include "regions/region.hpp"

namespace bempd::model {

struct PreparedScene;

// Factors of tips with elements, without error estimates, as growth needs them, and the state that they belong to.
struct TipFactors {
  const PreparedScene* scene = nullptr;  // null: to be found anew
  coupling::Affine displacement;
  std::vector<char> closed;
  std::vector<regions::TipValues> tips;
};

}  // namespace bempd::model
