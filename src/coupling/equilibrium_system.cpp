#include "coupling/equilibrium_system.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "cancellation.hpp"
#include "coupling/coupling_graph.hpp"
#include "stopwatch.hpp"

namespace bempd::coupling {

namespace {

const SolutionMethod& least_demanding(const std::vector<DenseOperator>& operators) {
  const SolutionMethod* method = &symmetric_solution();
  for (const DenseOperator& op : operators) {
    if (!op.method->needs_symmetry()) method = op.method;
  }
  return *method;
}

// Ratio of the least to the largest stiffness below which digits are lost: rounding in the stiffest part acts as a
// force in the softest one.
constexpr double ordinary_stiffness_ratio = 1e-6;

struct StiffnessRange {
  double smallest = 0, largest = 0;  // of single degrees of freedom in the softest and the stiffest part
};

StiffnessRange stiffness_range(int node_count, const std::vector<DenseOperator>& operators, const Terms& terms) {
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(2 * node_count);
  for (std::size_t t = 0; t < terms.size(); ++t) {
    terms.for_each_entry(t, [&](int node, double x, double y) {
      diagonal[2 * node] += terms.stiffness[t] * x * x;
      diagonal[2 * node + 1] += terms.stiffness[t] * y * y;
    });
  }
  for (const DenseOperator& op : operators) {
    for (std::size_t i = 0; i < op.nodes.size(); ++i) {
      for (int c = 0; c < 2; ++c) {
        const auto own = 2 * static_cast<Eigen::Index>(i) + c;
        diagonal[2 * op.nodes[i] + c] += (*op.stiffness)(own, own);
      }
    }
  }
  StiffnessRange range{std::numeric_limits<double>::infinity(), diagonal.size() > 0 ? diagonal.maxCoeff() : 0};
  for (double k : diagonal) {
    if (k > 0) range.smallest = std::min(range.smallest, k);
  }
  for (const DenseOperator& op : operators) {
    range.smallest = std::min(range.smallest, op.stiffness->diagonal().maxCoeff());
  }
  return range;
}

}  // namespace

EquilibriumSystem::EquilibriumSystem(int node_count, std::vector<DenseOperator> operators, Terms terms,
                                     const std::vector<char>& prescribed_dofs, NodeTies ties)
    : node_count_(node_count),
      method_(least_demanding(operators)),
      in_body_(node_count, 0),
      terms_(std::move(terms)),
      ties_(std::move(ties)),
      stages_(terms_.size(), 0),
      intact_(terms_.size(), 1),
      present_stiffness_(terms_.stiffness),
      unknowns_(classify(node_count, operators, terms_, ties_, prescribed_dofs)),
      load_(node_count),
      factor_(method_, unknowns_, counters_) {
  counters_.sparse_unknowns = unknowns_.count();
  collect_bodies(operators);
  collect_followers();
  for (std::size_t t = 0; t < terms_.law.size(); ++t) enter({static_cast<int>(t), 0});
  const StiffnessRange range = stiffness_range(node_count, operators, terms_);
  largest_stiffness_ = range.largest;
  stiffness_ratio_ = range.largest > 0 ? range.smallest / range.largest : 1;
  operators_ = CondensedOperators(std::move(operators));
  constraints_ = Constraints(static_cast<std::size_t>(operators_.constraint_count()));
  measure_rests_of_terms();
}

void EquilibriumSystem::measure_rests_of_terms() noexcept {
  for (int part = 0; part < 2; ++part) {
    rest_of_terms_[part] = 0;
    for (const double rest : terms_.rest_elongation[part])
      rest_of_terms_[part] = std::max(rest_of_terms_[part], std::abs(rest));
  }
}

void EquilibriumSystem::exchange_rests(Rests& others) noexcept {
  terms_.rest_elongation.swap(others.of_terms);
  operators_.exchange_rests(others.of_operators);
  measure_rests_of_terms();
}

void EquilibriumSystem::collect_bodies(const std::vector<DenseOperator>& operators) {
  std::vector<int> body_of(node_count_, -1);
  for (const DenseOperator& op : operators) {
    const auto add = [&](const std::vector<int>& nodes) {
      for (int node : nodes) body_of[node] = static_cast<int>(bodies_.size());
      bodies_.push_back(nodes);
    };
    if (op.pieces.empty()) add(op.nodes);
    for (const BodyPiece& piece : op.pieces) add(piece.nodes);
  }
  for (std::size_t t = 0; t < ties_.nodes().size(); ++t) {
    bodies_[body_of[ties_.masters(t).front().node]].push_back(ties_.nodes()[t]);
  }
  for (const std::vector<int>& body : bodies_) {
    for (int node : body) in_body_[node] = 1;
  }
}

void EquilibriumSystem::place_nodes(const std::vector<Point>& positions) {
  substructures_.place(positions);
  if (is_symmetric()) factor_.set_graph(coupling_graph(positions, terms_, ties_, bodies_));
}

void EquilibriumSystem::set_load(Affine force, Affine prescribed) {
  load_.set(std::move(force), std::move(prescribed), unknowns_.kind, ties_);
  operators_.forget_load();
  // Multipliers of closed exact constraints depend on the loads, so the loads are condensed at once.
  if (constraints_.closed_exact_count() > 0) condense_load();
}

void EquilibriumSystem::condense() {
  if (operators_.are_condensed()) return;
  const Stopwatch watch(counters_.seconds_assembly);
  operators_.condense(unknowns_.kind, counters_);
  if (stiffness_ratio_ < ordinary_stiffness_ratio) counters_.reciprocal_condition *= stiffness_ratio_;
  operators_.set_closed(constraints_.closed_exact());
}

void EquilibriumSystem::condense_load() {
  condense();
  operators_.condense_load(force(), prescribed());
}

bool EquilibriumSystem::has_load(int part) const {
  return !load_.is_zero(part) || terms_.have_offsets(part) || operators_.have_rest(part);
}

Eigen::VectorXd EquilibriumSystem::displacement_of(const Eigen::VectorXd& unknowns) const {
  Eigen::VectorXd displacement = Eigen::VectorXd::Zero(2 * node_count_);
  displacement(unknowns_.dof_of) = unknowns;
  ties_.expand(displacement);
  return displacement;
}

Eigen::VectorXd EquilibriumSystem::solve_column(const Eigen::VectorXd& rhs) {
  return factor_.solve(
      rhs, [this](const Eigen::VectorXd& x, Eigen::VectorXd& y) { y = apply(x); },
      [this]() -> const Eigen::SparseMatrix<double>& { return assemble_to_factorize(); });
}

Affine EquilibriumSystem::solve() {
  if (!has_load(0) && !has_load(1) && springs_.empty()) return prescribed();
  condense();
  if (unknowns_.count() > 0) factorize();
  const Stopwatch watch(counters_.seconds_solve);
  condense_load();
  Affine displacement = prescribed();
  if (unknowns_.count() > 0) {
    const Affine rhs = right_hand_side();
    for (int column = 0; column < 2; ++column) {
      if (rhs.col(column).isZero(0)) continue;
      // Loads are scaled to order 1, because scalar products of the iteration square them: squares can overflow or
      // vanish.
      const double unit = std::exp2(std::ilogb(rhs.col(column).lpNorm<Eigen::Infinity>()));
      displacement.col(column)(unknowns_.dof_of) = unit * solve_column(rhs.col(column) / unit);
    }
  }
  for (int column = 0; column < 2; ++column) counters_.solves += has_load(column) ? 1 : 0;
  for (const OperatorSchurComplement& op : operators_.list()) op.recover(displacement);
  ties_.expand(displacement);
  return displacement;
}

FactorizedSystem EquilibriumSystem::factorized() {
  assert(is_symmetric());
  condense();
  if (substructures_.avoid()) forget_factor();  // which has no Cholesky factor of the whole matrix
  factorize();
  const Stopwatch watch(counters_.seconds_solve);
  condense_load();
  return {factor_.cholesky(), unknowns_.dof_of,  factor_.kept(), operators_.list(), ties_,
          prescribed(),       right_hand_side(), counters_};
}

}  // namespace bempd::coupling
