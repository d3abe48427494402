#include "regions/boundary/boundary_region.hpp"

#include <utility>

namespace bempd::regions {

BoundaryRegion::BoundaryRegion(int id, const scene::Material& material, std::unique_ptr<const BoundaryMethod> method)
    : Region(id, material),
      method_(std::move(method)),
      mesh_(*this),
      swelling_(*this, mesh_),
      parts_(*this),
      operators_(*this, *method_, mesh_, parts_, swelling_),
      particulars_(*this, mesh_, parts_, operators_),
      loads_(*this, mesh_, parts_, particulars_),
      states_(*this, mesh_, parts_, operators_, swelling_, particulars_),
      cracks_(*this, mesh_, parts_, particulars_, states_),
      results_(*this, mesh_, swelling_, particulars_, states_) {}

void BoundaryRegion::mesh(const Preparation& preparation) {
  const MeshingRules rules = method_->meshing_rules(preparation.options);
  BoundaryPanels panels = parts_.find_cracks(preparation, rules);
  BoundaryMesh mesh = method_->make_mesh(panels.loops);
  parts_.cut_if_large(preparation, *method_, mesh, operators_.parts_before_growth(preparation));
  parts_.mesh_cracks(preparation.options, mesh, panels.sources);
  const RegionSubdomains* subdomains = parts_.subdomains();
  mesh_.take(std::move(mesh), std::move(panels.sources), subdomains ? subdomains->cut_nodes() : std::vector<Point>(),
             !rules.nodes_on_grids);
}

void BoundaryRegion::build(const Preparation& preparation, Contributions& contributions) {
  nodes_ = mesh_.number(preparation, contributions.registry, parts_.mouths());
  parts_.warn_of_gap(mesh_.mesh(), contributions.warnings);
  operators_.build(preparation);
}

void BoundaryRegion::add_statistics(RegionStatistics& statistics) const {
  statistics.boundary_nodes += static_cast<std::int64_t>(mesh_.mesh().nodes.size());
  statistics.boundary_elements += static_cast<std::int64_t>(mesh_.mesh().elements.size());
  for (const CrackedPart& part : parts_.cracked())
    statistics.boundary_elements += static_cast<std::int64_t>(part.elements().elements.size());
  statistics.seconds_boundary += seconds_preparing;
  operators_.add_statistics(statistics);
}

}  // namespace bempd::regions
