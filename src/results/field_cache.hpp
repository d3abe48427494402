#pragma once

#include <functional>
#include <map>
#include <utility>

#include "regions/region.hpp"

namespace bempd::results {

// Cache of the fields of regions under one solution; a field is computed when it is first asked for.
class FieldCache {
 public:
  using Key = std::pair<int, regions::Field>;  // region id

  // Field of a region. `generation` numbers the solutions: with a new number all stored fields are dropped. `compute`
  // is called if the field is not stored.
  const regions::FieldValues& of(const Key& key, std::int64_t generation,
                                 const std::function<regions::FieldValues()>& compute);

 private:
  std::int64_t generation_ = 0;
  std::map<Key, regions::FieldValues> fields_;
};

// States of a region's bonds, one entry per bond. `intact` (flags) and `cut` (numbers of bonds) refer to all bonds of
// the scene.
std::vector<regions::BondState> bond_states(const regions::Region& region, const std::vector<char>& intact,
                                            const std::vector<int>& cut);

}  // namespace bempd::results
