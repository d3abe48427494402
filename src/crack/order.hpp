#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "crack/tip.hpp"

namespace bempd::crack {

// Relative difference of load factors or ratios below which they are a tie: rounding may put either first.
constexpr double tie_share = 1e-9;

// Tip that may grow next.
struct Candidate {
  TipId tip;
  double load_factor = 0;   // load factor at which it grows
  double ratio = 1;         // of its equivalent factor to its toughness, at the present load factor
  bool overloaded = false;  // at the present load factor
};

struct FirstToGrow {
  std::size_t index;  // among the candidates
  int ties;           // others that would grow as soon, but for rounding
};

// Tip that grows first. Of overloaded tips it is the one with the largest ratio; otherwise the one with the nearest
// load factor in the direction of the load path. Of tips that tie it is that of the crack with the smallest id, and the
// start of a crack before its end, so that neither rounding nor the orientation of a body decides. Empty without
// candidates.
std::optional<FirstToGrow> first_to_grow(std::span<const Candidate> candidates, bool upwards);

}  // namespace bempd::crack
