#include "coupling/operator_schur_complement.hpp"

#include <algorithm>
#include <utility>

namespace bempd::coupling {

OperatorSchurComplement::OperatorSchurComplement(const DenseOperator& source, const std::vector<DofKind>& kind,
                                                 KnownSchurComplements& known)
    : rest_(source.rest), constraints_(source.constraints) {
  if (constraints_) gap_offsets_ = Affine::Zero(static_cast<Eigen::Index>(constraint_count()), 2);
  all_.reserve(2 * source.nodes.size());
  std::vector<DofKind> own;
  own.reserve(all_.capacity());
  for (const int node : source.nodes)
    for (const int dof : {2 * node, 2 * node + 1}) all_.push_back(dof), own.push_back(kind[dof]);
  const auto [first, last] = known.equal_range(source.stiffness.get());
  const auto same =
      std::find_if(first, last, [&](const auto& one) { return one.second->is_of(source.stiffness, own); });
  if (same != last) {
    schur_ = same->second;
  } else {
    schur_ = source.method->schur_complement(source.stiffness, std::move(own));
    has_factorized_ = !schur_->private_dofs().empty();
    known.emplace(source.stiffness.get(), schur_);
  }
  private_.reserve(schur_->private_dofs().size()), shared_.reserve(schur_->shared_dofs().size());
  for (const int i : schur_->private_dofs()) private_.push_back(all_[i]);
  for (const int i : schur_->shared_dofs()) shared_.push_back(all_[i]);
  if (constraints_) find_switchable();
}

void OperatorSchurComplement::condense_load(const Affine& force, const Affine& prescribed, Affine& load) {
  const Eigen::MatrixXd& stiffness = schur_->stiffness();
  const std::vector<int>&private_local = schur_->private_dofs(), &shared_local = schur_->shared_dofs();
  Affine support = prescribed(all_, Eigen::all);
  if (rest_.rows() > 0) support -= rest_;
  if (support.isZero(0) && force(private_, Eigen::all).isZero(0)) {
    private_load_.setZero(static_cast<Eigen::Index>(private_.size()), 2);
    if (!active_.empty()) subtract_carried_by_closed(support, load);
    return;
  }
  const Affine reaction = stiffness * support;
  for (std::size_t i = 0; i < shared_.size(); ++i) load.row(shared_[i]) -= reaction.row(shared_local[i]);
  if (!private_.empty()) {
    private_load_ = schur_->solve_private(force(private_, Eigen::all) - reaction(private_local, Eigen::all));
    if (!shared_.empty()) {
      const Affine carried = stiffness(shared_local, private_local) * private_load_;
      for (std::size_t i = 0; i < shared_.size(); ++i)
        load.row(shared_[i]) -= carried.row(static_cast<Eigen::Index>(i));
    }
  }
  if (!active_.empty()) subtract_carried_by_closed(support, load);
}

void OperatorSchurComplement::subtract_carried_by_closed(const Affine& support, Affine& load) {
  find_gaps_at_rest(support);
  const Affine carried =
      gaps_by_shared_(active_, Eigen::all).transpose() * active_compliance_.solve(gaps_at_rest_(active_, Eigen::all));
  for (std::size_t i = 0; i < shared_.size(); ++i) load.row(shared_[i]) -= carried.row(static_cast<Eigen::Index>(i));
}

bool OperatorSchurComplement::is_on(const std::vector<int>& nodes) const {
  if (all_.size() != 2 * nodes.size()) return false;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (all_[2 * i] != 2 * nodes[i]) return false;
  return true;
}

void OperatorSchurComplement::recover(Affine& displacement) const {
  if (private_.empty()) return;
  Affine values = private_load_;
  if (!shared_.empty()) values -= schur_->transfer() * displacement(shared_, Eigen::all);
  if (!active_.empty()) values += private_by_forces_(Eigen::all, active_) * active_multipliers(displacement);
  for (std::size_t i = 0; i < private_.size(); ++i) {
    displacement.row(private_[i]) = values.row(static_cast<Eigen::Index>(i));
  }
}

void OperatorSchurComplement::condense_function(Eigen::VectorXd& weights, Eigen::RowVector2d& constant) const {
  if (private_.empty()) return;
  const Eigen::VectorXd own = weights(private_);
  if (own.isZero(0)) return;
  constant += own.transpose() * private_load_;
  weights(private_).setZero();
  if (!shared_.empty()) weights(shared_) -= (schur_->transfer().transpose() * own).eval();
  if (active_.empty()) return;
  const Eigen::VectorXd per_gap = active_compliance_.solve(private_by_forces_(Eigen::all, active_).transpose() * own);
  constant -= per_gap.transpose() * gaps_at_rest_(active_, Eigen::all);
  if (!shared_.empty()) weights(shared_) -= (gaps_by_shared_(active_, Eigen::all).transpose() * per_gap).eval();
}

Eigen::VectorXd OperatorSchurComplement::elastic(const Eigen::VectorXd& displacement, double load_factor) const {
  Eigen::VectorXd own = displacement(all_);
  if (rest_.rows() > 0) own -= evaluate(rest_, load_factor);
  return own;
}

void OperatorSchurComplement::add_internal_force(const Eigen::VectorXd& displacement, double load_factor,
                                                 Eigen::VectorXd& force) const {
  Eigen::VectorXd values = schur_->stiffness() * elastic(displacement, load_factor);
  if (!active_.empty()) values -= constraints_->of_displacements.transpose() * multipliers(displacement, load_factor);
  force(all_) += values;
}

double OperatorSchurComplement::energy(const Eigen::VectorXd& displacement, double load_factor) const {
  const Eigen::VectorXd own = elastic(displacement, load_factor);
  const double open = 0.5 * own.dot(schur_->stiffness() * own);
  if (compliant_.empty()) return open;
  const Eigen::VectorXd gaps = compliant_gaps(displacement, load_factor);
  return open + 0.5 * gaps.dot(own_compliance_.solve(gaps));
}

double OperatorSchurComplement::energy_slope(const Eigen::VectorXd& displacement, double load_factor) const {
  double slope = 0;
  if (rest_.rows() > 0) slope = -rest_.col(1).dot(schur_->stiffness() * elastic(displacement, load_factor));
  if (compliant_.empty()) return slope;
  Eigen::VectorXd growth = gap_offsets_.col(1)(compliant_);
  if (rest_.rows() > 0) growth -= constraints_->of_displacements(compliant_, Eigen::all) * rest_.col(1);
  return slope + growth.dot(own_compliance_.solve(compliant_gaps(displacement, load_factor)));
}

double OperatorSchurComplement::unit_energy(const Eigen::VectorXd& proportional) const {
  Eigen::VectorXd own = proportional(all_);
  if (rest_.rows() > 0) own -= rest_.col(1);
  const double open = 0.5 * own.dot(schur_->stiffness() * own);
  if (compliant_.empty()) return open;
  const Eigen::VectorXd gaps =
      gap_offsets_.col(1)(compliant_) + constraints_->of_displacements(compliant_, Eigen::all) * own;
  return open + 0.5 * gaps.dot(own_compliance_.solve(gaps));
}

}  // namespace bempd::coupling
