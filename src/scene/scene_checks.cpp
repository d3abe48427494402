#include <algorithm>

#include "error.hpp"
#include "geometry/arrangement.hpp"
#include "scene/scene.hpp"

namespace bempd::scene {

namespace {

// Whether the outline `inner` lies inside the outer loop of `outer`, in which a hole could make room for it.
bool lies_inside(const Outline& inner, const Outline& outer, double tolerance) {
  const std::vector<Point>& vertices = inner.loops.front();
  return std::all_of(vertices.begin(), vertices.end(), [&](const Point& vertex) {
    return locate(Outline{{outer.loops.front()}, {}}, vertex, tolerance) != Location::outside;
  });
}

}  // namespace

// Rejects a lattice region that overlaps another one. Regions with elements are not checked, because their edges may
// become arcs later. A region inside another region passes, because a hole may be added later.
void Scene::require_no_overlap(const Region& added) const {
  if (added.has_elements()) return;
  const Box own = bempd::bounding_box(added.outline());
  for (int id : region_ids()) {
    const Outline& other = region(id).outline();
    const Box box = bempd::bounding_box(other);
    if (region(id).has_elements() || !box.intersects(own)) continue;
    // Overlaps narrower than this share of a spacing may lie within the tolerance if the body becomes larger, and count
    // as touching then.
    if (own.intersection(box).sizes().minCoeff() < 1e-3 * added.resolution()) continue;
    const double tolerance = geometric_tolerance(own.merged(box));
    if (lies_inside(added.outline(), other, tolerance) || lies_inside(other, added.outline(), tolerance)) continue;
    const auto overlap = arrange({other, added.outline()}).overlap;
    if (!overlap) continue;
    require(false, "the region overlaps region ", id, " near (", overlap->where.x(), ", ", overlap->where.y(),
            "); regions may only share boundaries");
  }
}

// Rejects a crack outside of the bounding box of all regions. Whether a crack misses all material points is not checked
// here: which points exist depends on the option `scheme`, which may be changed later.
void Scene::require_possible_crack(const std::vector<Point>& points) const {
  if (region_ids().empty()) return;
  Box crack;
  for (const Point& p : points) crack.extend(p);
  const Box body = bounding_box();
  require(crack.intersects(body), "the crack lies outside the body, which reaches from (", body.min().x(), ", ",
          body.min().y(), ") to (", body.max().x(), ", ", body.max().y(), "); add its regions first");
}

}  // namespace bempd::scene
