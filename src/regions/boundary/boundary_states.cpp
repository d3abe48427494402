#include "regions/boundary/boundary_states.hpp"

#include <optional>
#include <utility>

#include "regions/boundary_conditions.hpp"

namespace bempd::regions {

namespace {

bem::FaceTraction without(const bem::FaceTraction& traction, const LinearBodyForce& particular) {
  return [=](int line, const Point& x, const Point& normal) -> Point {
    const Point own = -traction_of(particular, x, normal);
    return traction ? Point(traction(line, x, normal) + own) : own;
  };
}

const std::vector<CrackLoad>& loads_of(const Solution& solution) {
  static const std::vector<CrackLoad> none;
  return solution.crack_loads ? *solution.crack_loads : none;
}

}  // namespace

Eigen::VectorXd BoundaryStates::elastic(const Eigen::VectorXd& displacement, double constant,
                                        double proportional) const {
  Eigen::VectorXd own = region_.gather(displacement);
  if (swelling_.rest().rows() > 0) own -= swelling_.rest() * Eigen::Vector2d(constant, proportional);
  return mesh_.trace() * own;
}

Eigen::VectorXd BoundaryStates::displacement(const LinearBodyForce& particular, const Solution& solution) const {
  Eigen::VectorXd displacement = elastic(solution.displacement, 1, solution.load_factor);
  if (!solution.body_force(region_.id()).is_zero()) displacement -= particulars_.displacement(particular);
  return displacement;
}

// States of the parts with cracks, without the particular solution of a body force. The tractions of this solution on
// the crack faces are subtracted from the loads there.
std::vector<bem::CrackedState> BoundaryStates::of_cracked_parts(const Eigen::VectorXd& displacement,
                                                                const Solution& solution, double constant,
                                                                double proportional) const {
  std::vector<bem::CrackedState> states;
  if (parts_.cracked().empty()) return states;
  Eigen::VectorXd all = elastic(displacement, constant, proportional);
  std::optional<LinearBodyForce> particular;
  if (solution.body_force_parts) {
    const BodyForce body_force = body_force_of(*solution.body_force_parts, region_.id(), {constant, proportional});
    if (!body_force.is_zero()) {
      particular.emplace(particulars_.of(body_force));
      all -= particulars_.displacement(*particular);
    }
  }
  const std::vector<char>& closed_faces = solution.closed_faces_of(region_.id());
  auto first = closed_faces.begin();
  for (const CrackedPart& part : parts_.cracked()) {
    bem::FaceTraction traction = part.cracks->traction(loads_of(solution), constant, proportional);
    if (particular) traction = without(traction, *particular);
    std::vector<char> closed;
    if (part.closing && !closed_faces.empty()) {
      closed.assign(first, first + static_cast<std::ptrdiff_t>(part.constraints()));
      first += static_cast<std::ptrdiff_t>(part.constraints());
    }
    states.push_back(part.state(all, std::move(traction), closed));
  }
  return states;
}

std::vector<bem::CrackedState> BoundaryStates::of_cracked_parts(const Solution& solution) const {
  std::vector<bem::CrackedState> states = of_cracked_parts(solution.displacement, solution, 1, solution.load_factor);
  for (std::size_t k = 0; k < states.size(); ++k) states[k].faces_press = parts_.cracked()[k].closing != nullptr;
  return states;
}

Eigen::VectorXd BoundaryStates::tractions(const LinearBodyForce& particular, const Solution& solution) const {
  if (parts_.is_whole_with_cracks()) return of_cracked_parts(solution).front().tractions;
  const Eigen::VectorXd displacement = this->displacement(particular, solution);
  if (!parts_.subdomains()) return operators_.whole()->tractions(displacement);
  return parts_.subdomains()->tractions(displacement, parts_.cracked(), of_cracked_parts(solution));
}

std::vector<double> BoundaryStates::element_stress(const LinearBodyForce& particular, const Solution& solution) const {
  if (parts_.subdomains())
    return parts_.subdomains()->element_stress(region_.elasticity(), displacement(particular, solution),
                                               parts_.cracked(), of_cracked_parts(solution));
  const bem::InteriorEvaluator rest = inside_of_one_piece(particular, solution);
  std::vector<double> stresses;
  for (int e = 0; e < static_cast<int>(mesh_.mesh().elements.size()); ++e)
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d stress = rest.stress_on(e, k - 1);
      stresses.insert(stresses.end(), {stress[0], stress[1], stress[2]});
    }
  return stresses;
}

bem::InteriorEvaluator BoundaryStates::inside_of_one_piece(const LinearBodyForce& particular,
                                                           const Solution& solution) const {
  if (parts_.cracks()) return bem::interior_of_body(*parts_.cracked().front().body, of_cracked_parts(solution).front());
  const Eigen::VectorXd displacement = this->displacement(particular, solution);
  return {mesh_.mesh(), region_.elasticity(), displacement, operators_.whole()->tractions(displacement)};
}

InteriorOfPieces BoundaryStates::inside(const LinearBodyForce& particular, const Solution& solution) const {
  if (!parts_.subdomains() && !parts_.are_in_pieces())
    return InteriorOfPieces(inside_of_one_piece(particular, solution));
  InteriorOfPieces all;
  if (parts_.subdomains())
    parts_.subdomains()->add_interiors(region_.elasticity(), this->displacement(particular, solution), all);
  const std::vector<bem::CrackedState> states = of_cracked_parts(solution);
  for (std::size_t k = 0; k < parts_.cracked().size(); ++k)
    all.add(*parts_.cracked()[k].body, states[k], parts_.cracked()[k].cracks->tolerance());
  return all;
}

}  // namespace bempd::regions
