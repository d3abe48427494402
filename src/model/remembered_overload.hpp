#pragma once

#include <vector>

#include "crack/laws/retardation.hpp"
#include "crack/tip.hpp"
#include "geometry/point.hpp"

namespace bempd::model {

// Overload that a tip has met, remembered at the place where a call of growth by cycles left the tip.
struct RememberedOverload {
  crack::TipId tip;
  Point place{0, 0};
  crack::Overload overload;
  // Growth of a crack line by cycles that is less than a spacing, so that the crack has not been extended by it yet
  // [m].
  double waiting = 0;
};

// Conversion of overloads to the numbers that states store, and back. The waiting growth of a tip has a row of its own.
// overloads_of() throws Error (argument) for numbers that numbers_of() cannot have written.
std::vector<double> numbers_of(const std::vector<RememberedOverload>& overloads);
std::vector<RememberedOverload> overloads_of(const std::vector<double>& numbers);

}  // namespace bempd::model
