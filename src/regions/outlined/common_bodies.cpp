#include "regions/outlined/common_bodies.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include "regions/lattice/acting_as_one.hpp"
#include "regions/outlined/outlined_region.hpp"

namespace bempd::regions {

namespace {

// Whether a support or a load acts along a common edge of two of the regions (ids, ascending).
bool has_condition_on_common_edge(const std::vector<int>& regions, const Preparation& p) {
  for (const Contact& c : p.arrangement.contacts) {
    const auto has = [&](int region) { return std::binary_search(regions.begin(), regions.end(), region + 1); };
    if (!has(c.region) || !has(c.other_region)) continue;
    const int region = c.region + 1, edge = c.edge + 1;
    for (const auto* conditions : {&p.scene.supports(), &p.scene.loads()}) {
      for (const scene::Condition& condition : *conditions) {
        if (condition.removed() || condition.place->edge() != std::pair(region, edge)) continue;
        if (condition.place->covers(region, edge, 0.5 * (c.from + c.to))) return true;
        for (const double f : condition.place->breaks_on(p.scene, region, edge, p.tolerance))
          if (c.from < f && f < c.to) return true;
      }
    }
  }
  return false;
}

const PeridynamicDescription* description_of(const Preparation& p, int region) {
  return dynamic_cast<const PeridynamicDescription*>(&p.scene.region(region));
}

// Whether two regions (ids) form one body where they touch along an edge: both are lattices of one spacing, horizon and
// angle, and their materials have the same numbers.
bool are_one_lattice(const Preparation& p, int first, int second) {
  const auto *one = description_of(p, first), *other = description_of(p, second);
  return one && other && one->has_lattice_of(*other) && p.scene.material_of(first) == p.scene.material_of(second);
}

}  // namespace

std::vector<OutlinedRegion*> regions_acting_as_one(OutlinedRegion& region, const Preparation& preparation) {
  const auto outlined = [&](int id) { return region_as<OutlinedRegion>(preparation, id); };
  const std::vector<int> ids = regions_touching(region.id(), preparation.arrangement, [&](int first, int second) {
    return outlined(second) && are_one_lattice(preparation, first, second);
  });
  if (ids.size() > 1 && has_condition_on_common_edge(ids, preparation)) return {&region};
  std::vector<OutlinedRegion*> found;
  for (const int id : ids) found.push_back(outlined(id));
  return found;
}

std::vector<int> regions_leaving_rows(const Preparation& preparation) {
  const auto is_on_rows = [&](int region) { return description_of(preparation, region)->lattice().has_value(); };
  std::vector<int> leaving;
  std::set<int> seen;
  for (const int id : preparation.scene.region_ids()) {
    // Each body is found from one of its regions whose outline follows no lattice rows.
    if (!description_of(preparation, id) || is_on_rows(id) || seen.count(id) > 0) continue;
    const std::vector<int> body = regions_touching(id, preparation.arrangement, [&](int first, int second) {
      return are_one_lattice(preparation, first, second);
    });
    seen.insert(body.begin(), body.end());
    if (has_condition_on_common_edge(body, preparation)) continue;
    std::copy_if(body.begin(), body.end(), std::back_inserter(leaving), is_on_rows);
  }
  std::sort(leaving.begin(), leaving.end());
  return leaving;
}

}  // namespace bempd::regions
