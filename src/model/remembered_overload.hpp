#pragma once

#include "crack/laws/retardation.hpp"
#include "crack/tip.hpp"
#include "geometry/point.hpp"

namespace bempd::model {

// Overload that a tip has met, at the place at which a call of growth by cycles left the tip.
struct RememberedOverload {
  crack::TipId tip;
  Point place{0, 0};
  crack::Overload overload;
};

}  // namespace bempd::model
