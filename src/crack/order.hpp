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
  double load_factor = 0;   // load factor at which the tip grows
  double ratio = 1;         // equivalent factor over toughness, at the present load factor
  bool overloaded = false;  // exceeds its toughness at a load factor that is held constant
};

// Makes the candidate of a tip that reaches its toughness at the load factor `critical`; `ratio` is the equivalent
// factor over the toughness at the present load factor of `way`.
inline Candidate candidate(const TipId& tip, double critical, double ratio, const LoadWay& way) {
  return {tip, critical, ratio, way.control == Control::load && ratio > 1 + tie_share};
}

struct FirstToGrow {
  std::size_t index;  // index of the candidate
  int ties;           // number of other candidates that would grow at the same load factor, up to rounding
};

// Finds the tip that grows first. Overloaded tips come before all others, those with the largest ratio of equivalent
// factor to toughness first; the others are ordered by load factor along the load path. In a tie the crack with the
// smallest id grows, and its start before its end, so that neither rounding nor the orientation of a body decides.
// Empty if there are no candidates.
std::optional<FirstToGrow> first_to_grow(std::span<const Candidate> candidates, bool upwards);

}  // namespace bempd::crack
