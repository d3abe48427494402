#include "results/field_cache.hpp"

#include <algorithm>
#include <cmath>

#include "error.hpp"

namespace bempd::results {

using regions::BondState;

const regions::FieldValues& FieldCache::of(const Key& key, std::int64_t generation,
                                           const std::function<regions::FieldValues()>& compute) {
  if (generation_ != generation) {
    fields_.clear();
    generation_ = generation;
  }
  const auto found = fields_.find(key);
  if (found != fields_.end()) return found->second;
  regions::FieldValues computed = compute();
  if (!std::all_of(computed.values.begin(), computed.values.end(), [](double value) { return std::isfinite(value); })) {
    fail(Failure::unsolvable, "a value of this field of region ", key.first,
         " is beyond the range of numbers; choose other units, or smaller loads");
  }
  return fields_.emplace(key, std::move(computed)).first->second;
}

std::vector<BondState> bond_states(const regions::Region& region, const std::vector<char>& intact,
                                   const std::vector<int>& cut) {
  const std::size_t first = region.bonds()->first_bond();
  std::vector<BondState> states(region.bonds()->list().size());
  for (std::size_t b = 0; b < states.size(); ++b) states[b] = intact[first + b] ? BondState::intact : BondState::broken;
  for (const int bond : cut) {
    const auto b = static_cast<std::size_t>(bond);
    if (b >= first && b < first + states.size()) states[b - first] = BondState::cut;
  }
  return states;
}

}  // namespace bempd::results
