#include <algorithm>

#include "bem/boundary_loads.hpp"
#include "error.hpp"
#include "regions/boundary/boundary_region.hpp"
#include "regions/boundary/region_cracks.hpp"
#include "regions/boundary/region_subdomains.hpp"

namespace bempd::regions {

namespace {

// A panel lies in a part of an edge if they have more than an end in common: of the lips at the mouth of a crack where
// the part ends, one belongs to a panel outside. Parts without length have the panels around them.
bool lies_in(const EdgeSpan& span, const PanelSource& panel, double slack) {
  const double common = std::min(panel.to, span.to) - std::max(panel.from, span.from);
  return panel.edge == span.edge && (common > slack || span.to - span.from <= slack);
}

}  // namespace

std::vector<PlacedNode> BoundaryRegion::nodes_on(const EdgeSpan& span, double tolerance) const {
  const double slack = 10 * tolerance / span.geometry.length();
  std::vector<char> wanted(mesh_.nodes.size(), 0);
  for (const BoundaryElement& element : mesh_.elements) {
    if (!lies_in(span, panels_[element.panel], slack)) continue;
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
  Eigen::VectorXd nodal = Eigen::VectorXd::Zero(trace_.rows());
  for (std::size_t panel = 0; panel < panels_.size(); ++panel) {
    const PanelSource& source = panels_[panel];
    const double middle = 0.5 * (source.from + source.to);
    if (source.edge != span.edge || middle < span.from || middle > span.to) continue;
    bem::add_traction_forces(mesh_, static_cast<int>(panel), traction, elasticity().thickness, nodal);
  }
  scatter(trace_.transpose() * nodal, force);
}

std::vector<Point> BoundaryRegion::forces_on_edge(const EdgeSpan& span, const std::vector<int>& nodes_of_scene,
                                                  const FieldsOfRegion& fields) const {
  const std::vector<double>& tractions = fields(Field::traction).values;
  Eigen::VectorXd nodal = Eigen::VectorXd::Zero(trace_.rows());
  for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
    if (panels_[mesh_.elements[e].panel].edge != span.edge) continue;
    const Eigen::Map<const Eigen::Matrix<double, 2, 3>> at_nodes(&tractions[6 * e]);
    bem::add_traction_forces(mesh_, mesh_.elements[e], at_nodes, elasticity().thickness, nodal);
  }
  const Eigen::VectorXd own = trace_.transpose() * nodal;
  std::vector<Point> forces;
  for (const int node : nodes_of_scene) {
    const auto place = std::find(nodes_.begin(), nodes_.end(), node) - nodes_.begin();
    forces.emplace_back(own.segment<2>(2 * static_cast<Eigen::Index>(place)));
  }
  return forces;
}

LinearBodyForce BoundaryRegion::particular(const BodyForce& body_force) const {
  Box box;
  for (const Point& node : mesh_.nodes) box.extend(node);
  return {elasticity(), body_force, box.center()};
}

// Adds the nodal forces of a body force. With u = u_p + u_0, where the particular solution u_p carries the body force
// and u_0 carries none, the nodal forces of the surface are K u_0 + f(t_p). Equilibrium is therefore  K u = f + K u_p -
// f(t_p),  with the stiffness K and the nodal forces f(t_p) of the traction t_p of u_p (Brebbia and Dominguez, Boundary
// Elements, 2nd ed., section 3.9).
void BoundaryRegion::add_body_force(const BodyForce& body_force, Eigen::Ref<Eigen::VectorXd> force) const {
  if (body_force.is_zero()) return;
  scatter(trace_.transpose() * force_besides(particular(body_force)), force);
}

Eigen::VectorXd BoundaryRegion::displacement_of(const LinearBodyForce& particular) const {
  Eigen::VectorXd displacement(2 * static_cast<Eigen::Index>(places().size()));
  for (std::size_t i = 0; i < places().size(); ++i)
    displacement.segment<2>(2 * static_cast<Eigen::Index>(i)) = particular.displacement(places()[i]);
  return displacement;
}

Eigen::VectorXd BoundaryRegion::force_besides(const LinearBodyForce& particular) const {
  const Eigen::VectorXd displacement = displacement_of(particular);
  const auto stress = [&](const Point& place) { return particular.stress(place); };
  Eigen::VectorXd forces;
  if (subdomains_) {
    forces = subdomains_->forces_besides(displacement, stress, elasticity().thickness);
  } else {
    Eigen::VectorXd of_tractions = Eigen::VectorXd::Zero(displacement.size());
    bem::add_stress_forces(mesh_, stress, elasticity().thickness, of_tractions);
    forces = mesh_stiffness() * displacement - of_tractions;
  }
  for (const CrackedPart& part : cracked_) part.add(-part.body->forces_on_boundary(part.forces_of(particular)), forces);
  return forces;
}

// Work of a body force b that nodal forces do not include. With Betti's theorem for the particular solution u_p of b
// and the rest of u, the force does on any state u of the body the work
//   integral of b.u dV  =  g.u + integral of b.u_p' dV - g.u_p',   g = K u_p - f(t_p) on the boundary's nodes,
// where u_p' is the particular solution of the other body force. The first term is the work of the nodal forces; this
// function returns the other two.
double BoundaryRegion::work_within(const BodyForce& body_force, const BodyForce& other) const {
  if (body_force.is_zero() || other.is_zero()) return 0;
  const LinearBodyForce own = particular(body_force), theirs = particular(other);
  const Point& centre = theirs.centre();
  double in_volume = bem::integral_of_homogeneous(
      mesh_, centre, 2, [&](const Point& x) { return own.at_centre().dot(theirs.quadratic(x)); });
  if (body_force.growth != 0 || other.growth != 0) {
    const auto growth = [&](const Point& x) -> Point { return body_force.growth * (x - centre); };
    in_volume += bem::integral_of_homogeneous(mesh_, centre, 3, [&](const Point& x) {
      return own.at_centre().dot(theirs.cubic(x)) + growth(x).dot(theirs.quadratic(x));
    });
    in_volume +=
        bem::integral_of_homogeneous(mesh_, centre, 4, [&](const Point& x) { return growth(x).dot(theirs.cubic(x)); });
  }
  return elasticity().thickness * in_volume - force_besides(particular(body_force)).dot(displacement_of(theirs));
}

Eigen::Matrix2d BoundaryRegion::work_within(const std::array<BodyForce, 2>& body_force,
                                            const std::vector<CrackLoad>& crack_loads) const {
  Eigen::Matrix2d work = Eigen::Matrix2d::Zero();
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) work(i, j) = work_within(body_force[i], body_force[j]);
  for (const CrackedPart& part : cracked_)
    work += part.work_of(part.forces_of(crack_loads), particulars(body_force, part));
  return work;
}

