// Changes of a system's matrix: terms that enter other stages, holding springs, and motions that lose their resistance.
#include <algorithm>
#include <cmath>
#include <utility>

#include "cancellation.hpp"
#include "coupling/equilibrium_system.hpp"
#include "error.hpp"
#include "linalg/symmetric_modes.hpp"

namespace bempd::coupling {

namespace {

// Limit on stiffness times elongation of a broken term under a pull of order 1 along it, which is 1 for the term alone:
// beyond it, a motion has lost its resistance.
constexpr double suspicious_response = 1e8;

// Share of a motion's energy that other terms may carry if only the springs are to count as resisting it.
constexpr double resisted_by_others = 1e-6;

// Limit on the columns of a change of a factor, over the root of the number n of unknowns: beyond it, a fresh factor
// costs less. In two dimensions that takes some n^(3/2) operations, the change by a column some n. With n = 12,500 a
// fresh factor takes the time of some 100 to 200 columns.
constexpr double most_columns_over_root = 2;

// Nodal forces that pull along all these terms, unevenly.
Eigen::VectorXd uneven_pull(const Terms& terms, const NodeTies& ties, int node_count, std::span<const int> along) {
  Eigen::VectorXd pull = Eigen::VectorXd::Zero(2 * node_count);
  for (std::size_t i = 0; i < along.size(); ++i) {
    const double size = std::sin(1.0 + static_cast<double>(i));
    terms.for_each_entry(static_cast<std::size_t>(along[i]), [&](int node, double x, double y) {
      pull.segment<2>(2 * node) += size * Eigen::Vector2d(x, y);
    });
  }
  ties.collect(pull);
  return pull;
}

// Nodal forces of a spring, by the root of its stiffness.
Eigen::VectorXd pull_of(const HoldingSpring& spring, const NodeTies& ties, int node_count) {
  Eigen::VectorXd pull = Eigen::VectorXd::Zero(2 * node_count);
  pull.segment<2>(2 * spring.node) = std::sqrt(spring.stiffness) * Eigen::Vector2d(spring.cosine, spring.sine);
  ties.collect(pull);
  return pull;
}

}  // namespace

std::vector<StageChange> EquilibriumSystem::all_broken(std::span<const int> terms) const {
  std::vector<StageChange> changes;
  changes.reserve(terms.size());
  for (int t : terms) changes.push_back(terms_.breaking(t));
  return with_followers(std::move(changes));
}

void EquilibriumSystem::collect_followers() {
  if (terms_.following.empty()) return;
  followers_of_ = linalg::make_adjacency(terms_.size(), [&](const auto& add) {
    for (const Terms::Following& pair : terms_.following) add(pair.leader, pair.follower);
  });
}

std::vector<StageChange> EquilibriumSystem::with_followers(std::vector<StageChange> changes) const {
  if (followers_of_.value.empty()) return changes;
  for (const int broken : terms_.broken_by(changes)) {
    for (const int follower : followers_of_.of(broken)) {
      // A follower without stiffness is broken already, although commit() may not have marked it yet.
      if (present_stiffness_[follower] == 0) continue;
      changes.push_back(terms_.breaking(follower));
    }
  }
  const auto before = [](const StageChange& a, const StageChange& b) { return a.term < b.term; };
  const auto same = [](const StageChange& a, const StageChange& b) { return a.term == b.term; };
  std::sort(changes.begin(), changes.end(), before);
  changes.erase(std::unique(changes.begin(), changes.end(), same), changes.end());
  return changes;
}

std::int64_t EquilibriumSystem::count_broken(std::span<const StageChange> changes) const {
  const std::vector<int> broken = terms_.broken_by(changes);
  return std::count_if(broken.begin(), broken.end(), [&](int term) { return !terms_.follows(term); });
}

void EquilibriumSystem::mark(std::span<const StageChange> changes) {
  for (const StageChange& c : changes) {
    stages_[c.term] = static_cast<std::uint8_t>(c.stage);
    intact_[c.term] = terms_.is_broken(static_cast<std::size_t>(c.term), c.stage) ? 0 : 1;
  }
}

void EquilibriumSystem::enter(const StageChange& change) {
  mark({&change, 1});
  present_stiffness_[change.term] = stiffness_after(change);
}

double EquilibriumSystem::stiffness_after(const StageChange& change) const {
  const TermLaw& law = terms_.law_of(static_cast<std::size_t>(change.term));
  return law.stiffness_share(change.stage) * terms_.stiffness[change.term];
}

void EquilibriumSystem::set_stages(std::span<const StageChange> changes) {
  for (const StageChange& c : changes) enter(c);
}

void EquilibriumSystem::add_pulls(int term, double size, int column,
                                  std::vector<Eigen::Triplet<double>>& entries) const {
  std::vector<UnknownEntry> pull;
  terms_.for_each_entry(static_cast<std::size_t>(term), [&](int node, double x, double y) {
    append_pull(unknowns_.unknown_of, ties_, node, x, y, size, pull);
  });
  for (const UnknownEntry& e : pull) entries.emplace_back(e.unknown, column, e.weight);
}

void EquilibriumSystem::change_factor(const std::vector<Eigen::Triplet<double>>& entries, int columns,
                                      linalg::Change change) {
  rebuild_factor();
  if (!factor_.exists() || entries.empty()) return;
  Eigen::SparseMatrix<double> matrix(unknowns_.count(), columns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  factor_.change(matrix, change);
}

void EquilibriumSystem::commit(std::span<const StageChange> changes, std::span<const HoldingSpring> springs) {
  // Stiffening changes come first, so that the matrix is positive definite in between, too.
  std::vector<Eigen::Triplet<double>> added, removed;
  int columns_added = 0, columns_removed = 0;
  std::vector<UnknownEntry> pull;
  for (const HoldingSpring& s : springs) {
    springs_.push_back(s);
    pull.clear();
    append_pull(unknowns_.unknown_of, ties_, s.node, s.cosine, s.sine, std::sqrt(s.stiffness), pull);
    for (const UnknownEntry& e : pull) added.emplace_back(e.unknown, columns_added, e.weight);
    ++columns_added;
  }
  for (const StageChange& c : changes) {
    const double before = present_stiffness_[c.term];
    enter(c);
    const double drop = before - present_stiffness_[c.term];
    if (drop >= 0) {
      add_pulls(c.term, std::sqrt(drop), columns_removed++, removed);
    } else {
      add_pulls(c.term, std::sqrt(-drop), columns_added++, added);
    }
  }
  if (is_symmetric() && columns_added + columns_removed > most_columns_over_root * std::sqrt(unknowns_.count())) {
    forget_factor();
    return;
  }
  change_factor(added, columns_added, linalg::Change::add);
  change_factor(removed, columns_removed, linalg::Change::remove);
}

void EquilibriumSystem::restore(std::vector<std::uint8_t> stages, std::vector<HoldingSpring> springs) {
  for (std::size_t t = 0; t < stages.size(); ++t) enter({static_cast<int>(t), stages[t]});
  springs_ = std::move(springs);
  forget_factor();
  forget_places_met();
  condense();  // internal forces of a restored displacement are asked for without a solution
}

bool EquilibriumSystem::resists_all_motions(std::span<const int> broken) {
  rebuild_factor();
  if (!factor_.exists()) return true;
  if (factor_.is_current()) return factor_.pivots_are_sound();
  // A stale factor does not show the loss of resistance. A motion that only one of the broken terms resisted grows
  // without bound under the present load; one that several of them resisted shows under uneven pulls along them.
  if (broken.size() < 2) return true;
  const Eigen::VectorXd pull = uneven_pull(terms_, ties_, node_count_, broken);
  Eigen::VectorXd response;
  try {
    response = displacement_of(solve_column(pull(unknowns_.dof_of)));
  } catch (const Error&) {
    return false;
  }
  if (factor_.is_current()) return factor_.pivots_are_sound();
  for (int t : broken) {
    const double elongation = terms_.elongation(static_cast<std::size_t>(t), response.data());
    if (!(std::abs(elongation) * terms_.stiffness[t] < suspicious_response)) return false;
  }
  return true;
}

// Finds the motions by an eigenvalue problem. K is the matrix with the springs, S has the pulls of the springs, scaled
// by the roots of their stiffnesses. A motion m that nothing else resists has K m = S S^T m, so S^T K^-1 S y = y with y
// = S^T m: the eigenvalue is 1. All other eigenvalues are less.
std::vector<Eigen::VectorXd> EquilibriumSystem::motions_held_by(std::span<const HoldingSpring> springs) {
  condense();
  assemble();
  const Eigen::SparseMatrix<double>& matrix = assembly_->sum(present_stiffness_, springs_, nullptr);
  // The matrix is summed without constraints, so that parts that only the contact of crack faces holds are free in it.
  const std::unique_ptr<SystemSolver> solver = shifted_solver(method_, matrix, stiff_diagonal(matrix));
  Eigen::MatrixXd pulls = Eigen::MatrixXd::Zero(unknowns_.count(), static_cast<Eigen::Index>(springs.size()));
  for (Eigen::Index k = 0; k < pulls.cols(); ++k)
    pulls.col(k) = pull_of(springs[static_cast<std::size_t>(k)], ties_, node_count_)(unknowns_.dof_of);
  Eigen::MatrixXd answers = pulls;
  check_cancelled();
  solver->factorization().solve_in_place(answers);
  const linalg::SymmetricModes modes = linalg::symmetric_modes(pulls.transpose() * answers);
  std::vector<Eigen::VectorXd> motions;
  for (Eigen::Index k = 0; k < pulls.cols(); ++k) {
    if (modes.values[k] >= 1 - resisted_by_others) motions.push_back(displacement_of(answers * modes.vectors.col(k)));
  }
  return motions;
}

SoftMotion EquilibriumSystem::softest_motion() {
  condense();
  double resistance = 0;
  const Eigen::VectorXd vector = softest_vector(method_, assemble(), resistance);
  return {displacement_of(vector), resistance};
}

}  // namespace bempd::coupling
