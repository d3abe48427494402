#include <algorithm>
#include <utility>

#include "error.hpp"
#include "fracture/balance.hpp"
#include "fracture/crack_evolution.hpp"
#include "number_range.hpp"

// Continuation of a run in another body whose cracks have grown, and the way back.
namespace bempd::fracture {

using coupling::Affine;

void CrackEvolution::forget_lines(const Start& start) noexcept {
  static_cast<Sums&>(state_) = start.sums;
  state_.history.resize(start.history_size);
  const std::size_t values = 2 * body_.reaction_dofs().size() * start.history_size;
  for (std::vector<double>* of_supports : {&state_.reactions, &state_.reactions_before, &state_.support_displacements})
    of_supports->resize(values);
  state_.extensions.resize(start.extensions_size);
}

void CrackEvolution::return_to(const Start& start) noexcept {
  forget_lines(start);
  sources_.return_to_mark();
}

void CrackEvolution::extend_line(const crack::TipId& tip, const std::optional<Point>& direction) {
  sources_.refresh(), sources_.settle();
  const Event* step = sources_.line_step(tip, direction);
  if (step) perform_and_book(*step);
  sources_.bring_up_to_date();
}

void CrackEvolution::stop_line(const crack::TipId& tip, crack::TipState state) {
  sources_.refresh();
  sources_.settle();
  for (GrowingTip& one : state_.tips)
    if (one.id == tip) one.state = state;
  const auto last = std::find_if(state_.extensions.rbegin(), state_.extensions.rend(),
                                 [&](const CrackExtension& e) { return e.tip() == tip; });
  if (last != state_.extensions.rend()) last->state = crack::TipState::at_interface;
}

void CrackEvolution::stop(const std::vector<crack::TipId>& tips) {
  state_.stopped.insert(state_.stopped.end(), tips.begin(), tips.end());
}

namespace {

// Potential, at the displacements before, of the loads that nodes have lost since then: these loads did no further
// work.
double potential_of_lost_loads(const Affine& force, const std::vector<char>& lost, const std::vector<char>& lost_before,
                               const Eigen::VectorXd& displacement, double load_factor) {
  double sum = 0;
  for (std::size_t node = 0; node < lost.size(); ++node) {
    if (lost[node] == lost_before[node]) continue;
    const auto dof = 2 * static_cast<Eigen::Index>(node);
    sum += coupling::evaluate(force.middleRows<2>(dof), load_factor).dot(displacement.segment<2>(dof));
  }
  return sum;
}

}  // namespace

// Takes over the stages of terms. Bonds that longer cracks cut are broken too, and cracks that have entered a lattice
// get their tips there.
void CrackEvolution::take_over_lattices(const BodyState& old, const std::vector<crack::TipId>& entering) {
  const std::vector<std::uint8_t> cut = std::move(state_.stages);
  state_.stages = old.stages;
  for (std::size_t t = 0; t < cut.size(); ++t) state_.stages[t] = std::max(state_.stages[t], cut[t]);
  std::vector<GrowingTip> tips = old.tips;
  for (const GrowingTip& tip : state_.tips) {
    if (std::find(entering.begin(), entering.end(), tip.id) == entering.end()) continue;
    std::erase_if(tips, [&](const GrowingTip& other) { return other.id == tip.id; });
    tips.push_back(tip);
  }
  state_.tips = std::move(tips);
}

// Takes over the contact state. Exact constraints of longer cracks are determined anew. If a crack has entered a
// lattice, so are the places on initial cracks: all are open at first, and some places of broken bonds may have become
// places of the crack.
void CrackEvolution::take_over_faces(const CrackFaces& before, const FaceState& old) {
  FaceState& faces = state_.faces;
  const std::size_t exact_before = before.constraints().exact_count(), exact = system_.constraints().exact_count();
  const bool same_places = before.first_grown() - exact_before == body_.faces().first_grown() - exact;
  const auto initial = old.closed.begin() + static_cast<std::ptrdiff_t>(exact_before);
  const auto grown = old.closed.begin() + static_cast<std::ptrdiff_t>(before.first_grown());
  if (same_places) std::copy(initial, grown, faces.closed.begin() + static_cast<std::ptrdiff_t>(exact));
  for (std::size_t k = 0; k < old.grown.size(); ++k) {
    if (!same_places && state_.stages[static_cast<std::size_t>(old.grown[k].term)] != 0) continue;
    faces.grown.push_back(old.grown[k]);
    faces.closed.push_back(grown[static_cast<std::ptrdiff_t>(k)]);
  }
  faces.pending = old.pending;
}

// Takes over the body's state: what is broken, and what holds separated parts.
void CrackEvolution::take_over_body(const BodyState& old, const std::vector<int>& node_before,
                                    const std::vector<crack::TipId>& entering) {
  state_.load_factor = old.load_factor;
  state_.largest_force = old.largest_force;
  state_.separated = old.separated;
  state_.stopped = old.stopped;
  state_.first_unit_energy = old.first_unit_energy;
  take_over_lattices(old, entering);
  std::vector<int> node_now(old.unloaded.size(), -1);
  for (std::size_t node = node_before.size(); node-- > 0;) {
    const auto before = static_cast<std::size_t>(node_before[node]);
    state_.unloaded[node] = old.unloaded[before];
    state_.total_displacement.segment<2>(2 * static_cast<Eigen::Index>(node)) =
        old.total_displacement.segment<2>(2 * static_cast<Eigen::Index>(before));
    node_now[before] = static_cast<int>(node);
  }
  for (coupling::HoldingSpring spring : old.springs) {
    spring.node = node_now[static_cast<std::size_t>(spring.node)];
    if (spring.node >= 0) state_.springs.push_back(spring);
  }
  sources_.abandon();
  sources_.refresh();
}

// Equilibrium after growth. A piece that comes off is held at its present position. If that is far from its unloaded
// position, the rounding errors of its stiffness cause forces; it is then held at its unloaded position instead.
LoadedBody::FirstEquilibrium CrackEvolution::find_equilibrium_of_pieces() {
  constexpr double balanced = 1e-8;
  BodyState given = state_;
  // If bonds are broken as well, residuals above `balanced` look like a motion that no spring holds, and the solution
  // fails.
  try {
    const LoadedBody::FirstEquilibrium found = body_.find_equilibrium();
    if (found.held.empty() || body_.residual() <= balanced) return found;
  } catch (const Error& error) {
    if (error.failure() != Failure::unsolvable) throw;
  }
  static_cast<BodyState&>(state_) = std::move(given);
  state_.total_displacement.setZero();
  sources_.abandon();
  sources_.refresh();
  return body_.find_equilibrium();
}

// Continues the run of the body `before`. At constant loads the potential energy falls by what the crack growth
// releases; the work of the loads follows from that and the stored energy.
void CrackEvolution::go_on_after_growth(CrackEvolution& before, const std::vector<int>& node_before,
                                        const std::vector<crack::TipId>& entering) {
  const EvolutionState& old = before.state();
  static_cast<Sums&>(state_) = old;
  state_.history = old.history;
  state_.reactions = old.reactions;
  state_.reactions_before = old.reactions_before;
  state_.support_displacements = old.support_displacements;
  state_.extensions = old.extensions;
  take_over_faces(before.body_.faces(), old.faces);
  take_over_body(old, node_before, entering);
  const std::vector<char> lost_before = state_.unloaded;
  const Eigen::VectorXd displacement = state_.total_displacement;
  const LoadedBody::FirstEquilibrium found = find_equilibrium_of_pieces();
  held_ = found.held;
  const double f = state_.load_factor;
  const double lost =
      potential_of_lost_loads(body_.acting_loads().force, state_.unloaded, lost_before, displacement, f);
  growth_ = {};
  growth_.work = body_.potential_of_loads() - (before.body_.potential_of_loads() - lost) + within(f) - before.within(f);
  growth_.stored_energy_before = before.body_.stored_energy();
  growth_.within_before = before.within(f);
  growth_.stored_energy = body_.stored_energy();
  growth_.released_energy = growth_.work + growth_.stored_energy_before - growth_.stored_energy;
  growth_.unit_energy = body_.unit_energy();
  growth_.residual = body_.residual();
  growth_.energy_scale = least_energy_scale(system_, f);
  growth_.fragments = found.fragments;
  growth_.lost_balance = found.lost_balance;
  growth_.reactions_before = before.body_.reactions();
  growth_.resistance_before = before.body_.resistance(growth_.reactions_before);
  growth_.reactions = body_.reactions();
  growth_.resistance = body_.resistance(growth_.reactions);
}

// Negative potential energy at a load factor: potential that the loads have lost less the stored energy.
double CrackEvolution::potential_at(double load_factor) const {
  const double of_loads =
      coupling::evaluate(system_.force(), load_factor).dot(coupling::evaluate(state_.displacement, load_factor));
  return of_loads + within(load_factor) - body_.stored_energy_at(load_factor);
}

// Excess of the energy released at constant loads over that along the equilibrium path. The former is a quadratic
// function R of the load factor. Along a path from a to b, the release is the bilinear form B(a, b) with B(f, f) =
// R(f), up to the third power of the extension. It is, by Betti's theorem, half the difference of the works that each
// crack's forces do on the other's displacements. B follows from three values of R.
double CrackEvolution::released_beyond_path(const CrackEvolution& before, double load_factor) const {
  const auto released = [&](double at) { return potential_at(at) - before.potential_at(at); };
  const double present = state_.load_factor;
  return 1.5 * released(present) - 2 * released(0.5 * (present + load_factor)) + 0.5 * released(load_factor);
}

// Records the extensions of crack lines; those of one event share its energy by their lengths.
void CrackEvolution::book_lines(const Outcome& outcome, double released_energy) {
  double length = 0;
  for (const CrackExtension& extension : outcome.extensions) length += extension.length;
  for (CrackExtension extension : outcome.extensions) {
    const auto& all = state_.extensions;
    const auto last =
        std::find_if(all.rbegin(), all.rend(), [&](const auto& other) { return other.crack == extension.crack; });
    const auto number = static_cast<std::size_t>(extension.crack - 1);
    const pd::CrackLength described = number < lengths_.size() ? lengths_[number] : pd::CrackLength();
    const bool is_first = std::ranges::none_of(all, [&](const auto& other) { return other.tip() == extension.tip(); });
    extension.event = state_.events;
    extension.crack_length = (last != all.rend() ? last->crack_length : described.length) + extension.length;
    if (is_first) extension.crack_length += described.to_cut[static_cast<std::size_t>(extension.end)];
    extension.released_energy = released_energy * extension.length / length;
    // Energy that a last ligament releases beyond its fracture energy, at a constant load factor, becomes kinetic
    // energy.
    const double taken = outcome.bond_energy * extension.length / length;
    const double most = extension.has_ended() ? extension.surface_energy : taken;
    state_.bond_energy -= std::max(0.0, taken - most);
    extension.surface_energy = std::min(taken, most);
    state_.extensions.push_back(extension);
  }
}

void CrackEvolution::book(const Growth& growth) {
  Event event;
  event.load_factor = state_.load_factor;
  event.ratio = growth.ratio;
  event.critical_load_factor = growth.critical_load_factor;
  growth_.work -= growth.beyond_path;
  growth_.released_energy -= growth.beyond_path;
  growth_.bond_energy = growth.surface_energy;
  growth_.ties = growth.ties;
  growth_.critical_stored_energy = body_.stored_energy_at(event.critical_load_factor);
  book(event, growth_);
  for (const CrackExtension& extension : growth.extensions) {
    state_.extensions.push_back(extension);
    state_.extensions.back().event = state_.events;
  }
}

}  // namespace bempd::fracture
