#include "results/field_cache.hpp"

namespace bempd::results {

using regions::BondState;

const regions::FieldValues& FieldCache::of(const regions::Region& region, regions::Field field,
                                           const regions::Solution& solution, std::int64_t generation) {
  if (generation_ != generation) {
    fields_.clear();
    generation_ = generation;
  }
  const auto key = std::make_pair(region.id(), field);
  const auto found = fields_.find(key);
  if (found != fields_.end()) return found->second;
  return fields_.emplace(key, region.field(field, solution)).first->second;
}

std::vector<BondState> bond_states(const regions::Region& region, const std::vector<char>& intact,
                                   const std::vector<int>& cut) {
  const std::size_t first = region.first_bond();
  std::vector<BondState> states(region.bonds()->size());
  for (std::size_t b = 0; b < states.size(); ++b) states[b] = intact[first + b] ? BondState::intact : BondState::broken;
  for (const int bond : cut) {
    const auto b = static_cast<std::size_t>(bond);
    if (b >= first && b < first + states.size()) states[b - first] = BondState::cut;
  }
  return states;
}

}  // namespace bempd::results
