#include "regions/boundary/boundary_swelling.hpp"

#include <utility>

#include "error.hpp"

namespace bempd::regions {

void BoundarySwelling::swell(const Swelling& strain, LatticeSwelling&) {
  const std::vector<Point>& places = mesh_.places();
  std::optional<FreeSwelling> free_swelling = FreeSwelling::through(places, strain);
  require(free_swelling.has_value(), "region ", region_.id(),
          " is a BEM region, and its temperature is not linear in x and y; boundary elements know nothing of others: "
          "make it a peridynamic region, or several regions");
  free_swelling_ = std::move(free_swelling);
  rest_ = coupling::Affine::Zero(2 * static_cast<Eigen::Index>(region_.nodes().size()), 2);
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool is_slaved = i < mesh_.scene_nodes().size() && mesh_.scene_nodes()[i] < 0;
    if (!is_slaved) rest_.middleRows<2>(2 * row++) = free_swelling_->displacement(places[i]);
  }
}

std::optional<Eigen::Matrix2d> BoundarySwelling::free_displacement(const Point& place) const {
  return free_swelling_ ? free_swelling_->displacement(place) : Eigen::Matrix2d::Zero();
}

}  // namespace bempd::regions
