#include "coupling/repeatable_factor.hpp"

#include <cassert>
#include <utility>

#include "coupling/coupling_graph.hpp"
#include "error.hpp"
#include "stopwatch.hpp"

namespace bempd::coupling {

namespace {

Constraints all_closed(const std::vector<Constraint>& list) {
  Constraints closed;
  for (const Constraint& constraint : list) {
    closed.add(constraint);
    closed.set_closed(closed.size() - 1, true);
  }
  return closed;
}

}  // namespace

void RepeatableFactor::place_nodes(const std::vector<Point>& positions) {
  substructures_.place(positions);
  if (!parts_.is_symmetric()) return;
  factor_.set_graph(
      [this] { return coupling_graph(substructures_.positions(), parts_.terms, parts_.ties, parts_.bodies.list()); });
}

void RepeatableFactor::keep_last(std::vector<int> nodes) {
  forget();
  factor_.keep_last(std::move(nodes));
}

void RepeatableFactor::forget() {
  if (source_.is_awaited) factor_.drop_forgotten();
  source_.is_awaited = false;
  factor_.forget();
}

bool RepeatableFactor::exists() {
  repeat();
  return factor_.exists();
}

bool RepeatableFactor::is_current() {
  repeat();
  return factor_.is_current();
}

bool RepeatableFactor::keeps(const std::vector<int>& nodes) {
  repeat();
  return factor_.keeps(nodes);
}

FactorSource RepeatableFactor::present_source() const {
  return FactorSource::of(parts_.stages.numbers(), parts_.springs, parts_.constraints, matrix_.shared_places());
}

const SystemMatrix::Matrix& RepeatableFactor::matrix_to_factorize() {
  const SystemMatrix::Matrix& matrix = matrix_.assemble();
  source_ = present_source();
  return matrix;
}

bool RepeatableFactor::factorize_by_substructures(const Constraints& constraints,
                                                  const std::vector<HoldingSpring>& springs) {
  return factor_.factorize(
      substructures_, {parts_.operators, parts_.terms, parts_.ties, constraints, springs, parts_.stiffness.largest});
}

void RepeatableFactor::make() {
  if (exists()) return;
  if (factorize_by_substructures(parts_.constraints, parts_.springs)) {
    source_ = present_source();
    return;
  }
  const SystemMatrix::Matrix* matrix = nullptr;
  {
    const Stopwatch watch(parts_.counters.seconds_assembly);
    matrix = &matrix_to_factorize();
  }
  factor_.factorize(*matrix);
}

const linalg::SparseCholesky& RepeatableFactor::make_cholesky() {
  assert(parts_.is_symmetric());
  if (substructures_.disable()) forget();  // substructures have no Cholesky factor of the whole matrix
  make();
  return factor_.cholesky();
}

void RepeatableFactor::change(const MatrixChange::Columns& columns, linalg::Change change) {
  if (!exists() || columns.entries.empty()) return;
  SystemMatrix::Matrix matrix(parts_.unknowns.count(), columns.count);
  matrix.setFromTriplets(columns.entries.begin(), columns.entries.end());
  factor_.change(matrix, change);
}

// Adds the new stiffnesses to the factor before it removes others, so that the matrix is positive definite in between,
// too.
void RepeatableFactor::change(const MatrixChange& change) {
  this->change(change.added(), linalg::Change::add);
  this->change(change.removed(), linalg::Change::remove);
}

Eigen::VectorXd RepeatableFactor::solve(const Eigen::VectorXd& rhs) {
  return factor_.solve(
      rhs, [this](const Eigen::VectorXd& x, Eigen::VectorXd& y) { y = matrix_.multiply(x); },
      [this]() -> const SystemMatrix::Matrix& { return matrix_to_factorize(); });
}

std::optional<FactorOrigin> RepeatableFactor::origin() const {
  if (!source_.is_awaited && !factor_.exists()) return std::nullopt;
  const std::vector<std::uint8_t>& stages = parts_.stages.numbers();
  FactorOrigin origin;
  for (std::size_t t = 0; t < stages.size(); ++t)
    if (source_.stages[t] != stages[t]) origin.stages.push_back({static_cast<int>(t), source_.stages[t]});
  origin.springs = source_.springs.size();
  origin.closed = source_.closed;
  if (source_.places) origin.places = *source_.places;
  origin.changes = source_.is_awaited ? source_.to_repeat : factor_.changes();
  return origin;
}

void RepeatableFactor::set_origin(FactorOrigin origin) {
  forget();
  FactorSource source{parts_.stages.numbers(),           {}, std::move(origin.closed),
                      parts_.constraints.closed_exact(), {}, true,
                      std::move(origin.changes)};
  for (const StageChange& c : origin.stages) source.stages[c.term] = static_cast<std::uint8_t>(c.stage);
  source.springs.assign(parts_.springs.begin(), parts_.springs.begin() + static_cast<std::ptrdiff_t>(origin.springs));
  const std::shared_ptr<const PlacesMet>& places_met = matrix_.shared_places();
  if (places_met && origin.places == *places_met) {
    source.places = places_met;
  } else if (!origin.places.empty()) {
    source.places = std::make_shared<const PlacesMet>(std::move(origin.places));
  }
  // Undoing a step usually restores the state from which the present factor was made; that factor is then kept.
  if (source.has_matrix_of(source_) && factor_.recall(source.to_repeat)) return;
  source_ = std::move(source);
}

// Makes the factor again from its record `source_`. If the matrix cannot be factorized (perhaps on another kind of
// processor), there is no factor afterwards.
void RepeatableFactor::repeat() {
  if (!source_.is_awaited) return;
  parts_.condense();
  std::vector<double> stiffness(parts_.terms.size());
  for (std::size_t t = 0; t < stiffness.size(); ++t)
    stiffness[t] = parts_.stages.stiffness_after({static_cast<int>(t), source_.stages[t]});
  const Constraints closed = all_closed(source_.closed);
  const std::shared_ptr<StiffnessAssembly> assembly = matrix_.assembly_with(source_.places);
  try {
    if (!factorize_by_substructures(closed, source_.springs) && assembly->has_room_for(closed))
      factor_.factorize(assembly->sum(stiffness, source_.springs, &closed));
    for (std::size_t k = 0; factor_.exists() && k < source_.to_repeat.size(); ++k) factor_.repeat(source_.to_repeat[k]);
  } catch (const Error& error) {
    factor_.forget();
    if (error.failure() != Failure::unsolvable) throw;
  }
  source_.to_repeat.clear();
  source_.is_awaited = false;
}

}  // namespace bempd::coupling
