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

// Candidate of a tip that reaches its toughness at a critical load factor and has this ratio where the way begins.
inline Candidate candidate(const TipId& tip, double critical, double ratio, const LoadWay& way) {
  return {tip, critical, ratio, way.control == Control::load && ratio > 1 + tie_share};
}

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
