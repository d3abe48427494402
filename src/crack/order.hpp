#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "crack/load_way.hpp"
#include "crack/tip.hpp"

namespace bempd::crack {

// Tip that may grow next.
struct Candidate {
  TipId tip;
  double load_factor = 0;   // load factor at which it grows
  double ratio = 1;         // of its equivalent factor to its toughness, at the present load factor
  bool overloaded = false;  // at the present load factor
};

// Makes the candidate of a tip that reaches its toughness at the load factor `critical`; `ratio` is its growth ratio at
// the present load factor of `way`.
inline Candidate candidate(const TipId& tip, double critical, double ratio, const LoadWay& way) {
  return {tip, critical, ratio, way.control == Control::load && ratio > 1 + tie_share};
}

struct FirstToGrow {
  std::size_t index;  // among the candidates
  int ties;           // others that would grow as soon, but for rounding
};

// Finds the tip that grows first. Overloaded tips come first, by the largest ratio; then tips by the nearest load
// factor in the direction of the load path. In a tie the crack with the smallest id grows, and its start before its
// end, so that neither rounding nor the orientation of a body decides. Empty if there are no candidates.
std::optional<FirstToGrow> first_to_grow(std::span<const Candidate> candidates, bool upwards);

}  // namespace bempd::crack
