#pragma once

#include <vector>

#include "coupling/affine.hpp"
#include "regions/region.hpp"

namespace bempd::model {

struct PreparedScene;

// Cached stress intensity factors of tips with elements, as growth needs them (without error estimates), and the state
// that they belong to.
struct TipFactors {
  const PreparedScene* scene = nullptr;  // null: to be found anew
  coupling::Affine displacement;
  std::vector<char> closed;
  std::vector<regions::TipValues> tips;
};

}  // namespace bempd::model
