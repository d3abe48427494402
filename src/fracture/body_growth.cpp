#include "fracture/body_growth.hpp"

#include <algorithm>
#include <utility>

#include "error.hpp"
#include "fracture/balance.hpp"
#include "number_range.hpp"

namespace bempd::fracture {

using coupling::Affine;

namespace {

// Potential energy (force times displacement) of the loads that nodes have lost in a growth, at the displacements
// before the growth. Lost loads do no further work.
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

// Takes over the damage stages of terms (bonds and cell squares) from the old body; bonds that the longer cracks cut
// stay broken. Tips of cracks that have entered a lattice are added to the tips of the old body.
void BodyGrowth::take_over_lattices(const BodyState& old, const FormerBody& former,
                                    const std::vector<crack::TipId>& entering) {
  for (std::size_t t = 0; t < old.stages.size(); ++t) {
    if (old.stages[t] == 0) continue;
    const int term = former.new_number(static_cast<int>(t));
    if (term < 0) continue;
    std::uint8_t& now = state_.stages[static_cast<std::size_t>(term)];
    now = std::max(now, old.stages[t]);
  }
  std::vector<GrowingTip> tips = old.tips;
  for (const GrowingTip& tip : state_.tips) {
    if (std::find(entering.begin(), entering.end(), tip.id) == entering.end()) continue;
    std::erase_if(tips, [&](const GrowingTip& other) { return other.id == tip.id; });
    tips.push_back(tip);
  }
  state_.tips = std::move(tips);
}

// Takes over which contact constraints are closed. An exact constraint begins with the status (closed or open) of the
// nearest exact constraint of the old body, so that few constraints are switched before the new equilibrium. If a crack
// has entered a lattice, or boundary elements have replaced a part of a lattice, contact places on initial cracks begin
// open, and places at broken bonds that the crack cuts in the new body are left out.
void BodyGrowth::take_over_faces(LoadedBody& then, const FaceState& old, const FormerBody& former) {
  FaceState& faces = state_.faces;
  const CrackFaces& before = then.faces();
  const std::size_t exact_before = before.constraints().exact_count(), exact = system_.constraints().exact_count();
  if (std::find(old.closed.begin(), old.closed.begin() + static_cast<std::ptrdiff_t>(exact_before), 1) !=
      old.closed.begin() + static_cast<std::ptrdiff_t>(exact_before)) {
    system_.condense();
    const std::vector<char> closed = system_.operators().closed_as_in(then.system().operators(), old.closed);
    std::copy(closed.begin(), closed.end(), faces.closed.begin());
  }
  const bool same_places =
      !former.has_fewer_terms && before.first_grown() - exact_before == body_.faces().first_grown() - exact;
  const auto initial = old.closed.begin() + static_cast<std::ptrdiff_t>(exact_before);
  const auto grown = old.closed.begin() + static_cast<std::ptrdiff_t>(before.first_grown());
  if (same_places) std::copy(initial, grown, faces.closed.begin() + static_cast<std::ptrdiff_t>(exact));
  for (std::size_t k = 0; k < old.grown.size(); ++k) {
    GrownFace face = old.grown[k];
    face.term = former.new_number(face.term);
    if (face.term < 0) continue;
    if (!same_places && state_.stages[static_cast<std::size_t>(face.term)] != 0) continue;
    faces.grown.push_back(face);
    faces.closed.push_back(grown[static_cast<std::ptrdiff_t>(k)]);
  }
  faces.pending = old.pending;
  for (std::vector<int>& terms : faces.pending) {
    for (int& term : terms) term = former.new_number(term);
    std::erase(terms, -1);
  }
}

// Takes over the state of the old body: load factor, broken terms, displacements, lost loads, and the springs that hold
// freed parts.
void BodyGrowth::take_over_body(const BodyState& old, const FormerBody& former,
                                const std::vector<crack::TipId>& entering) {
  state_.load_factor = old.load_factor;
  state_.largest_force = old.largest_force;
  state_.separated = old.separated;
  state_.stopped = old.stopped;
  state_.first_unit_energy = old.first_unit_energy;
  take_over_lattices(old, former, entering);
  for (std::size_t node = 0; node < former.node.size(); ++node) {
    const auto before = static_cast<std::size_t>(former.node[node]);
    state_.unloaded[node] = old.unloaded[before];
    state_.total_displacement.segment<2>(2 * static_cast<Eigen::Index>(node)) =
        old.total_displacement.segment<2>(2 * static_cast<Eigen::Index>(before));
  }
  for (coupling::HoldingSpring spring : old.springs) {
    spring.node = former.node_now[static_cast<std::size_t>(spring.node)];
    if (spring.node >= 0) state_.springs.push_back(spring);
  }
  sources_.abandon();
  sources_.refresh();
}

// Finds the equilibrium after growth. The first attempt holds pieces that come off at their present positions. If exact
// constraints are closed, a second attempt opens all of them, in case too many are closed for the longer cracks. The
// last attempt holds pieces at their unloaded positions, because rounding errors of the stiffness cause forces if the
// present position is far from there.
LoadedBody::FirstEquilibrium BodyGrowth::find_equilibrium_of_pieces() {
  constexpr double balanced = 1e-8;
  const BodyState given = state_;
  const auto begin_again = [&] {
    static_cast<BodyState&>(state_) = given;
    std::fill_n(state_.faces.closed.begin(), system_.constraints().exact_count(), 0);
  };
  const auto look = [&] {
    sources_.abandon();
    sources_.refresh();
  };
  const int attempts = system_.constraints().closed_exact_count() > 0 ? 2 : 1;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    // A residual above `balanced` in a body that also has broken bonds looks like a motion that no spring holds. For
    // this reason find_equilibrium() may throw; the next attempt is made all the same.
    try {
      const LoadedBody::FirstEquilibrium found = body_.find_equilibrium(false);
      if (found.held.empty() || body_.response().residual() <= balanced) return found;
    } catch (const Error& error) {
      if (error.failure() != Failure::unsolvable) throw;
    }
    begin_again();
    if (attempt + 1 < attempts) look();
  }
  state_.total_displacement.setZero();
  look();
  return body_.find_equilibrium(false);
}

// Continues the run of the body `before`. The work of constant loads is their force times the change of displacement;
// the energy released by the growth is this work less the increase of the stored energy.
void BodyGrowth::go_on_from(BodyGrowth& before, const FormerBody& former, const std::vector<crack::TipId>& entering) {
  before.sources_.update_for_reader();
  const EvolutionState& old = before.state_;
  static_cast<Sums&>(state_) = old;
  state_.history = old.history;
  state_.reactions = old.reactions;
  state_.reactions_before = old.reactions_before;
  state_.support_displacements = old.support_displacements;
  state_.extensions = old.extensions;
  state_.layouts = old.layouts;
  take_over_faces(before.body_, old.faces, former);
  take_over_body(old, former, entering);
  const std::vector<char> lost_before = state_.unloaded;
  const Eigen::VectorXd displacement = state_.total_displacement;
  const LoadedBody::FirstEquilibrium found = find_equilibrium_of_pieces();
  records_.set_held(found.held);
  const double f = state_.load_factor;
  const double lost =
      potential_of_lost_loads(body_.loads().acting().force, state_.unloaded, lost_before, displacement, f);
  outcome_ = {};
  outcome_.work = body_.response().potential_of_loads() - (before.body_.response().potential_of_loads() - lost) +
                  inner_work_.at(f) - before.inner_work_.at(f);
  outcome_.stored_energy_before = before.body_.response().stored_energy();
  outcome_.within_before = before.inner_work_.at(f);
  outcome_.stored_energy = body_.response().stored_energy();
  outcome_.released_energy = outcome_.work + outcome_.stored_energy_before - outcome_.stored_energy;
  outcome_.unit_energy = body_.response().unit_energy();
  outcome_.residual = body_.response().residual();
  outcome_.energy_scale = least_energy_scale(system_, f);
  outcome_.fragments = found.fragments;
  outcome_.lost_balance = found.lost_balance;
  outcome_.reactions_before = before.body_.supports().reactions();
  outcome_.resistance_before = before.body_.supports().resistance(outcome_.reactions_before);
  outcome_.reactions = body_.supports().reactions();
  outcome_.resistance = body_.supports().resistance(outcome_.reactions);
}

// Negative potential energy at a load factor: nodal loads times displacements, less the stored energy.
double BodyGrowth::potential_at(double load_factor) const {
  const double of_loads =
      coupling::evaluate(system_.load().force(), load_factor).dot(coupling::evaluate(state_.displacement, load_factor));
  return of_loads + inner_work_.at(load_factor) - body_.response().stored_energy_at(load_factor);
}

// Energy released at constant loads less the energy released along the equilibrium path. The energy R(f) released at
// the constant load factor f is a quadratic function. If the load factor changes from a to b along the equilibrium path
// while cracks grow, the released energy is the bilinear form B(a, b) with B(f, f) = R(f), up to the third power of the
// crack extension. By Betti's theorem, B(a, b) is half of: forces at a before the growth times displacements at b after
// the growth, less forces at b after the growth times displacements at a before. B follows from R at three load
// factors.
double BodyGrowth::released_beyond_path(const BodyGrowth& before, double load_factor) const {
  const auto released = [&](double at) { return potential_at(at) - before.potential_at(at); };
  const double present = state_.load_factor;
  return 1.5 * released(present) - 2 * released(0.5 * (present + load_factor)) + 0.5 * released(load_factor);
}

void BodyGrowth::book(const Growth& growth) {
  Event event;
  event.load_factor = state_.load_factor;
  event.ratio = growth.ratio;
  event.critical_load_factor = growth.critical_load_factor;
  outcome_.work -= growth.beyond_path;
  outcome_.released_energy -= growth.beyond_path;
  outcome_.bond_energy = growth.surface_energy;
  outcome_.ties = growth.ties;
  outcome_.critical_stored_energy = body_.response().stored_energy_at(event.critical_load_factor);
  records_.book(event, outcome_);
  records_.add_extensions(growth.extensions);
}

void BodyGrowth::book_layout(std::int64_t layout) {
  state_.layouts.push_back(layout);
  state_.fragments += outcome_.fragments;
  records_.add_work(stored_by_layout());
  records_.end_step();
}

}  // namespace bempd::fracture
