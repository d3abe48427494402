#include <typeinfo>

#include "error.hpp"
#include "regions/boundary/boundary_region.hpp"
#include "regions/boundary/region_subdomains.hpp"
#include "regions/memory_limit.hpp"

// Subdomains: parts with operators of their own, into which a large region without cracks is cut.
namespace bempd::regions {

const std::vector<Point>& BoundaryRegion::places() const { return subdomains_ ? subdomains_->places() : mesh_.nodes; }

void BoundaryRegion::cut_if_large(const Preparation& preparation) {
  if (can_be_cut() && !elasticity().incompressible()) subdomains_ = RegionSubdomains::of(mesh_, preparation.options);
  if (subdomains_) return subdomains_->require_memory(preparation.options);
  const auto elements = static_cast<double>(mesh_.elements.size());
  if (const double bytes = memory_of_operator(elements); bytes > least_memory_of_region(elements))
    require_memory_for(bytes, text(elements, " boundary elements in one piece"), "choose longer elements",
                       preparation.options);
}

void BoundaryRegion::build_subdomains(const Preparation& preparation, const bem::AssemblyOptions& assembly) {
  std::vector<const RegionSubdomains*> before;
  for (const auto& other : preparation.regions) {
    if (other.get() == this) break;
    const Region& region = *other;
    if (typeid(region) != typeid(*this) || elasticity() != region.elasticity()) continue;
    if (const auto& alike = static_cast<const BoundaryRegion&>(region); alike.subdomains_)
      before.push_back(alike.subdomains_.get());
  }
  subdomains_->build(elasticity(), assembly, before);
}

std::vector<std::vector<int>> BoundaryRegion::nodes_of_operators() const {
  if (!subdomains_) return {nodes_};
  return subdomains_->nodes_of_operators(nodes_, trace_);
}

std::vector<coupling::Affine> BoundaryRegion::rests_of_operators() const {
  if (rest_.rows() == 0) return {};
  if (!subdomains_) return {rest_};
  return subdomains_->rests_of_operators(rest_, trace_);
}

FieldValues BoundaryRegion::element_stress_by_subdomains(const LinearBodyForce& particular,
                                                         const Solution& solution) const {
  const std::vector<bem::InteriorEvaluator> interiors =
      subdomains_->interiors(elasticity(), displacement_without(particular, solution));
  FieldValues field{std::vector<double>(9 * mesh_.elements.size()), 3};
  subdomains_->for_each_outline_element([&](std::size_t part, int element, int of_mesh) {
    const auto e = static_cast<std::size_t>(of_mesh);
    for (int k = 0; k < 3; ++k) {
      const Point& place = mesh_.nodes[static_cast<std::size_t>(mesh_.elements[e].nodes[static_cast<std::size_t>(k)])];
      Eigen::Map<Eigen::Vector3d> at(&field.values[9 * e + 3 * static_cast<std::size_t>(k)]);
      at = interiors[part].stress_on(element, k - 1) + particular.stress(place);
    }
  });
  return field;
}

}  // namespace bempd::regions
