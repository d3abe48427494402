#include "coupling/system_matrix.hpp"

namespace bempd::coupling {

namespace {

PlacesMet nodes_of_penalties(const Constraints& constraints) {
  PlacesMet places(constraints.size() - constraints.exact_count());
  for (std::size_t k = 0; k < places.size(); ++k)
    for (const TermEntry& e : constraints[constraints.exact_count() + k].pull) places[k].push_back(e.node);
  return places;
}

Constraints constraints_on(const PlacesMet& places) {
  Constraints constraints;
  for (const std::vector<int>& nodes : places) {
    Constraint constraint{{}, 0};
    for (const int node : nodes) constraint.pull.push_back({node, 0, 0});
    constraints.add(std::move(constraint));
  }
  return constraints;
}

}  // namespace

std::shared_ptr<StiffnessAssembly> SystemMatrix::new_assembly(const PlacesMet* places) const {
  return std::make_shared<StiffnessAssembly>(parts_.unknowns.unknown_of, parts_.terms, parts_.ties,
                                             parts_.operators.list(), parts_.is_symmetric(),
                                             places ? constraints_on(*places) : Constraints());
}

std::shared_ptr<StiffnessAssembly> SystemMatrix::assembly_with(const std::shared_ptr<const PlacesMet>& places) const {
  if (places != places_) return new_assembly(places.get());
  if (!assembly_) assembly_ = new_assembly(places_.get());
  return assembly_;
}

const SystemMatrix::Matrix& SystemMatrix::assemble() const {
  // Constraints that have never closed get no entries in the matrix, so that they do not change its pattern.
  if (!assembly_) assembly_ = new_assembly(places_.get());
  if (!assembly_->has_room_for(parts_.constraints)) {
    places_ = std::make_shared<const PlacesMet>(nodes_of_penalties(parts_.constraints));
    assembly_ = new_assembly(places_.get());
  }
  return assembly_->sum(parts_.stages.stiffness(), parts_.springs, &parts_.constraints);
}

const SystemMatrix::Matrix& SystemMatrix::assemble_without_constraints() const {
  assemble();
  return assembly_->sum(parts_.stages.stiffness(), parts_.springs, nullptr);
}

Eigen::VectorXd SystemMatrix::multiply(const Eigen::VectorXd& unknowns) const {
  const Eigen::VectorXd displacement = parts_.displacement_of(unknowns);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(2 * parts_.node_count);
  parts_.terms.add_forces(parts_.stages.stiffness(), displacement.data(), force.data());
  parts_.constraints.add_penalty_forces(displacement.data(), force.data());
  parts_.ties.collect(force);
  for (const OperatorSchurComplement& op : parts_.operators.list()) {
    if (op.shared_dofs().empty()) continue;  // some BLAS print a complaint about matrices without rows
    const Eigen::VectorXd local = op.schur_complement() * displacement(op.shared_dofs());
    force(op.shared_dofs()) += local;
  }
  for (const HoldingSpring& s : parts_.springs) {
    const double tension = s.stiffness * (s.cosine * displacement[2 * s.node] + s.sine * displacement[2 * s.node + 1]);
    force[2 * s.node] += tension * s.cosine;
    force[2 * s.node + 1] += tension * s.sine;
  }
  return force(parts_.unknowns.dof_of);
}

void SystemMatrix::set_places_met(PlacesMet places) {
  if (places_ ? places == *places_ : places.empty()) return;
  assembly_.reset();
  places_ = places.empty() ? nullptr : std::make_shared<const PlacesMet>(std::move(places));
}

}  // namespace bempd::coupling
