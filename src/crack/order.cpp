#include "crack/order.hpp"

#include <cmath>

namespace bempd::crack {

namespace {

// Rank of a candidate tip for growth. Overloaded tips do not wait: they come before tips that wait for a load factor.
// Otherwise the smaller key comes first: for overloaded tips minus the ratio of equivalent factor to toughness, for
// waiting tips the load factor of growth along the load path.
struct Rank {
  bool waits;
  double key;

  bool is_before(const Rank& other) const { return waits != other.waits ? other.waits : key < other.key; }
  bool ties_with(const Rank& other) const {
    return waits == other.waits && (key == other.key || std::abs(key - other.key) <= tie_share * std::abs(other.key));
  }
};

Rank rank_of(const Candidate& candidate, bool upwards) {
  if (candidate.overloaded) return {false, -candidate.ratio};
  return {true, upwards ? candidate.load_factor : -candidate.load_factor};
}

}  // namespace

// Finds the tip that grows first. Ties are measured from the first rank, so that they do not depend on the order of the
// list of candidates.
std::optional<FirstToGrow> first_to_grow(std::span<const Candidate> candidates, bool upwards) {
  if (candidates.empty()) return std::nullopt;
  Rank first = rank_of(candidates.front(), upwards);
  for (const Candidate& candidate : candidates)
    if (const Rank rank = rank_of(candidate, upwards); rank.is_before(first)) first = rank;
  std::optional<FirstToGrow> found;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    if (!rank_of(candidates[k], upwards).ties_with(first)) continue;
    if (!found) {
      found = FirstToGrow{k, 0};
      continue;
    }
    ++found->ties;
    if (candidates[k].tip < candidates[found->index].tip) found->index = k;
  }
  return found;
}

}  // namespace bempd::crack
