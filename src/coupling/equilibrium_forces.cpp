// Forces and energies of a system's operators and terms.
#include "coupling/equilibrium_system.hpp"

namespace bempd::coupling {

Eigen::VectorXd EquilibriumSystem::internal_force(const Eigen::VectorXd& displacement, double load_factor) const {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(displacement.size());
  if (terms_.have_offsets()) {
    for (std::size_t t = 0; t < terms_.size(); ++t) {
      if (!intact_[t]) continue;
      const double tension = terms_.tension(t, present_stiffness_[t], displacement.data(), load_factor);
      terms_.for_each_entry(t, [&](int node, double x, double y) {
        force[2 * node] += tension * x;
        force[2 * node + 1] += tension * y;
      });
    }
  } else {
    terms_.add_forces(present_stiffness_, displacement.data(), force.data());
  }
  constraints_.add_penalty_forces(displacement.data(), force.data());
  for (const OperatorSchurComplement& op : operators_.list()) op.add_internal_force(displacement, load_factor, force);
  ties_.collect(force);
  return force;
}

Eigen::VectorXd EquilibriumSystem::force_of_terms(std::span<const int> terms, const Eigen::VectorXd& displacement,
                                                  double load_factor) const {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(displacement.size());
  for (const int term : terms) {
    const auto t = static_cast<std::size_t>(term);
    if (!intact_[t]) continue;
    const double tension = terms_.tension(t, present_stiffness_[t], displacement.data(), load_factor);
    terms_.for_each_entry(t, [&](int node, double x, double y) {
      force[2 * node] += tension * x;
      force[2 * node + 1] += tension * y;
    });
  }
  return force;
}

double EquilibriumSystem::energy(const Eigen::VectorXd& displacement, double load_factor) const {
  double sum = 0;
  for (std::size_t t = 0; t < terms_.size(); ++t) {
    if (intact_[t]) sum += terms_.energy(t, present_stiffness_[t], displacement.data(), load_factor);
  }
  sum += constraints_.penalty_energy(displacement.data());
  for (const OperatorSchurComplement& op : operators_.list()) sum += op.energy(displacement, load_factor);
  return sum;
}

double EquilibriumSystem::energy_slope(const Eigen::VectorXd& displacement, double load_factor) const {
  double sum = 0;
  const double* u = displacement.data();
  for (std::size_t t = 0; t < terms_.size(); ++t) {
    if (!intact_[t]) continue;
    sum -= present_stiffness_[t] * terms_.elastic_elongation(t, u, load_factor) * terms_.rest(t, 1);
  }
  for (const OperatorSchurComplement& op : operators_.list()) sum += op.energy_slope(displacement, load_factor);
  return sum;
}

double EquilibriumSystem::unit_energy(const Eigen::VectorXd& proportional) const {
  if (!has_offsets()) return 0.5 * proportional.dot(internal_force(proportional));
  double sum = 0;
  for (std::size_t t = 0; t < terms_.size(); ++t) {
    if (!intact_[t]) continue;
    const double elastic = terms_.elastic_elongation_part(t, proportional.data(), 1);
    sum += 0.5 * present_stiffness_[t] * elastic * elastic;
  }
  sum += constraints_.penalty_energy(proportional.data());
  for (const OperatorSchurComplement& op : operators_.list()) sum += op.unit_energy(proportional);
  return sum;
}

Eigen::VectorXd EquilibriumSystem::apply(const Eigen::VectorXd& unknowns) const {
  const Eigen::VectorXd displacement = displacement_of(unknowns);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(2 * node_count_);
  terms_.add_forces(present_stiffness_, displacement.data(), force.data());
  constraints_.add_penalty_forces(displacement.data(), force.data());
  ties_.collect(force);
  for (const OperatorSchurComplement& op : operators_.list()) {
    if (op.shared_dofs().empty()) continue;  // a BLAS complains on the terminal about a matrix without rows
    const Eigen::VectorXd local = op.schur_complement() * displacement(op.shared_dofs());
    force(op.shared_dofs()) += local;
  }
  for (const HoldingSpring& s : springs_) {
    const double tension = s.stiffness * (s.cosine * displacement[2 * s.node] + s.sine * displacement[2 * s.node + 1]);
    force[2 * s.node] += tension * s.cosine;
    force[2 * s.node + 1] += tension * s.sine;
  }
  return force(unknowns_.dof_of);
}

Affine EquilibriumSystem::right_hand_side() const {
  Affine load = operators_.load();
  Affine support = prescribed();
  ties_.expand(support);
  add_supports(support, load);
  if (terms_.have_offsets()) add_offsets(load);
  ties_.collect(load);
  return load(unknowns_.dof_of, Eigen::all);
}

// Adds to `load` the forces of terms, closed penalties and springs that end on prescribed displacements (`support`).
void EquilibriumSystem::add_supports(const Affine& support, Affine& load) const {
  const auto is_free = [&](int node) { return is_unknown(2 * node) && is_unknown(2 * node + 1); };
  const auto add = [&](std::size_t t) {
    if (present_stiffness_[t] == 0) return;
    const Eigen::RowVector2d tension =
        present_stiffness_[t] *
        Eigen::RowVector2d(terms_.elongation(t, support.col(0).data()), terms_.elongation(t, support.col(1).data()));
    terms_.for_each_entry(t, [&](int node, double x, double y) {
      load.row(2 * node) -= x * tension;
      load.row(2 * node + 1) -= y * tension;
    });
  };
  for (std::size_t t = 0; t < terms_.size(); ++t) {
    if (!is_free(terms_.first[t]) || !is_free(terms_.second[t])) {
      if (!terms_.is_wide(t)) add(t);
    }
  }
  for (int t : terms_.wide.term) add(static_cast<std::size_t>(t));
  add_supports_of_penalties(support, load);
  for (const HoldingSpring& s : springs_) {
    const int x = 2 * s.node;
    const Eigen::RowVector2d moved = s.cosine * support.row(x) + s.sine * support.row(x + 1);
    Eigen::RowVector2d pull = -s.stiffness * moved;
    pull[0] += s.stiffness * s.anchor;
    load.row(x) += s.cosine * pull;
    load.row(x + 1) += s.sine * pull;
  }
}

void EquilibriumSystem::add_supports_of_penalties(const Affine& support, Affine& load) const {
  constraints_.for_each_closed_penalty([&](const Constraint& constraint) {
    const Eigen::RowVector2d tension = constraint.stiffness * Eigen::RowVector2d(constraint.gap(support.col(0).data()),
                                                                                 constraint.gap(support.col(1).data()));
    for (const TermEntry& e : constraint.pull) {
      load.row(2 * e.node) -= e.x * tension;
      load.row(2 * e.node + 1) -= e.y * tension;
    }
  });
}

// Adds to `load` the forces of the terms' rest elongations e0: without displacements a term has the tension -k e0.
void EquilibriumSystem::add_offsets(Affine& load) const {
  for (std::size_t t = 0; t < terms_.size(); ++t) {
    if (!intact_[t]) continue;
    const double k = present_stiffness_[t];
    const Eigen::RowVector2d tension(-k * terms_.rest(t, 0), -k * terms_.rest(t, 1));
    if (tension.isZero(0)) continue;
    terms_.for_each_entry(t, [&](int node, double x, double y) {
      load.row(2 * node) -= x * tension;
      load.row(2 * node + 1) -= y * tension;
    });
  }
}

}  // namespace bempd::coupling
