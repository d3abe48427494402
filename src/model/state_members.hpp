#pragma once

#include <type_traits>
#include <vector>

#include "model/saved_state.hpp"

// Members of saved states and of the structs in them, each listed once. Visitors of the lists write and read bytes
// (state_bytes.cpp), check the numbers (state_checks.cpp), and find the fingerprint of values (fingerprint.cpp).
namespace bempd::model {

// Values that a number of a sound state may have: finite ones, infinite ones too, or any including NaN (`unknown`).
// Visitors receive this as a second argument where it is not `finite`.
enum class Allowed : std::uint8_t { finite, infinite, unknown };

template <class Spring, class Visit>
requires std::is_same_v<std::remove_const_t<Spring>, coupling::HoldingSpring>
void visit_members(Spring& s, Visit& visit) {
  visit(s.node), visit(s.cosine), visit(s.sine), visit(s.stiffness), visit(s.anchor);
}
template <class Line, class Visit>
requires std::is_same_v<std::remove_const_t<Line>, fracture::HistoryEntry>
void visit_members(Line& h, Visit& visit) {
  visit(h.event), visit(h.total_broken_bonds), visit(h.load_factor), visit(h.stretch_ratio), visit(h.stored_energy);
  visit(h.released_energy), visit(h.work), visit(h.energy_balance_error), visit(h.residual);
  visit(h.critical_load_factor), visit(h.critical_stored_energy), visit(h.bond_energy), visit(h.load_factor_before);
  visit(h.stored_energy_before), visit(h.work_before), visit(h.resistance_before), visit(h.resistance), visit(h.ties);
}
template <class Extension, class Visit>
requires std::is_same_v<std::remove_const_t<Extension>, fracture::CrackExtension>
void visit_members(Extension& e, Visit& visit) {
  visit(e.x), visit(e.y), visit(e.angle), visit(e.length), visit(e.crack_length), visit(e.load_factor);
  visit(e.rate_before, Allowed::unknown), visit(e.rate_after, Allowed::unknown);
  visit(e.released_energy, Allowed::infinite), visit(e.from_x), visit(e.from_y);
  visit(e.factor_1, Allowed::unknown), visit(e.factor_2, Allowed::unknown), visit(e.resistance, Allowed::infinite);
  visit(e.surface_energy, Allowed::unknown), visit(e.event), visit(e.crack), visit(e.end), visit(e.state);
}
template <class Id, class Visit>
requires std::is_same_v<std::remove_const_t<Id>, crack::TipId>
void visit_members(Id& id, Visit& visit) { visit(id.crack), visit(id.end); }
template <class Tip, class Visit>
requires std::is_same_v<std::remove_const_t<Tip>, fracture::GrowingTip>
void visit_members(Tip& t, Visit& visit) {
  visit(t.place.x()), visit(t.place.y()), visit(t.direction.x()), visit(t.direction.y());
  visit(t.law), visit(t.energy_ratios), visit(t.id), visit(t.state);
  if (visit.format > 15) visit(t.even_ahead), visit(t.grown);
}
template <class Face, class Visit>
requires std::is_same_v<std::remove_const_t<Face>, fracture::GrownFace>
void visit_members(Face& f, Visit& visit) { visit(f.term), visit(f.normal_x), visit(f.normal_y); }
template <class Faces, class Visit>
requires std::is_same_v<std::remove_const_t<Faces>, fracture::FaceState>
void visit_members(Faces& f, Visit& visit) {
  // Flags of the exact constraints, which are the first flags of `closed`. Only bytes of format 14 have these flags in
  // a list of their own.
  std::vector<char> exact;
  visit(f.grown), visit(f.closed), visit(exact), visit(f.pending);
  if constexpr (!std::is_const_v<Faces>) f.closed.insert(f.closed.begin(), exact.begin(), exact.end());
}
template <class Samples, class Visit>
requires std::is_same_v<std::remove_const_t<Samples>, scene::SampledValues>
void visit_members(Samples& s, Visit& visit) { visit(s.constant), visit(s.proportional); }
template <class Placed, class Visit>
requires std::is_same_v<std::remove_const_t<Placed>, scene::PlacedValues>
void visit_members(Placed& p, Visit& visit) { visit(p.fractions), visit(p.constant), visit(p.proportional); }
template <class Change, class Visit>
requires std::is_same_v<std::remove_const_t<Change>, coupling::StageChange>
void visit_members(Change& c, Visit& visit) { visit(c.term), visit(c.stage); }
template <class Entry, class Visit>
requires std::is_same_v<std::remove_const_t<Entry>, coupling::TermEntry>
void visit_members(Entry& e, Visit& visit) { visit(e.node), visit(e.x), visit(e.y); }
template <class Place, class Visit>
requires std::is_same_v<std::remove_const_t<Place>, coupling::Constraint>
void visit_members(Place& p, Visit& visit) { visit(p.pull), visit(p.stiffness); }
template <class Change, class Visit>
requires std::is_same_v<std::remove_const_t<Change>, coupling::FactorChange>
void visit_members(Change& c, Visit& visit) { visit(c.adds), visit(c.end), visit(c.unknown), visit(c.weight); }
template <class Origin, class Visit>
requires std::is_same_v<std::remove_const_t<Origin>, coupling::FactorOrigin>
void visit_members(Origin& o, Visit& visit) {
  visit(o.stages), visit(o.springs), visit(o.closed), visit(o.places), visit(o.changes);
}
template <class Place, class Visit>
requires std::is_same_v<std::remove_const_t<Place>, fracture::Zone>
void visit_members(Place& zone, Visit& visit) {
  for (auto* point : {&zone.centre, &zone.axis, &zone.low, &zone.high, &zone.inner_low, &zone.inner_high})
    visit(point->x()), visit(point->y());
}
template <class Computation, class Visit>
requires std::is_same_v<std::remove_const_t<Computation>, fracture::WindowOrigin::Computation>
void visit_members(Computation& l, Visit& visit) {
  visit(l.after), visit(l.load_factor), visit(l.largest_force, Allowed::infinite);
}
template <class Window, class Visit>
requires std::is_same_v<std::remove_const_t<Window>, fracture::WindowOrigin>
void visit_members(Window& w, Visit& visit) {
  visit(w.options.tie_band), visit(w.options.max_breaks_per_solve), visit(w.options.ahead), visit(w.options.control);
  visit(w.load_factor), visit(w.displacement), visit(w.faces), visit(w.computations), visit(w.events_performed);
  visit(w.is_out_of_date), visit(w.has_changed_terms), visit(w.needs_whole_body), visit(w.tips);
}
template <class State, class Visit>
requires std::is_same_v<std::remove_const_t<State>, fracture::Continuation>
void visit_members(State& c, Visit& visit) {
  visit(c.whole_body_events), visit(c.patience), visit(c.most_events);
  visit(c.place.zones), visit(c.place.nodes), visit(c.place.are_last);
  visit(c.places_met), visit(c.barred), visit(c.changes_that_bar), visit(c.factor), visit(c.window);
}
template <class Both, class Visit>
requires std::is_same_v<std::remove_const_t<Both>, scene::SceneValues>
void visit_members(Both& values, Visit& visit) { visit(values.supports), visit(values.loads); }

template <class State, class Visit>
requires std::is_same_v<std::remove_const_t<State>, fracture::EvolutionState>
void visit_members(State& e, Visit& visit) {
  visit(e.load_factor), visit(e.in_equilibrium), visit(e.separated), visit(e.events), visit(e.broken_bonds);
  visit(e.fragments), visit(e.first_unit_energy, Allowed::infinite), visit(e.released_energy), visit(e.bond_energy),
      visit(e.work);
  visit(e.largest_work), visit(e.worst_energy_balance_error), visit(e.residual), visit(e.largest_force);
  visit(e.resistance.present), visit(e.resistance.peak), visit(e.resistance.stiffness);
  visit(e.work_out_of_balance), visit(e.contact_switches), visit(e.ties);
  visit(e.displacement), visit(e.total_displacement), visit(e.total_force);
  visit(e.stages), visit(e.springs), visit(e.unloaded), visit(e.tips), visit(e.history);
  visit(e.reactions), visit(e.reactions_before, Allowed::infinite);
  visit(e.support_displacements, Allowed::unknown), visit(e.extensions), visit(e.faces), visit(e.stopped);
}
template <class State, class Visit>
requires std::is_same_v<std::remove_const_t<State>, SavedState>
void visit_members(State& state, Visit& visit) {
  visit(state.scene.body), visit(state.scene.supports), visit(state.load_fingerprint), visit(state.evolution);
  visit(state.in_force), visit(state.acting), visit(state.path_end), visit(state.acting_values);
  visit(state.scene.loads), visit(state.host_values), visit(state.continuation);
}

}  // namespace bempd::model
