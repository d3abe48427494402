// Exact unilateral constraints of an operator: their elimination, gaps and multipliers.
#include <algorithm>

#include "coupling/operator_schur_complement.hpp"

namespace bempd::coupling {

// Finds the constraints that can close or open by themselves. A constraint at the mouth of a crack cannot if both nodes
// of the mouth are prescribed or shared with other operators, because the gap follows from these nodes.
void OperatorSchurComplement::find_switchable() {
  const Eigen::MatrixXd &alone = constraints_->of_forces, &of_displacements = constraints_->of_displacements;
  for (Eigen::Index i = 0; i < alone.rows(); ++i) {
    const bool moves = !private_.empty() && !of_displacements(i, schur_->private_dofs()).isZero(0);
    can_switch_.push_back(alone(i, i) > 0 || moves ? 1 : 0);
  }
}

// Computes the private unknowns u_p and the gaps as functions of the multipliers q and the shared unknowns u_s. With
// the gaps per displacement G (columns G_p and G_s), the gaps per multiplier S, the transfer matrix X, the stiffness K,
// and the values p_0 and g_0 for q = 0 and u_s = 0:
//   u_p = p_0 - X u_s + P q,   gaps = g_0 + (G_s - G_p X) u_s + (S + G_p P) q,   P = K_pp^-1 G_p^T.
void OperatorSchurComplement::eliminate_constraints() {
  if (gaps_by_forces_.size() > 0) return;
  const Eigen::MatrixXd& of_displacements = constraints_->of_displacements;
  gaps_by_forces_ = constraints_->of_forces;
  gaps_by_shared_ = of_displacements(Eigen::all, schur_->shared_dofs());
  private_by_forces_.resize(static_cast<Eigen::Index>(private_.size()), gaps_by_forces_.rows());
  if (private_.empty()) return;
  const Eigen::MatrixXd of_private = of_displacements(Eigen::all, schur_->private_dofs());
  for (Eigen::Index k = 0; k < of_private.rows(); k += 2) {
    const Eigen::Index count = std::min<Eigen::Index>(2, of_private.rows() - k);
    Affine pull = Affine::Zero(of_private.cols(), 2);
    pull.leftCols(count) = of_private.middleRows(k, count).transpose();
    private_by_forces_.middleCols(k, count) = schur_->solve_private(pull).leftCols(count);
  }
  gaps_by_forces_ += of_private * private_by_forces_;
  if (!shared_.empty()) gaps_by_shared_ -= of_private * schur_->transfer();
}

void OperatorSchurComplement::set_closed(const std::vector<char>& closed) {
  active_.clear();
  compliant_.clear();
  for (std::size_t i = 0; i < closed.size(); ++i)
    if (closed[i]) active_.push_back(static_cast<Eigen::Index>(i));
  if (active_.empty()) return;
  eliminate_constraints();
  const Eigen::MatrixXd& alone = constraints_->of_forces;
  for (const Eigen::Index i : active_)
    if (alone(i, i) > 0) compliant_.push_back(i);
  active_compliance_.compute(gaps_by_forces_(active_, active_));
  own_compliance_.compute(alone(compliant_, compliant_));
  schur_with_active_ = schur_->matrix();
  if (shared_.empty()) return;
  const Eigen::MatrixXd by_shared = gaps_by_shared_(active_, Eigen::all);
  schur_with_active_ += by_shared.transpose() * active_compliance_.solve(by_shared);
}

std::vector<char> OperatorSchurComplement::closed() const {
  std::vector<char> closed(constraint_count(), 0);
  for (const Eigen::Index i : active_) closed[static_cast<std::size_t>(i)] = 1;
  return closed;
}

void OperatorSchurComplement::find_gaps_at_rest(const Affine& support) {
  gaps_at_rest_ = gap_offsets_ + constraints_->of_displacements * support;
  if (!private_.empty())
    gaps_at_rest_ += constraints_->of_displacements(Eigen::all, schur_->private_dofs()) * private_load_;
}

Affine OperatorSchurComplement::active_multipliers(const Affine& displacement) const {
  Affine gaps = gaps_at_rest_(active_, Eigen::all);
  if (!shared_.empty()) gaps += gaps_by_shared_(active_, Eigen::all) * displacement(shared_, Eigen::all);
  return -active_compliance_.solve(gaps);
}

Eigen::VectorXd OperatorSchurComplement::multipliers(const Eigen::VectorXd& displacement, double load_factor) const {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(constraint_count()));
  if (active_.empty()) return forces;
  Eigen::VectorXd gaps = evaluate(gaps_at_rest_, load_factor)(active_);
  if (!shared_.empty()) gaps += gaps_by_shared_(active_, Eigen::all) * displacement(shared_);
  forces(active_) = -active_compliance_.solve(gaps);
  return forces;
}

Affine OperatorSchurComplement::gaps(const Affine& displacement) const {
  Affine own = displacement(all_, Eigen::all);
  if (rest_.rows() > 0) own -= rest_;
  Affine gaps = gap_offsets_ + constraints_->of_displacements * own;
  for (std::size_t i = 0; i < can_switch_.size(); ++i)
    if (!can_switch_[i]) gaps.row(static_cast<Eigen::Index>(i)).setZero();
  if (active_.empty()) return gaps;
  const Affine forces = active_multipliers(displacement);
  gaps += constraints_->of_forces(Eigen::all, active_) * forces;
  for (std::size_t k = 0; k < active_.size(); ++k)
    gaps.row(active_[k]) = -gaps_by_forces_(active_[k], active_[k]) * forces.row(static_cast<Eigen::Index>(k));
  return gaps;
}

Eigen::VectorXd OperatorSchurComplement::gaps_without_multipliers(const Eigen::VectorXd& displacement,
                                                                  double load_factor) const {
  return evaluate(gap_offsets_, load_factor) + constraints_->of_displacements * elastic(displacement, load_factor);
}

Eigen::VectorXd OperatorSchurComplement::compliant_gaps(const Eigen::VectorXd& displacement, double load_factor) const {
  return gaps_without_multipliers(displacement, load_factor)(compliant_);
}

double OperatorSchurComplement::energy_of_multipliers(const Eigen::VectorXd& displacement, double load_factor) const {
  if (active_.empty()) return 0;
  const Eigen::VectorXd own = displacement(all_), forces = multipliers(displacement, load_factor);
  double sum = 0.5 * (constraints_->of_displacements * own).dot(forces);
  if (compliant_.empty()) return sum;
  const Eigen::VectorXd gaps = compliant_gaps(displacement, load_factor);
  return sum + 0.5 * gaps.dot(own_compliance_.solve(gaps));
}

double OperatorSchurComplement::work_due_to_multipliers(const Eigen::VectorXd& displacement, double load_factor) const {
  if (compliant_.empty()) return 0;
  return -evaluate(gap_offsets_, load_factor)(compliant_)
              .dot(own_compliance_.solve(compliant_gaps(displacement, load_factor)));
}

void OperatorSchurComplement::add_gap_function(Eigen::Index constraint, Eigen::Ref<Eigen::VectorXd> weights) const {
  const auto row = constraints_->of_displacements.row(constraint);
  for (std::size_t i = 0; i < all_.size(); ++i) weights[all_[i]] += row[static_cast<Eigen::Index>(i)];
}

}  // namespace bempd::coupling
