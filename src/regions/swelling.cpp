#include "regions/swelling.hpp"

#include <algorithm>

#include "regions/lattice/lattice_swelling.hpp"

namespace bempd::regions {

void swell(Discretization& d, const SwellingOfRegions& swelling) {
  if (swelling.empty()) return;
  const auto of = [&](int region) -> Swelling {
    const auto found = swelling.find(region);
    if (found == swelling.end()) return [](const Point&) { return Eigen::Vector2d(0, 0); };
    return [parts = found->second](const Point& place) {
      Eigen::Vector2d sum = Eigen::Vector2d::Zero();
      for (const Swelling& part : parts) sum += part(place);
      return sum;
    };
  };
  LatticeSwelling lattices(d.positions);
  for (const auto& region : d.regions) region->swell(of(region->id()), lattices);
  for (const auto& region : d.regions) region->set_rests(lattices, d.bonds);
}

}  // namespace bempd::regions
