#include "regions/swelling.hpp"

#include <algorithm>

#include "regions/lattice/lattice_swelling.hpp"

namespace bempd::regions {

namespace {

Swelling swelling_of(const SwellingOfRegions& swelling, int region) {
  const auto found = swelling.find(region);
  if (found == swelling.end()) return [](const Point&) { return Eigen::Vector2d(0, 0); };
  return [parts = found->second](const Point& place) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const Swelling& part : parts) sum += part(place);
    return sum;
  };
}

void swell_all(const Discretization& d, const SwellingOfRegions& swelling, LatticeSwelling& lattices) {
  for (const auto& region : d.regions)
    if (RegionSwelling* own = region->swelling()) own->swell(swelling_of(swelling, region->id()), lattices);
}

}  // namespace

void swell(Discretization& d, const SwellingOfRegions& swelling) {
  if (swelling.empty()) return;
  LatticeSwelling lattices(d.positions);
  swell_all(d, swelling, lattices);
  for (const auto& region : d.regions)
    if (const RegionSwelling* own = region->swelling()) own->set_rests(lattices, d.bonds);
}

std::array<std::vector<double>, 2> changed_rest_elongations(Discretization& d, const SwellingOfRegions& swelling,
                                                            const coupling::Terms& terms) {
  LatticeSwelling lattices(d.positions);
  coupling::Terms rests;  // only what set_rests() reads and writes
  rests.length = terms.length;
  swell_all(d, swelling, lattices);
  for (const auto& region : d.regions)
    if (const RegionSwelling* own = region->swelling()) own->set_rests(lattices, rests);
  return std::move(rests.rest_elongation);
}

}  // namespace bempd::regions
