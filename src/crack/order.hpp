#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "crack/tip.hpp"

namespace bempd::crack {

// Load factors or ratios that differ by less than this share are a tie: rounding may put either first.
constexpr double tie_share = 1e-9;

// A tip that may grow next.
struct Candidate {
  TipId tip;
  double load_factor = 0;   // at which it grows
  double ratio = 1;         // of its equivalent factor to its toughness, at the present load factor
  bool overloaded = false;  // at the present load factor
};

struct FirstToGrow {
  std::size_t index;  // among the candidates
  int ties;           // others that would grow as soon, but for rounding
};

// The tip that grows first. Of overloaded tips it is the one with the largest ratio; otherwise the one with the nearest
// load factor on the way. Of tips that tie it is that of the crack with the smallest id, and the start of a crack
// before its end, so that neither rounding nor the turn of a body decides. Null without candidates.
std::optional<FirstToGrow> first_to_grow(std::span<const Candidate> candidates, bool upwards);

}  // namespace bempd::crack
