#include "regions/places/turning_region.hpp"

#include "error.hpp"

namespace bempd::regions {

void TurningRegion::check(const scene::Scene& scene) const {
  WholeRegion::check(scene);
  require(axis_.allFinite(), "the axis is at (", axis_.x(), ", ", axis_.y(),
          "); its coordinates must be finite numbers");
}

}  // namespace bempd::regions
