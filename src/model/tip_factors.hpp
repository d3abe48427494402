#pragma once

#include <vector>

#include "coupling/affine.hpp"
#include "regions/tip_values.hpp"

namespace bempd::model {

struct PreparedScene;

// Cached stress intensity factors of tips with boundary elements, as growth needs them (without error estimates), and
// the state of the body to which they belong.
struct TipFactors {
  const PreparedScene* scene = nullptr;  // null: the factors have to be computed
  coupling::Affine displacement;
  std::vector<char> closed;
  std::vector<regions::TipValues> tips;
};

}  // namespace bempd::model
