// Matrix of a system, its factor, and the record from which a factor can be made again.
#include <algorithm>
#include <utility>

#include "coupling/equilibrium_system.hpp"
#include "error.hpp"
#include "stopwatch.hpp"

namespace bempd::coupling {

namespace {

PlacesMet nodes_of_places(const Contacts& contacts) {
  PlacesMet places(contacts.size());
  for (std::size_t i = 0; i < contacts.size(); ++i)
    for (const TermEntry& e : contacts[i].pull) places[i].push_back(e.node);
  return places;
}

Contacts contacts_on(const PlacesMet& places) {
  Contacts contacts;
  for (const std::vector<int>& nodes : places) {
    Contact contact{{}, 0};
    for (const int node : nodes) contact.pull.push_back({node, 0, 0});
    contacts.add(std::move(contact));
  }
  return contacts;
}

}  // namespace

std::unique_ptr<StiffnessAssembly> EquilibriumSystem::assembly_with(const PlacesMet* places) const {
  return std::make_unique<StiffnessAssembly>(unknowns_.unknown_of, terms_, ties_, operators_, is_symmetric(),
                                             places ? contacts_on(*places) : Contacts());
}

const Eigen::SparseMatrix<double>& EquilibriumSystem::assemble() const {
  // Places that have never touched are left out, so that they do not change the pattern.
  if (!assembly_) assembly_ = assembly_with(places_met_.get());
  if (!assembly_->has_room_for(contacts_)) {
    places_met_ = std::make_shared<const PlacesMet>(nodes_of_places(contacts_));
    assembly_ = assembly_with(places_met_.get());
  }
  return assembly_->sum(present_stiffness_, springs_, contacts_);
}

const Eigen::SparseMatrix<double>& EquilibriumSystem::assemble_to_factorize() {
  const Eigen::SparseMatrix<double>& matrix = assemble();
  source_ = {stages_, springs_, {}, closed_faces_, places_met_, false, {}};
  contacts_.for_each_closed([&](const Contact& contact) { source_.closed.push_back(contact); });
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
  FactorSource source{stages_, {}, std::move(origin.closed), closed_faces_, {}, true, std::move(origin.changes)};
  for (const StageChange& c : origin.stages) source.stages[c.term] = static_cast<std::uint8_t>(c.stage);
  source.springs.assign(springs_.begin(), springs_.begin() + static_cast<std::ptrdiff_t>(origin.springs));
  if (places_met_ && origin.places == *places_met_) {
    source.places = places_met_;
  } else if (!origin.places.empty()) {
    source.places = std::make_shared<const PlacesMet>(std::move(origin.places));
  }
  // A step that is taken back has usually left the factor as it was, so it can be kept.
  if (source.has_matrix_of(source_) && factor_.recall(source.to_repeat)) return;
  source_ = std::move(source);
}

void EquilibriumSystem::set_places_met(PlacesMet places) {
  if (places_met_ ? places == *places_met_ : places.empty()) return;
  assembly_.reset();
  places_met_ = places.empty() ? nullptr : std::make_shared<const PlacesMet>(std::move(places));
}

// Makes a factor again from its record; if that fails, as on a processor that rounds differently, makes a fresh one.
void EquilibriumSystem::rebuild_factor() {
  if (!source_.is_awaited) return;
  condense();
  std::vector<double> stiffness(terms_.size());
  for (std::size_t t = 0; t < stiffness.size(); ++t)
    stiffness[t] = stiffness_after({static_cast<int>(t), source_.stages[t]});
  Contacts closed;
  for (const Contact& contact : source_.closed) {
    closed.add(contact);
    closed.set_closed(closed.size() - 1, true);
  }
  const bool has_pattern = source_.places == places_met_;
  if (has_pattern && !assembly_) assembly_ = assembly_with(places_met_.get());
  const std::unique_ptr<StiffnessAssembly> earlier = has_pattern ? nullptr : assembly_with(source_.places.get());
  StiffnessAssembly& assembly = earlier ? *earlier : *assembly_;
  try {
    if (assembly.has_room_for(closed)) factor_.factorize(assembly.sum(stiffness, source_.springs, closed));
    for (std::size_t k = 0; factor_.exists() && k < source_.to_repeat.size(); ++k) factor_.repeat(source_.to_repeat[k]);
  } catch (const Error& error) {
    factor_.forget();
    if (error.failure() != Failure::unsolvable) throw;
  }
  source_.to_repeat.clear();
  source_.is_awaited = false;
}

}  // namespace bempd::coupling
