#include <algorithm>

#include "bem/boundary_loads.hpp"
#include "error.hpp"
#include "regions/boundary/boundary_region.hpp"
#include "regions/boundary/region_cracks.hpp"

namespace bempd::regions {

std::vector<PlacedNode> BoundaryRegion::nodes_on(const EdgeSpan& span, double tolerance) const {
  const double slack = 10 * tolerance / span.geometry.length();
  std::vector<char> wanted(mesh_.nodes.size(), 0);
  for (const BoundaryElement& element : mesh_.elements) {
    if (panels_[element.panel].edge != span.edge) continue;
    for (int node : element.nodes) wanted[node] = 1;
  }
  std::vector<PlacedNode> found;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (!wanted[i] || node_of_mesh_node_[i] < 0) continue;
    const double along = closest_fraction(span.geometry, mesh_.nodes[i]);
    if (along < span.from - slack || along > span.to + slack) continue;
    found.push_back({node_of_mesh_node_[i], std::clamp((along - span.from) / (span.to - span.from), 0.0, 1.0)});
  }
  return found;
}

void BoundaryRegion::add_traction(const EdgeSpan& span, const std::function<Point(const Point&)>& traction,
                                  Eigen::Ref<Eigen::VectorXd> force) const {
  Eigen::VectorXd nodal = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(mesh_.nodes.size()));
  for (std::size_t panel = 0; panel < panels_.size(); ++panel) {
    const PanelSource& source = panels_[panel];
    const double middle = 0.5 * (source.from + source.to);
    if (source.edge != span.edge || middle < span.from || middle > span.to) continue;
    bem::add_traction_forces(mesh_, static_cast<int>(panel), traction, elasticity().thickness, nodal);
  }
  scatter(trace_.transpose() * nodal, force);
}

UniformBodyForce BoundaryRegion::particular(const Point& body_force) const {
  Box box;
  for (const Point& node : mesh_.nodes) box.extend(node);
  return {elasticity(), body_force, box.center()};
}

// With u = u_p + u_0, where u_p has the body force and u_0 none, nodal forces of the surface are K u_0 + f(t_p), so
// that in equilibrium  K u = f + K u_p - f(t_p)  (Brebbia and Dominguez, Boundary Elements, 2nd ed., section 3.9).
void BoundaryRegion::add_body_force(const Point& body_force, Eigen::Ref<Eigen::VectorXd> force) const {
  if (body_force == Point::Zero()) return;
  require(!cracks_, "region ", id(), " has cracks and a force per volume; one of them has to go");
  const UniformBodyForce particular = this->particular(body_force);
  Eigen::VectorXd displacement(2 * static_cast<Eigen::Index>(mesh_.nodes.size()));
  for (std::size_t i = 0; i < mesh_.nodes.size(); ++i)
    displacement.segment<2>(2 * static_cast<Eigen::Index>(i)) = particular.displacement(mesh_.nodes[i]);
  Eigen::VectorXd of_tractions = Eigen::VectorXd::Zero(displacement.size());
  bem::add_stress_forces(
      mesh_, [&](const Point& place) { return particular.stress(place); }, elasticity().thickness, of_tractions);
  scatter(trace_.transpose() * (mesh_stiffness() * displacement - of_tractions), force);
}

Eigen::VectorXd BoundaryRegion::displacement_without(const UniformBodyForce& particular,
                                                     const Solution& solution) const {
  Eigen::VectorXd displacement = trace_ * gather(solution.displacement);
  if (solution.body_force(id()) == Point::Zero()) return displacement;
  for (std::size_t i = 0; i < mesh_.nodes.size(); ++i)
    displacement.segment<2>(2 * static_cast<Eigen::Index>(i)) -= particular.displacement(mesh_.nodes[i]);
  return displacement;
}

bem::InteriorEvaluator BoundaryRegion::interior_without(const UniformBodyForce& particular,
                                                        const Solution& solution) const {
  const Eigen::VectorXd displacement = displacement_without(particular, solution);
  if (!cracks_) return {mesh_, elasticity(), displacement, operator_->tractions(displacement)};
  const bem::CrackedState state = cracked_state(solution);
  bem::InteriorEvaluator interior(mesh_, elasticity(), displacement, state.tractions);
  interior.set_cracks(bem::CrackField(cracked().boundary(), cracks_->elements(), elasticity().effective_poisson_ratio(),
                                      state.openings));
  return interior;
}

}  // namespace bempd::regions
