#pragma once

#include <vector>

#include "coupling/affine.hpp"
#include "regions/region.hpp"

namespace bempd::model {

struct PreparedScene;

// Tips with elements without errors, as growth needs them, and of which state they are.
struct TipFactors {
  const PreparedScene* scene = nullptr;  // null: to be found anew
  coupling::Affine displacement;
  std::vector<char> closed;
  std::vector<regions::TipValues> tips;
};

}  // namespace bempd::model
