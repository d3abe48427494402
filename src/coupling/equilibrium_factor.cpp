// Matrix of a system, its factor, and the record from which a factor can be made again.
#include <algorithm>
#include <utility>

#include "coupling/equilibrium_system.hpp"
#include "error.hpp"
#include "stopwatch.hpp"

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

Constraints all_closed(const std::vector<Constraint>& list) {
  Constraints closed;
  for (const Constraint& constraint : list) {
    closed.add(constraint);
    closed.set_closed(closed.size() - 1, true);
  }
  return closed;
}

}  // namespace

std::unique_ptr<StiffnessAssembly> EquilibriumSystem::assembly_with(const PlacesMet* places) const {
  return std::make_unique<StiffnessAssembly>(unknowns_.unknown_of, terms_, ties_, operators_.list(), is_symmetric(),
                                             places ? constraints_on(*places) : Constraints());
}

const Eigen::SparseMatrix<double>& EquilibriumSystem::assemble() const {
  // Constraints that have never closed get no entries in the matrix, so that they do not change its pattern.
  if (!assembly_) assembly_ = assembly_with(places_met_.get());
  if (!assembly_->has_room_for(constraints_)) {
    places_met_ = std::make_shared<const PlacesMet>(nodes_of_penalties(constraints_));
    assembly_ = assembly_with(places_met_.get());
  }
  return assembly_->sum(present_stiffness_, springs_, &constraints_);
}

const Eigen::SparseMatrix<double>& EquilibriumSystem::assemble_to_factorize() {
  const Eigen::SparseMatrix<double>& matrix = assemble();
  source_ = FactorSource::of(stages_, springs_, constraints_, places_met_);
  return matrix;
}

void EquilibriumSystem::keep_last(std::vector<int> nodes) {
  forget_factor();
  factor_.keep_last(std::move(nodes));
}

void EquilibriumSystem::forget_factor() {
  if (source_.is_awaited) factor_.lose();
  source_.is_awaited = false;
  factor_.forget();
}

bool EquilibriumSystem::has_current_factor() {
  rebuild_factor();
  return factor_.is_current();
}

bool EquilibriumSystem::factor_keeps(const std::vector<int>& nodes) {
  rebuild_factor();
  return factor_.keeps(nodes);
}

void EquilibriumSystem::forget_places_met() {
  if (places_met_) set_places_met({});
}

void EquilibriumSystem::factorize() {
  rebuild_factor();
  if (factor_.exists()) return;
  if (factor_.factorize(substructures_, {operators_, terms_, ties_, constraints_, springs_, largest_stiffness_})) {
    source_ = FactorSource::of(stages_, springs_, constraints_, places_met_);
    return;
  }
  const Eigen::SparseMatrix<double>* matrix = nullptr;
  {
    const Stopwatch watch(counters_.seconds_assembly);
    matrix = &assemble_to_factorize();
  }
  factor_.factorize(*matrix);
}

std::optional<FactorOrigin> EquilibriumSystem::factor_origin() const {
  if (!source_.is_awaited && !factor_.exists()) return std::nullopt;
  FactorOrigin origin;
  for (std::size_t t = 0; t < stages_.size(); ++t)
    if (source_.stages[t] != stages_[t]) origin.stages.push_back({static_cast<int>(t), source_.stages[t]});
  origin.springs = source_.springs.size();
  origin.closed = source_.closed;
  if (source_.places) origin.places = *source_.places;
  origin.changes = source_.is_awaited ? source_.to_repeat : factor_.changes();
  return origin;
}

void EquilibriumSystem::set_factor_origin(FactorOrigin origin) {
  forget_factor();
  FactorSource source{stages_, {},   std::move(origin.closed), constraints_.closed_exact(),
                      {},      true, std::move(origin.changes)};
  for (const StageChange& c : origin.stages) source.stages[c.term] = static_cast<std::uint8_t>(c.stage);
  source.springs.assign(springs_.begin(), springs_.begin() + static_cast<std::ptrdiff_t>(origin.springs));
  if (places_met_ && origin.places == *places_met_) {
    source.places = places_met_;
  } else if (!origin.places.empty()) {
    source.places = std::make_shared<const PlacesMet>(std::move(origin.places));
  }
  // Undoing a step usually leaves the factor as it was before the step, so it can be kept.
  if (source.has_matrix_of(source_) && factor_.recall(source.to_repeat)) return;
  source_ = std::move(source);
}

void EquilibriumSystem::set_places_met(PlacesMet places) {
  if (places_met_ ? places == *places_met_ : places.empty()) return;
  assembly_.reset();
  places_met_ = places.empty() ? nullptr : std::make_shared<const PlacesMet>(std::move(places));
}

// Makes the factor again from its record `source_`. If that fails, as on another kind of processor, no factor is left.
void EquilibriumSystem::rebuild_factor() {
  if (!source_.is_awaited) return;
  condense();
  std::vector<double> stiffness(terms_.size());
  for (std::size_t t = 0; t < stiffness.size(); ++t)
    stiffness[t] = stiffness_after({static_cast<int>(t), source_.stages[t]});
  const Constraints closed = all_closed(source_.closed);
  const bool has_pattern = source_.places == places_met_;
  if (has_pattern && !assembly_) assembly_ = assembly_with(places_met_.get());
  const std::unique_ptr<StiffnessAssembly> earlier = has_pattern ? nullptr : assembly_with(source_.places.get());
  StiffnessAssembly& assembly = earlier ? *earlier : *assembly_;
  try {
    if (!factor_.factorize(substructures_, {operators_, terms_, ties_, closed, source_.springs, largest_stiffness_}) &&
        assembly.has_room_for(closed))
      factor_.factorize(assembly.sum(stiffness, source_.springs, &closed));
    for (std::size_t k = 0; factor_.exists() && k < source_.to_repeat.size(); ++k) factor_.repeat(source_.to_repeat[k]);
  } catch (const Error& error) {
    factor_.forget();
    if (error.failure() != Failure::unsolvable) throw;
  }
  source_.to_repeat.clear();
  source_.is_awaited = false;
}

}  // namespace bempd::coupling