void BoundaryRegion::swell(const Swelling& strain, LatticeSwelling&) {
  std::optional<FreeSwelling> free_swelling = FreeSwelling::through(places(), strain);
  require(free_swelling.has_value(), "region ", id(),
          " is a BEM region, and its temperature is not linear in x and y; boundary elements know nothing of others: "
          "make it a peridynamic region, or several regions");
  free_swelling_ = std::move(free_swelling);
  rest_ = coupling::Affine::Zero(2 * static_cast<Eigen::Index>(nodes_.size()), 2);
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < places().size(); ++i) {
    const bool is_slaved = i < mesh_.nodes.size() && node_of_mesh_node_[i] < 0;
    if (!is_slaved) rest_.middleRows<2>(2 * row++) = free_swelling_->displacement(places()[i]);
  }
}

std::optional<Eigen::Matrix2d> BoundaryRegion::free_displacement(const Point& place) const {
  return free_swelling_ ? free_swelling_->displacement(place) : Eigen::Matrix2d::Zero();
}

Eigen::VectorXd BoundaryRegion::elastic(const Eigen::VectorXd& displacement, double constant,
                                        double proportional) const {
  Eigen::VectorXd own = gather(displacement);
  if (rest_.rows() > 0) own -= rest_ * Eigen::Vector2d(constant, proportional);
  return trace_ * own;
}

Eigen::VectorXd BoundaryRegion::displacement_without(const LinearBodyForce& particular,
                                                     const Solution& solution) const {
  Eigen::VectorXd displacement = elastic(solution.displacement, 1, solution.load_factor);
  if (!solution.body_force(id()).is_zero()) displacement -= displacement_of(particular);
  return displacement;
}

bem::InteriorEvaluator BoundaryRegion::interior_without(const LinearBodyForce& particular,
                                                        const Solution& solution) const {
  if (cracks_) return bem::interior_of_body(*cracked_.front().body, cracked_states(solution).front());
  const Eigen::VectorXd displacement = displacement_without(particular, solution);
  return {mesh_, elasticity(), displacement, operator_->tractions(displacement)};
}

}  // namespace bempd::regions
