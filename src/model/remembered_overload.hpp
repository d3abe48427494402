#pragma once

#include <vector>

#include "crack/laws/retardation.hpp"
#include "crack/tip.hpp"
#include "geometry/point.hpp"

namespace bempd::model {

// Overload that a tip has met, at the place at which a call of growth by cycles left the tip.
struct RememberedOverload {
  crack::TipId tip;
  Point place{0, 0};
  crack::Overload overload;
  double waiting = 0;  // growth of a line by cycles by which it has not been extended yet, less than a spacing [m]
};

// Overloads as numbers in states, and back; a growth that waits is a row of its own. Throws Error (argument) for
// numbers that are none.
std::vector<double> numbers_of(const std::vector<RememberedOverload>& overloads);
std::vector<RememberedOverload> overloads_of(const std::vector<double>& numbers);

}  // namespace bempd::model
