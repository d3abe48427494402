#include "coupling/equilibrium_system.hpp"

#include <cmath>
#include <utility>

#include "coupling/right_hand_side.hpp"
#include "stopwatch.hpp"

namespace bempd::coupling {

namespace {

// Limit on the number of columns in a change of the factor, over the square root of the number n of unknowns; above the
// limit a fresh factor costs less. In two dimensions a fresh factor takes some n^(3/2) operations, the change by one
// column some n. With n = 12,500 a fresh factor takes as long as 100 to 200 columns.
constexpr double most_columns_over_root = 2;

}  // namespace

void EquilibriumSystem::set_load(Affine force, Affine prescribed) {
  parts_.load.set(std::move(force), std::move(prescribed), parts_.unknowns.kind, parts_.ties);
  parts_.operators.forget_load();
  // Multipliers of closed exact constraints depend on the loads, so the loads are condensed at once.
  if (parts_.constraints.closed_exact_count() > 0) parts_.condense_load();
}

void EquilibriumSystem::commit(std::span<const StageChange> changes, std::span<const HoldingSpring> springs) {
  MatrixChange change(parts_.unknowns, parts_.ties);
  for (const HoldingSpring& s : springs) {
    parts_.springs.push_back(s);
    change.add_spring(s);
  }
  for (const StageChange& c : changes) {
    const double before = parts_.stages.stiffness()[c.term];
    parts_.stages.enter({&c, 1});
    change.add_term(parts_.terms, c.term, parts_.stages.stiffness()[c.term] - before);
  }
  if (is_symmetric() && change.column_count() > most_columns_over_root * std::sqrt(parts_.unknowns.count())) {
    factor_.forget();
  } else {
    factor_.change(change);
  }
}

void EquilibriumSystem::restore(std::vector<std::uint8_t> stages, std::vector<HoldingSpring> springs) {
  parts_.stages.enter_all(stages);
  parts_.springs = std::move(springs);
  factor_.forget();
  matrix_.set_places_met({});
  condense();  // internal forces of a restored displacement are asked for without a solution
}

Affine EquilibriumSystem::solve() {
  const RightHandSide loads(parts_);
  const AppliedLoad& applied = parts_.load;
  const Unknowns& unknowns = parts_.unknowns;
  if (!loads.is_loaded(0) && !loads.is_loaded(1) && parts_.springs.empty()) return applied.prescribed();
  condense();
  if (unknowns.count() > 0) factor_.make();
  const Stopwatch watch(parts_.counters.seconds_solve);
  parts_.condense_load();
  Affine displacement = applied.prescribed();
  if (unknowns.count() > 0) {
    const Affine rhs = loads.sum();
    for (int column = 0; column < 2; ++column) {
      if (rhs.col(column).isZero(0)) continue;
      // Loads are scaled to order 1, because scalar products of the iteration contain their squares, which can overflow
      // or vanish.
      const double unit = std::exp2(std::ilogb(rhs.col(column).lpNorm<Eigen::Infinity>()));
      displacement.col(column)(unknowns.dof_of) = unit * factor_.solve(rhs.col(column) / unit);
    }
  }
  for (int column = 0; column < 2; ++column) parts_.counters.solves += loads.is_loaded(column) ? 1 : 0;
  for (const OperatorSchurComplement& op : parts_.operators.list()) op.recover(displacement);
  parts_.ties.expand(displacement);
  return displacement;
}

FactorizedSystem EquilibriumSystem::factorized() {
  condense();
  const linalg::SparseCholesky& cholesky = factor_.make_cholesky();
  const Stopwatch watch(parts_.counters.seconds_solve);
  parts_.condense_load();
  return {cholesky,
          parts_.unknowns.dof_of,
          factor_.kept(),
          parts_.operators.list(),
          parts_.ties,
          parts_.load.prescribed(),
          RightHandSide(parts_).sum(),
          parts_.counters};
}

}  // namespace bempd::coupling
