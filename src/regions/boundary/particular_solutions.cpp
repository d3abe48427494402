#include "regions/boundary/particular_solutions.hpp"

#include "bem/boundary_loads.hpp"

namespace bempd::regions {

LinearBodyForce ParticularSolutions::of(const BodyForce& body_force) const {
  const BoundaryMesh& mesh = mesh_.mesh();
  Box box;
  for (const Point& node : mesh.nodes) box.extend(node);
  return {region_.elasticity(), body_force, box.center()};
}

Eigen::VectorXd ParticularSolutions::displacement(const LinearBodyForce& particular) const {
  Eigen::VectorXd displacement(2 * static_cast<Eigen::Index>(mesh_.places().size()));
  for (std::size_t i = 0; i < mesh_.places().size(); ++i)
    displacement.segment<2>(2 * static_cast<Eigen::Index>(i)) = particular.displacement(mesh_.places()[i]);
  return displacement;
}

Eigen::VectorXd ParticularSolutions::force_change(const LinearBodyForce& particular) const {
  const BoundaryMesh& mesh = mesh_.mesh();
  const Eigen::VectorXd displacement = this->displacement(particular);
  const auto stress = [&](const Point& place) { return particular.stress(place); };
  Eigen::VectorXd forces;
  if (parts_.subdomains()) {
    forces = parts_.subdomains()->forces_less_stress(displacement, stress, region_.elasticity().thickness);
  } else {
    Eigen::VectorXd of_tractions = Eigen::VectorXd::Zero(displacement.size());
    bem::add_stress_forces(mesh, stress, region_.elasticity().thickness, of_tractions);
    forces = operators_.mesh_stiffness() * displacement - of_tractions;
  }
  for (const CrackedPart& part : parts_.cracked())
    part.add(-part.body->forces_on_boundary(part.forces_of(particular)), forces);
  return forces;
}

CrackedPart::Particulars ParticularSolutions::in_part(const std::array<BodyForce, 2>& body_force,
                                                      const CrackedPart& part) const {
  CrackedPart::Particulars all{Eigen::MatrixX2d::Zero(2 * static_cast<Eigen::Index>(part.body->mesh().nodes.size()), 2),
                               Eigen::MatrixX2d::Zero(part.openings(), 2)};
  for (int column = 0; column < 2; ++column) {
    if (body_force[column].is_zero()) continue;
    const LinearBodyForce particular = of(body_force[column]);
    all.displacements.col(column) = part.own(displacement(particular));
    all.face_forces.col(column) = part.forces_of(particular);
  }
  return all;
}

// Work of a body force b that nodal forces do not include. Let u be the displacement of another state of the body, with
// the body force `other`, whose particular solution is u_p'. By Betti's theorem for the particular solution u_p of b
// and the difference u - u_p', b does the work
//   integral of b.u dV  =  g.u + integral of b.u_p' dV - g.u_p',   g = K u_p - f_p,
// with the stiffness K of the boundary and the nodal forces f_p of the tractions of u_p. The first term, g.u, is the
// work of the nodal forces; the function returns the sum of the other two.
double ParticularSolutions::work(const BodyForce& body_force, const BodyForce& other) const {
  const BoundaryMesh& mesh = mesh_.mesh();
  if (body_force.is_zero() || other.is_zero()) return 0;
  const LinearBodyForce own = of(body_force), theirs = of(other);
  const Point& centre = theirs.centre();
  double in_volume = bem::integral_of_homogeneous(
      mesh, centre, 2, [&](const Point& x) { return own.at_centre().dot(theirs.quadratic(x)); });
  if (body_force.growth != 0 || other.growth != 0) {
    const auto growth = [&](const Point& x) -> Point { return body_force.growth * (x - centre); };
    in_volume += bem::integral_of_homogeneous(mesh, centre, 3, [&](const Point& x) {
      return own.at_centre().dot(theirs.cubic(x)) + growth(x).dot(theirs.quadratic(x));
    });
    in_volume +=
        bem::integral_of_homogeneous(mesh, centre, 4, [&](const Point& x) { return growth(x).dot(theirs.cubic(x)); });
  }
  return region_.elasticity().thickness * in_volume - force_change(of(body_force)).dot(displacement(theirs));
}

}  // namespace bempd::regions
