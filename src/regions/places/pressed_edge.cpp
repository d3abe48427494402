#include "regions/places/pressed_edge.hpp"

#include <algorithm>

namespace bempd::regions {

// The traction of a pressure points inwards, to the left of the edge's direction, because the body lies on the left of
// its edges.
Point PressedEdge::traction(const Edge& edge, double fraction, const Point& value) const {
  const Point along = edge.tangent(std::clamp(fraction, 0.0, 1.0)).normalized();
  return value.x() * Point(-along.y(), along.x());
}

}  // namespace bempd::regions
