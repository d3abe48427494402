#include "regions/boundary/boundary_loads.hpp"

#include <algorithm>

#include "bem/boundary_loads.hpp"

namespace bempd::regions {

namespace {

// Whether a panel lies in a part of an edge. A common end is not enough: at the mouth of a crack there are two nodes,
// one of which belongs to a panel outside of the part. A part without length contains the panels around it.
bool lies_in(const EdgeSpan& span, const PanelSource& panel, double slack) {
  const double common = std::min(panel.to, span.to) - std::max(panel.from, span.from);
  return panel.edge == span.edge && (common > slack || span.to - span.from <= slack);
}

}  // namespace

std::vector<PlacedNode> BoundaryLoads::nodes_on(const EdgeSpan& span, double tolerance) const {
  const BoundaryMesh& mesh = mesh_.mesh();
  const double slack = 10 * tolerance / span.geometry.length();
  std::vector<char> wanted(mesh.nodes.size(), 0);
  for (const BoundaryElement& element : mesh.elements) {
    if (!lies_in(span, mesh_.source_of(element), slack)) continue;
    for (int node : element.nodes) wanted[node] = 1;
  }
  std::vector<PlacedNode> found;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (!wanted[i] || mesh_.scene_nodes()[i] < 0) continue;
    const double along = closest_fraction(span.geometry, mesh.nodes[i]);
    if (along < span.from - slack || along > span.to + slack) continue;
    found.push_back({mesh_.scene_nodes()[i], std::clamp((along - span.from) / (span.to - span.from), 0.0, 1.0)});
  }
  return found;
}

void BoundaryLoads::add_traction(const EdgeSpan& span, const std::function<Point(const Point&)>& traction,
                                 Eigen::Ref<Eigen::VectorXd> force) const {
  const BoundaryMesh& mesh = mesh_.mesh();
  Eigen::VectorXd nodal = Eigen::VectorXd::Zero(mesh_.trace().rows());
  for (std::size_t panel = 0; panel < mesh_.panels().size(); ++panel) {
    const PanelSource& source = mesh_.panels()[panel];
    const double middle = 0.5 * (source.from + source.to);
    if (source.edge != span.edge || middle < span.from || middle > span.to) continue;
    bem::add_traction_forces(mesh, static_cast<int>(panel), traction, region_.elasticity().thickness, nodal);
  }
  region_.scatter(mesh_.trace().transpose() * nodal, force);
}

std::vector<Point> BoundaryLoads::forces_on_edge(const EdgeSpan& span, const std::vector<int>& nodes_of_scene,
                                                 const FieldsOfRegion& fields) const {
  const BoundaryMesh& mesh = mesh_.mesh();
  const std::vector<double>& tractions = fields(Field::traction).values;
  Eigen::VectorXd nodal = Eigen::VectorXd::Zero(mesh_.trace().rows());
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (mesh_.source_of(mesh.elements[e]).edge != span.edge) continue;
    const Eigen::Map<const Eigen::Matrix<double, 2, 3>> at_nodes(&tractions[6 * e]);
    bem::add_traction_forces(mesh, mesh.elements[e], at_nodes, region_.elasticity().thickness, nodal);
  }
  const Eigen::VectorXd own = mesh_.trace().transpose() * nodal;
  std::vector<Point> forces;
  for (const int node : nodes_of_scene) {
    const auto place = std::find(region_.nodes().begin(), region_.nodes().end(), node) - region_.nodes().begin();
    forces.emplace_back(own.segment<2>(2 * static_cast<Eigen::Index>(place)));
  }
  return forces;
}

// Adds the nodal forces of a body force. The displacement is u = u_p + u_0, where the particular solution u_p is in
// equilibrium with the body force, and u_0 has no body force. With the stiffness K of the boundary, the nodal forces of
// the boundary's tractions are K u_0 + f_p, where f_p are those of the tractions of u_p. They equal the nodal forces f
// of the other loads if
//   K u = f + K u_p - f_p
// (Brebbia and Dominguez, Boundary Elements, 2nd ed., section 3.9). The function adds K u_p - f_p.
void BoundaryLoads::add_body_force(const BodyForce& body_force, Eigen::Ref<Eigen::VectorXd> force) const {
  if (body_force.is_zero()) return;
  region_.scatter(mesh_.trace().transpose() * particulars_.force_change(particulars_.of(body_force)), force);
}

Eigen::Matrix2d BoundaryLoads::work_within(const std::array<BodyForce, 2>& body_force,
                                           const std::vector<CrackLoad>& crack_loads) const {
  Eigen::Matrix2d work = Eigen::Matrix2d::Zero();
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) work(i, j) = particulars_.work(body_force[i], body_force[j]);
  for (const CrackedPart& part : parts_.cracked())
    work += part.work_of(part.forces_of(crack_loads), particulars_.in_part(body_force, part));
  return work;
}

}  // namespace bempd::regions
