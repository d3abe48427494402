#include "regions/places/crack_faces.hpp"

#include "error.hpp"
#include "regions/boundary_conditions.hpp"

namespace bempd::regions {

void CrackFaces::check(const scene::Scene& scene) const { scene.crack(crack_); }

std::vector<PlacedNode> CrackFaces::held_nodes(const scene::Scene&, const Discretization&, int support) const {
  fail(Failure::argument, "support ", support + 1, " holds the faces of crack ", crack_,
       "; supports hold edges and points");
}

void CrackFaces::add_load(const scene::Scene& scene, const Discretization& d, int load,
                          DofConditions& conditions) const {
  require(!d.cracks[static_cast<std::size_t>(crack_) - 1].cuts_bonds(), "load ", load + 1,
          " acts on the faces of crack ", crack_,
          ", which lies in a peridynamic region, if only in part; faces can be given a traction in BEM regions only, "
          "and a uniform pressure by bempd_add_crack_pressure() in both kinds");
  add_to_elements(scene, d, load, conditions);
}

void CrackFaces::add_to_elements(const scene::Scene& scene, const Discretization& d, int load,
                                 DofConditions& conditions) const {
  // A copy of the condition is stored, because the host may change its values while this result is in use.
  const scene::Condition condition = scene.loads()[load];
  conditions.crack_loads.push_back({crack_, [condition](double fraction) -> std::array<Point, 2> {
                                      const auto value = condition.acting_value(Point::Zero(), fraction);
                                      return {value.constant, value.proportional};
                                    }});
  for (const auto& region : d.regions) {
    if (!d.cracks[static_cast<std::size_t>(crack_) - 1].has_elements_in(region->id())) continue;
    for (int part = 0; part < 2; ++part)
      region->crack_elements()->add_load(conditions.crack_loads.back(), part, conditions.force.col(part));
  }
}

}  // namespace bempd::regions
