#pragma once

#include <functional>
#include <map>
#include <utility>

#include "regions/region.hpp"

namespace bempd::results {

// Fields of regions under one solution, computed when they are first asked for.
class FieldCache {
 public:
  using Key = std::pair<int, regions::Field>;  // region id

  // `generation` tells solutions apart: fields of another one are forgotten.
  const regions::FieldValues& of(const Key& key, std::int64_t generation,
                                 const std::function<regions::FieldValues()>& compute);

 private:
  std::int64_t generation_ = 0;
  std::map<Key, regions::FieldValues> fields_;
};

// States of a region's bonds, one entry a bond: `intact` and `cut` are those of the scene.
std::vector<regions::BondState> bond_states(const regions::Region& region, const std::vector<char>& intact,
                                            const std::vector<int>& cut);

}  // namespace bempd::results
