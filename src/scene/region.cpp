#include "scene/region.hpp"

namespace bempd::scene {

int Region::edge_count() const {
  std::size_t count = 0;
  for (const auto& loop : outline_.loops) count += loop.size();
  return static_cast<int>(count);
}

}  // namespace bempd::scene
