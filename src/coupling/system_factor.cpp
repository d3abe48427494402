#include "coupling/system_factor.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cancellation.hpp"
#include "error.hpp"
#include "phase.hpp"
#include "stopwatch.hpp"

namespace bempd::coupling {

namespace {

// Residual over the right-hand side of the sparse system at which the iteration ends; one application of a factor of
// the present matrix suffices for this.
constexpr double solution_tolerance = 1e-13;
// Residual over the right-hand side above which a fresh factor is made, because rounding or too many changes have
// spoilt the factor.
constexpr double acceptable_residual = 1e-12;
// Residual over the forces that the largest displacement causes, up to which the residual counts as a rounding error.
constexpr double acceptable_rounding = 1e-14;

// Ratio of a pivot to the diagonal entry of the matrix, below which a motion may have lost its resistance.
constexpr double suspicious_pivot_ratio = 1e-10;

// Shifts of the matrix for inverse iteration, as multiples of its diagonal: `small_shift` is far below the stiffness of
// slender parts, `safe_shift` survives the rounding errors of any factorization.
constexpr double small_shift = 1e-12, safe_shift = 1e-9;
// Ratio of a diagonal entry to the largest one, below which the entry is a rounding error and may be negative: a
// fragment that was cut off has left the node without a bond in some direction.
constexpr double rounding_of_diagonal = 1e-14;
constexpr int inverse_iterations = 8;
constexpr double no_stiffness = 1e-16;  // times the largest diagonal entry: replaces zeros on the diagonal

FactorChange as_change(const Eigen::SparseMatrix<double>& columns, linalg::Change change) {
  const auto entries = columns.nonZeros();
  return {change == linalg::Change::add,
          {columns.outerIndexPtr() + 1, columns.outerIndexPtr() + columns.cols() + 1},
          {columns.innerIndexPtr(), columns.innerIndexPtr() + entries},
          {columns.valuePtr(), columns.valuePtr() + entries}};
}

}  // namespace

void SystemFactor::keep_last(std::vector<int> nodes) {
  kept_nodes_ = std::move(nodes);
  forget();
}

bool SystemFactor::keeps(const std::vector<int>& nodes) const {
  if (state_ != FactorState::factorized) return false;
  std::vector<char> kept(unknowns_.kind.size() / 2, 0);
  for (int node : kept_nodes_) kept[node] = 1;
  return std::all_of(nodes.begin(), nodes.end(), [&](int n) { return kept[n] != 0; });
}

void SystemFactor::choose_order() {
  linalg::SparseCholesky* cholesky = solver_->cholesky();
  if (!make_graph_ || !cholesky) return;
  if (!graph_) graph_ = std::make_unique<linalg::NodeGraph>(make_graph_());
  const int node_count = static_cast<int>(unknowns_.kind.size() / 2);
  std::vector<char> member(node_count, 0);
  for (int node = 0; node < node_count; ++node) member[node] = unknowns_.has_unknown(node) ? 1 : 0;
  for (int node : kept_nodes_) member[node] = 0;
  std::vector<int> order;
  order.reserve(unknowns_.dof_of.size());
  const auto append = [&](const std::vector<int>& nodes) {
    for (int node : nodes) {
      for (int dof = 2 * node; dof < 2 * node + 2; ++dof) {
        if (unknowns_.is_unknown(dof)) order.push_back(unknowns_.unknown_of[dof]);
      }
    }
  };
  append(linalg::nested_dissection(*graph_, member));
  const std::size_t eliminated = order.size();
  append(kept_nodes_);
  kept_ = static_cast<int>(order.size() - eliminated);
  cholesky->set_elimination_order(std::move(order), kept_);
}

bool SystemFactor::recall(const std::vector<FactorChange>& changes) {
  if (forgotten_ == FactorState::none || kept_when_made_ != kept_nodes_ || changes_ != changes) return false;
  state_ = std::exchange(forgotten_, FactorState::none);
  ++counters_.matrices;
  return true;
}

void SystemFactor::factorize(const Matrix& matrix) {
  drop_forgotten();
  state_ = FactorState::none;
  ++counters_.matrices;
  changes_.clear();
  const Stopwatch watch(counters_.seconds_factorization);
  largest_diagonal_ = matrix.diagonal().maxCoeff();
  if (!solver_ || is_of_substructures_) solver_ = method_.make_solver();
  is_of_substructures_ = false;
  {
    const Phase phase("ordering of the sparse system");
    choose_order();
  }
  check_cancelled();
  linalg::SparseFactorization& factor = solver_->factorization();
  if (!factor.factorize(matrix)) {
    fail(Failure::unsolvable,
         "the stiffness matrix is singular: a part of the body can move freely; check supports, and cracks "
         "that leave a part hanging on a single point");
  }
  count_new_factor();
}

bool SystemFactor::factorize(Substructures& substructures, const MatrixSources& sources) {
  if (!method_.needs_symmetry() || !kept_nodes_.empty()) return false;
  const Stopwatch watch(counters_.seconds_factorization);
  std::unique_ptr<SystemSolver> solver = substructures.solver_of(sources, unknowns_);
  if (!solver) return false;
  drop_forgotten();
  changes_.clear();
  solver_ = std::move(solver);
  is_of_substructures_ = true;
  largest_diagonal_ = sources.largest_stiffness;
  count_new_factor();
  return true;
}

void SystemFactor::count_new_factor() {
  state_ = FactorState::factorized;
  kept_when_made_ = kept_nodes_;
  ++counters_.sparse_factorizations;
  // The pivot ratio is that of the matrix scaled to a unit diagonal, so that units and stiff neighbours do not matter.
  const linalg::SparseFactorization& factor = solver_->factorization();
  counters_.reciprocal_condition = std::min(counters_.reciprocal_condition, factor.smallest_pivot_ratio());
  counters_.factor_nonzeros = factor.factor_nonzeros();
}

void SystemFactor::change(const Matrix& columns, linalg::Change change) {
  const Stopwatch watch(counters_.seconds_update);
  const bool was_current = is_current();
  if (was_current) changes_.push_back(as_change(columns, change));
  // A factor that cannot follow the change becomes stale and only preconditions the iteration in solve(). After an
  // error, such as a request to cancel, there is no factor.
  state_ = FactorState::none;
  ++counters_.matrices;
  const bool follows = solver_->factorization().update(columns, change);
  state_ = follows && was_current ? FactorState::updated : FactorState::stale;
  counters_.factor_updates += columns.cols();
}

void SystemFactor::repeat(const FactorChange& change) {
  Matrix columns(static_cast<Eigen::Index>(unknowns_.count()), static_cast<Eigen::Index>(change.end.size()));
  std::vector<Eigen::Triplet<double>> entries;
  std::size_t at = 0;
  for (std::size_t column = 0; column < change.end.size(); ++column)
    for (; at < static_cast<std::size_t>(change.end[column]); ++at)
      entries.emplace_back(change.unknown[at], static_cast<int>(column), change.weight[at]);
  columns.setFromTriplets(entries.begin(), entries.end());
  this->change(columns, change.adds ? linalg::Change::add : linalg::Change::remove);
}

Eigen::VectorXd SystemFactor::solve(const Eigen::VectorXd& rhs, const SystemSolver::Apply& apply,
                                    const std::function<const Matrix&()>& assemble) {
  const auto size = [](const Eigen::VectorXd& v) { return v.lpNorm<Eigen::Infinity>(); };
  for (bool fresh : {false, true}) {
    if (fresh) {
      forget();
      factorize(assemble());
    }
    Eigen::VectorXd solution = Eigen::VectorXd::Zero(rhs.size());
    const linalg::KrylovResult result = solver_->iterate(apply, rhs, solution_tolerance, solution);
    counters_.iterations += result.iterations;
    if (result.relative_residual <= acceptable_residual) return solution;
    // Residual forces below this limit are rounding errors, which are large because displacements near a mechanism are
    // very large.
    const double rounding = acceptable_rounding * largest_diagonal_ * size(solution);
    if (fresh && result.relative_residual * size(rhs) <= rounding) return solution;
  }
  fail(
      Failure::unsolvable,
      "the stiffness matrix is numerically singular: look for parts that are very thin or slender, cracks that leave a "
      "part hanging on next to nothing, and parts that supports hardly hold");
}

bool SystemFactor::pivots_are_sound() const {
  return solver_->factorization().smallest_pivot_ratio() > suspicious_pivot_ratio;
}

std::unique_ptr<SystemSolver> shifted_solver(const SolutionMethod& method, const Eigen::SparseMatrix<double>& matrix,
                                             const Eigen::VectorXd& diagonal) {
  std::unique_ptr<SystemSolver> solver = method.make_solver();
  const auto factorize = [&](double shift, double floor) {
    Eigen::SparseMatrix<double> shifted;  // assigned, as Eigen's constructor leaks memory if a part is missing
    shifted = matrix;
    for (Eigen::Index i = 0; i < shifted.rows(); ++i) shifted.coeffRef(i, i) += shift * diagonal[i] + floor;
    return solver->factorization().factorize(shifted);
  };
  if (!factorize(small_shift, 0) && !factorize(safe_shift, 0) &&
      !factorize(safe_shift, rounding_of_diagonal * diagonal.maxCoeff()))
    fail(Failure::unsolvable, "the stiffness matrix is indefinite");
  return solver;
}

Eigen::VectorXd stiff_diagonal(const Eigen::SparseMatrix<double>& matrix) {
  return matrix.diagonal().cwiseMax(no_stiffness * matrix.diagonal().maxCoeff());
}

Eigen::VectorXd softest_vector(const SolutionMethod& method, const Eigen::SparseMatrix<double>& matrix,
                               double& resistance) {
  const double unit = matrix.diagonal().maxCoeff();
  Eigen::Index bare = 0;  // unknown without stiffness, which moves freely
  if (matrix.diagonal().minCoeff(&bare) < rounding_of_diagonal * unit) {
    resistance = 0;
    return Eigen::VectorXd::Unit(matrix.rows(), bare);
  }
  const Eigen::VectorXd diagonal = stiff_diagonal(matrix);
  const std::unique_ptr<SystemSolver> solver = shifted_solver(method, matrix, diagonal);
  Eigen::VectorXd vector =
      Eigen::VectorXd::LinSpaced(matrix.rows(), 1.0, 2.0 * static_cast<double>(matrix.rows())).array().sin();
  for (int iteration = 0; iteration < inverse_iterations; ++iteration) {
    check_cancelled();
    vector.array() *= diagonal.array() / unit;
    solver->factorization().solve_in_place(vector);
    vector /= vector.cwiseAbs().maxCoeff();
  }
  const Eigen::VectorXd force = solver->multiply(matrix, vector);
  resistance = std::abs(vector.dot(force / unit)) / vector.cwiseAbs2().dot(diagonal / unit);
  return vector;
}

}  // namespace bempd::coupling
