#pragma once

#include <map>
#include <utility>

#include "regions/region.hpp"

namespace bempd::results {

// Fields of regions under one solution, computed when they are first asked for.
class FieldCache {
 public:
  // `generation` tells solutions apart: fields of another one are forgotten.
  const regions::FieldValues& of(const regions::Region& region, regions::Field field, const regions::Solution& solution,
                                 std::int64_t generation);

 private:
  std::int64_t generation_ = 0;
  std::map<std::pair<int, regions::Field>, regions::FieldValues> fields_;  // by region id
};

// One entry a bond of the region: `intact` and `cut` are those of the scene.
std::vector<regions::BondState> bond_states(const regions::Region& region, const std::vector<char>& intact,
                                            const std::vector<int>& cut);

}  // namespace bempd::results
