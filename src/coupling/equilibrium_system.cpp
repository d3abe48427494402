#include "coupling/equilibrium_system.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "coupling/coupling_graph.hpp"
#include "error.hpp"
#include "linalg/conjugate_gradient.hpp"
#include "linalg/sparse_cholesky.hpp"
#include "paper/low_rank_update.hpp"
#include "paper/refinement.hpp"
#include "paper/sparse_lu.hpp"
#include "stopwatch.hpp"

namespace bempd::coupling {

namespace {

// Wanted residual of the sparse system relative to its right-hand side; one application of an up-to-date factor reaches
// it. A solution that rounding or a factor changed too often keeps above the second limit calls for a fresh factor.
constexpr double solution_tolerance = 1e-13;
constexpr double acceptable_residual = 1e-12;
constexpr double acceptable_rounding = 1e-14;  // relative to the forces that the largest displacement causes
constexpr int most_iterations = 40;

// An LU factor is refreshed when its stored updates cost as much to apply as the factor itself, roughly. One that has
// missed changes hardly ever gets there in this many steps.
constexpr int most_updates = 120;
constexpr int most_refinements = 4;

// Pivots as small as this, relative to the diagonal, are worth a look for a motion that nothing resists.
constexpr double suspicious_pivot_ratio = 1e-10;

// So is the answer of a broken bond to a pull of its own, relative to what it would have been on its own.
constexpr double suspicious_response = 1e8;

}  // namespace

EquilibriumSystem::EquilibriumSystem(int node_count, std::vector<DenseOperator> operators, BondSet bonds,
                                     std::vector<char> prescribed_dofs, NodeTies ties)
    : node_count_(node_count),
      in_body_(node_count, 0),
      bonds_(std::move(bonds)),
      ties_(std::move(ties)),
      active_stiffness_(bonds_.stiffness),
      intact_(bonds_.size(), 1),
      force_(Affine::Zero(2 * node_count, 2)),
      prescribed_(Affine::Zero(2 * node_count, 2)) {
  classify(operators, prescribed_dofs);
  collect_bodies(operators);
  for (const DenseOperator& op : operators) symmetric_ = symmetric_ && op.symmetric;
  pending_ = std::move(operators);
}

void EquilibriumSystem::classify(const std::vector<DenseOperator>& operators, const std::vector<char>& prescribed) {
  std::vector<int> operators_at(node_count_, 0);
  std::vector<char> has_bond(node_count_, 0);
  for (std::size_t b = 0; b < bonds_.size(); ++b) has_bond[bonds_.first[b]] = has_bond[bonds_.second[b]] = 1;
  for (const DenseOperator& op : operators) {
    for (int node : op.nodes) ++operators_at[node];
  }
  // The bonds of a tied node are its masters' too.
  for (std::size_t t = 0; t < ties_.nodes().size(); ++t) {
    for (const NodeTies::Master& m : ties_.masters(t)) has_bond[m.node] = 1;
  }
  kind_.resize(2 * node_count_);
  unknown_of_.assign(2 * node_count_, -1);
  for (int node = 0; node < node_count_; ++node) {
    const bool shared = has_bond[node] || operators_at[node] != 1;
    const bool tied = ties_.tie_of(node) >= 0;
    for (int dof = 2 * node; dof < 2 * node + 2; ++dof) {
      kind_[dof] = tied              ? DofKind::tied
                   : prescribed[dof] ? DofKind::prescribed
                   : shared          ? DofKind::shared_free
                                     : DofKind::private_free;
      if (kind_[dof] != DofKind::shared_free) continue;
      unknown_of_[dof] = static_cast<int>(dof_of_.size());
      dof_of_.push_back(dof);
    }
  }
  counters_.sparse_unknowns = static_cast<std::int64_t>(dof_of_.size());
}

void EquilibriumSystem::collect_bodies(const std::vector<DenseOperator>& operators) {
  std::vector<int> body_of(node_count_, -1);
  for (const DenseOperator& op : operators) {
    for (int node : op.nodes) body_of[node] = static_cast<int>(bodies_.size());
    bodies_.push_back(op.nodes);
  }
  for (std::size_t t = 0; t < ties_.nodes().size(); ++t) {
    bodies_[body_of[ties_.masters(t).front().node]].push_back(ties_.nodes()[t]);
  }
  for (const std::vector<int>& body : bodies_) {
    for (int node : body) in_body_[node] = 1;
  }
}

void EquilibriumSystem::set_load(Affine force, Affine prescribed) {
  force_ = std::move(force);
  prescribed_ = std::move(prescribed);
  for (int dof = 0; dof < 2 * node_count_; ++dof) {
    if (kind_[dof] != DofKind::prescribed) prescribed_.row(dof).setZero();
  }
  ties_.collect(force_);
  load_condensed_ = false;
}

void EquilibriumSystem::condense() {
  if (condensed_) return;
  const Stopwatch watch(counters_.seconds_assembly);
  operators_.clear();  // what an attempt that failed has left
  operators_.reserve(pending_.size());
  for (const DenseOperator& op : pending_) {
    operators_.emplace_back(op, kind_, operators_);
    counters_.dense_factorizations += operators_.back().has_factorized() ? 1 : 0;
    counters_.reciprocal_condition = std::min(counters_.reciprocal_condition, operators_.back().reciprocal_condition());
  }
  pending_.clear();
  condensed_ = true;
}

void EquilibriumSystem::condense_load() {
  if (load_condensed_) return;
  condensed_load_ = force_;
  for (CondensedOperator& op : operators_) op.condense_load(force_, prescribed_, condensed_load_);
  load_condensed_ = true;
}

const Eigen::SparseMatrix<double>& EquilibriumSystem::assemble() const {
  if (!assembly_) assembly_ = std::make_unique<StiffnessAssembly>(unknown_of_, bonds_, ties_, operators_, symmetric_);
  return assembly_->sum(active_stiffness_, springs_);
}

std::unique_ptr<linalg::SparseFactorization> EquilibriumSystem::make_factorization() const {
  if (symmetric_) return linalg::make_sparse_cholesky();
  return paper::with_low_rank_updates(paper::make_sparse_lu(), most_updates);
}

void EquilibriumSystem::place_nodes(const std::vector<Point>& positions) {
  if (symmetric_) graph_ = std::make_unique<linalg::NodeGraph>(coupling_graph(positions, bonds_, ties_, bodies_));
}

void EquilibriumSystem::keep_last(std::vector<int> nodes) {
  kept_nodes_ = std::move(nodes);
  forget_factor();
}

bool EquilibriumSystem::factor_keeps(const std::vector<int>& nodes) const {
  if (!has_factor_ || !factor_is_current_ || !factor_is_untouched_) return false;
  std::vector<char> kept(node_count_, 0);
  for (int node : kept_nodes_) kept[node] = 1;
  return std::all_of(nodes.begin(), nodes.end(), [&](int n) { return kept[n] != 0; });
}

void EquilibriumSystem::choose_order() {
  if (!graph_) return;
  std::vector<char> member(node_count_, 0);
  for (int node = 0; node < node_count_; ++node) member[node] = has_unknown(node) ? 1 : 0;
  for (int node : kept_nodes_) member[node] = 0;
  std::vector<int> order;
  order.reserve(dof_of_.size());
  const auto append = [&](const std::vector<int>& nodes) {
    for (int node : nodes) {
      for (int dof = 2 * node; dof < 2 * node + 2; ++dof) {
        if (is_unknown(dof)) order.push_back(unknown_of_[dof]);
      }
    }
  };
  append(linalg::nested_dissection(*graph_, member));
  const std::size_t others = order.size();
  append(kept_nodes_);
  kept_ = static_cast<int>(order.size() - others);
  static_cast<linalg::SparseCholesky&>(*factor_).set_elimination_order(std::move(order), kept_);
}

void EquilibriumSystem::factorize() {
  if (has_factor_) return;
  const Eigen::SparseMatrix<double>* matrix = nullptr;
  {
    const Stopwatch watch(counters_.seconds_assembly);
    matrix = &assemble();
    largest_diagonal_ = matrix->diagonal().maxCoeff();
  }
  const Stopwatch watch(counters_.seconds_factorization);
  if (!factor_) factor_ = make_factorization();
  choose_order();
  if (!factor_->factorize(*matrix)) {
    fail(Failure::unsolvable,
         "the stiffness matrix is singular: a part of the body can move freely; check supports, and cracks "
         "that leave a part hanging on a single point");
  }
  has_factor_ = factor_is_current_ = factor_is_untouched_ = true;
  ++counters_.sparse_factorizations;
  // With the matrix scaled to a unit diagonal, which neither units nor stiff neighbours spoil.
  counters_.reciprocal_condition = std::min(counters_.reciprocal_condition, factor_->smallest_pivot_ratio());
  counters_.factor_nonzeros = factor_->factor_nonzeros();
}

void EquilibriumSystem::change_factor(const std::vector<Eigen::Triplet<double>>& entries, int columns,
                                      linalg::Change change) {
  if (!has_factor_ || entries.empty()) return;
  factor_is_untouched_ = false;
  const Stopwatch watch(counters_.seconds_update);
  Eigen::SparseMatrix<double> matrix(static_cast<Eigen::Index>(dof_of_.size()), columns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  // A factor left stale still preconditions the iteration in solve_column().
  if (!factor_->update(matrix, change)) factor_is_current_ = false;
  counters_.factor_updates += columns;
}

void EquilibriumSystem::mark_broken(std::span<const int> bonds) {
  for (int b : bonds) intact_[b] = 0;
}

void EquilibriumSystem::add_pull(int node, double cosine, double sine, double size, int column,
                                 std::vector<Eigen::Triplet<double>>& entries) const {
  std::vector<UnknownEntry> pull;
  append_pull(unknown_of_, ties_, node, cosine, sine, size, pull);
  for (const UnknownEntry& e : pull) entries.emplace_back(e.unknown, column, e.weight);
}

void EquilibriumSystem::commit_break(std::span<const int> bonds, std::span<const HoldingSpring> springs) {
  std::vector<Eigen::Triplet<double>> entries;
  int column = 0;
  for (const HoldingSpring& spring : springs) {
    springs_.push_back(spring);
    add_pull(spring.node, spring.cosine, spring.sine, std::sqrt(spring.stiffness), column++, entries);
  }
  change_factor(entries, column, linalg::Change::add);

  entries.clear();
  column = 0;
  for (int b : bonds) {
    const double root = std::sqrt(active_stiffness_[b]);
    add_pull(bonds_.first[b], bonds_.cosine[b], bonds_.sine[b], -root, column, entries);
    add_pull(bonds_.second[b], bonds_.cosine[b], bonds_.sine[b], root, column++, entries);
    active_stiffness_[b] = 0;
  }
  change_factor(entries, column, linalg::Change::remove);
}

bool EquilibriumSystem::resists_all_motions(std::span<const int> broken) {
  const auto pivots_are_sound = [&] { return factor_->smallest_pivot_ratio() > suspicious_pivot_ratio; };
  if (!has_factor_) return true;
  if (factor_is_current_) return pivots_are_sound();
  // A stale factor knows nothing of the break. A motion that one bond alone resisted runs away under the load that
  // broke it; what several resisted together shows under uneven pulls along them.
  if (broken.size() < 2) return true;
  Eigen::VectorXd pull = Eigen::VectorXd::Zero(2 * node_count_);
  for (std::size_t i = 0; i < broken.size(); ++i) {
    const int first = 2 * bonds_.first[broken[i]], second = 2 * bonds_.second[broken[i]];
    const Eigen::Vector2d along =
        std::sin(1.0 + static_cast<double>(i)) * Eigen::Vector2d(bonds_.cosine[broken[i]], bonds_.sine[broken[i]]);
    pull.segment<2>(first) -= along;
    pull.segment<2>(second) += along;
  }
  ties_.collect(pull);
  Eigen::VectorXd response;
  try {
    response = displacement_of(solve_column(pull(dof_of_)));
  } catch (const Error&) {
    return false;
  }
  if (factor_is_current_) return pivots_are_sound();
  for (int b : broken) {
    const double elongation = bonds_.elongation(static_cast<std::size_t>(b), response.data());
    if (!(std::abs(elongation) * bonds_.stiffness[b] < suspicious_response)) return false;
  }
  return true;
}

SoftMotion EquilibriumSystem::softest_motion() {
  condense();
  // Inverse iteration with a shift that makes a singular matrix factorizable without hiding its null space.
  const Eigen::SparseMatrix<double>& matrix = assemble();
  const double largest = matrix.diagonal().maxCoeff();
  Eigen::SparseMatrix<double> shifted = matrix;
  for (Eigen::Index i = 0; i < shifted.rows(); ++i) shifted.coeffRef(i, i) += 1e-9 * largest;
  const auto factor = make_factorization();
  if (!factor->factorize(shifted)) fail(Failure::unsolvable, "the stiffness matrix is indefinite");
  Eigen::VectorXd vector =
      Eigen::VectorXd::LinSpaced(matrix.rows(), 1.0, 2.0 * static_cast<double>(matrix.rows())).array().sin();
  for (int iteration = 0; iteration < 6; ++iteration) {
    factor->solve_in_place(vector);
    vector /= vector.cwiseAbs().maxCoeff();
  }
  const Eigen::VectorXd force =
      symmetric_ ? Eigen::VectorXd(matrix.selfadjointView<Eigen::Lower>() * vector) : Eigen::VectorXd(matrix * vector);
  return {displacement_of(vector), std::abs(vector.dot(force)) / (largest * vector.squaredNorm())};
}

void EquilibriumSystem::restore(std::vector<char> intact, std::vector<HoldingSpring> springs) {
  intact_ = std::move(intact);
  springs_ = std::move(springs);
  for (std::size_t b = 0; b < bonds_.size(); ++b) active_stiffness_[b] = intact_[b] ? bonds_.stiffness[b] : 0.0;
  forget_factor();
  condense();  // internal forces of a restored displacement are asked for without a solution
}

void EquilibriumSystem::set_parted(std::span<const int> bonds, bool parted) {
  for (int b : bonds) {
    intact_[b] = parted ? 0 : 1;
    active_stiffness_[b] = parted ? 0.0 : bonds_.stiffness[b];
  }
}

void EquilibriumSystem::forget_factor() { has_factor_ = false; }

void EquilibriumSystem::add_bond_forces(const Eigen::VectorXd& displacement, Eigen::VectorXd& force) const {
  const double* u = displacement.data();
  double* f = force.data();
  for (std::size_t b = 0; b < bonds_.size(); ++b) {
    const double tension = active_stiffness_[b] * bonds_.elongation(b, u);
    const double fx = tension * bonds_.cosine[b], fy = tension * bonds_.sine[b];
    f[2 * bonds_.first[b]] -= fx;
    f[2 * bonds_.first[b] + 1] -= fy;
    f[2 * bonds_.second[b]] += fx;
    f[2 * bonds_.second[b] + 1] += fy;
  }
}

Eigen::VectorXd EquilibriumSystem::internal_force(const Eigen::VectorXd& displacement) const {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(displacement.size());
  add_bond_forces(displacement, force);
  for (const CondensedOperator& op : operators_) op.add_internal_force(displacement, force);
  ties_.collect(force);
  return force;
}

Eigen::VectorXd EquilibriumSystem::displacement_of(const Eigen::VectorXd& unknowns) const {
  Eigen::VectorXd displacement = Eigen::VectorXd::Zero(2 * node_count_);
  displacement(dof_of_) = unknowns;
  ties_.expand(displacement);
  return displacement;
}

Eigen::VectorXd EquilibriumSystem::apply(const Eigen::VectorXd& unknowns) const {
  const Eigen::VectorXd displacement = displacement_of(unknowns);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(2 * node_count_);
  add_bond_forces(displacement, force);
  ties_.collect(force);
  for (const CondensedOperator& op : operators_) {
    const Eigen::VectorXd local = op.schur_complement() * displacement(op.shared_dofs());
    force(op.shared_dofs()) += local;
  }
  for (const HoldingSpring& s : springs_) {
    const double tension = s.stiffness * (s.cosine * displacement[2 * s.node] + s.sine * displacement[2 * s.node + 1]);
    force[2 * s.node] += tension * s.cosine;
    force[2 * s.node + 1] += tension * s.sine;
  }
  return force(dof_of_);
}

Affine EquilibriumSystem::right_hand_side() const {
  Affine load = condensed_load_;
  // Bonds and holding springs that end on prescribed displacements pull with them.
  Affine support = prescribed_;
  ties_.expand(support);
  for (std::size_t b = 0; b < bonds_.size(); ++b) {
    const int i = 2 * bonds_.first[b], j = 2 * bonds_.second[b];
    const bool touches =
        !(unknown_of_[i] >= 0 && unknown_of_[i + 1] >= 0 && unknown_of_[j] >= 0 && unknown_of_[j + 1] >= 0);
    if (!touches || active_stiffness_[b] == 0) continue;
    const double c = bonds_.cosine[b], s = bonds_.sine[b];
    const Eigen::RowVector2d tension =
        active_stiffness_[b] * (c * (support.row(j) - support.row(i)) + s * (support.row(j + 1) - support.row(i + 1)));
    load.row(i) += c * tension;
    load.row(i + 1) += s * tension;
    load.row(j) -= c * tension;
    load.row(j + 1) -= s * tension;
  }
  for (const HoldingSpring& s : springs_) {
    const int x = 2 * s.node;
    const Eigen::RowVector2d moved = s.cosine * support.row(x) + s.sine * support.row(x + 1);
    Eigen::RowVector2d pull = -s.stiffness * moved;
    pull[0] += s.stiffness * s.anchor;
    load.row(x) += s.cosine * pull;
    load.row(x + 1) += s.sine * pull;
  }
  ties_.collect(load);
  return load(dof_of_, Eigen::all);
}

Eigen::VectorXd EquilibriumSystem::solve_column(const Eigen::VectorXd& rhs) {
  const auto multiply = [this](const Eigen::VectorXd& x, Eigen::VectorXd& y) { y = apply(x); };
  const auto precondition = [this](Eigen::VectorXd& r) { factor_->solve_in_place(r); };
  const auto size = [](const Eigen::VectorXd& v) { return v.lpNorm<Eigen::Infinity>(); };
  for (bool fresh : {false, true}) {
    if (fresh) {
      forget_factor();
      factorize();
    }
    Eigen::VectorXd solution = Eigen::VectorXd::Zero(rhs.size());
    const linalg::KrylovResult result =
        symmetric_
            ? linalg::conjugate_gradient(multiply, precondition, rhs, solution, {solution_tolerance, most_iterations})
            : paper::refine(multiply, precondition, rhs, solution, solution_tolerance, most_refinements);
    counters_.iterations += result.iterations;
    if (result.relative_residual <= acceptable_residual) return solution;
    // Next to a mechanism the displacements are so large that forces smaller than this are rounding of their sums.
    const double rounding = acceptable_rounding * largest_diagonal_ * size(solution);
    if (fresh && result.relative_residual * size(rhs) <= rounding) return solution;
  }
  fail(Failure::unsolvable, "the stiffness matrix is numerically singular; check supports and very slender parts");
}

Affine EquilibriumSystem::solve() {
  if (force_.isZero(0) && prescribed_.isZero(0) && springs_.empty()) return prescribed_;
  condense();
  if (!dof_of_.empty()) factorize();
  const Stopwatch watch(counters_.seconds_solve);
  condense_load();
  Affine displacement = prescribed_;
  if (!dof_of_.empty()) {
    const Affine rhs = right_hand_side();
    for (int column = 0; column < 2; ++column) {
      if (rhs.col(column).isZero(0)) continue;
      // The iteration's scalar products square the loads: near the ends of the number range they would be lost.
      const double unit = std::exp2(std::ilogb(rhs.col(column).lpNorm<Eigen::Infinity>()));
      const Eigen::VectorXd unknowns = unit * solve_column(rhs.col(column) / unit);
      for (std::size_t i = 0; i < dof_of_.size(); ++i) {
        displacement(dof_of_[i], column) = unknowns[static_cast<Eigen::Index>(i)];
      }
    }
  }
  for (int column = 0; column < 2; ++column) {
    counters_.solves += force_.col(column).isZero(0) && prescribed_.col(column).isZero(0) ? 0 : 1;
  }
  for (const CondensedOperator& op : operators_) op.recover(displacement);
  ties_.expand(displacement);
  return displacement;
}

}  // namespace bempd::coupling
