#include "error.hpp"
#include "regions/boundary/boundary_region.hpp"
#include "regions/boundary/region_cracks.hpp"
#include "regions/boundary/region_subdomains.hpp"
#include "regions/memory_limit.hpp"

// Subdomains: parts with operators of their own, into which a large region without cracks is cut.
namespace bempd::regions {

double BoundaryRegion::memory_of_preparing(double times) const {
  if (!cracks_) return least_memory_of_region(times * static_cast<double>(mesh_.elements.size()));
  return RegionCracks::memory_of(times *
                                 static_cast<double>(mesh_.elements.size() + cracks_->elements().elements.size()));
}

const std::vector<Point>& BoundaryRegion::places() const { return subdomains_ ? subdomains_->places() : mesh_.nodes; }

void BoundaryRegion::cut_if_large(const Preparation& preparation) {
  if (can_be_cut() && !elasticity().incompressible()) subdomains_ = RegionSubdomains::of(mesh_, preparation.options);
  if (subdomains_) return subdomains_->require_memory(preparation.options);
  const auto elements = static_cast<double>(mesh_.elements.size());
  if (const double bytes = memory_of_operator(elements); bytes > least_memory_of_region(elements))
    require_memory_for(bytes, text("the ", elements, " boundary elements of region ", id(), " in one piece"),
                       "choose longer elements, or divide the region into several", preparation.options);
}

std::vector<OperatorNodes> BoundaryRegion::nodes_of_operators() const {
  if (!subdomains_) return {{nodes_, rest_}};
  return subdomains_->nodes_of_operators(nodes_, trace_, rest_);
}

}  // namespace bempd::regions
