#pragma once

#include <type_traits>
#include <vector>

#include "model/saved_state.hpp"

// Members of saved states and of the structs in them, each listed once. Visitors of the lists write and read bytes
// (state_bytes.cpp), check the numbers (state_checks.cpp), and find the fingerprint of values (fingerprint.cpp).
namespace bempd::model {

// Values that a number of a sound state may have: finite; infinite as well; or any value, including NaN (`unknown`).
// Visitors of the members receive this value as a second argument where it is not `finite`.
enum class Allowed : std::uint8_t { finite, infinite, unknown };

// Visitors that read see constant structs, those that write see others.
template <class Struct, class Plain>
concept ConstOrNot = std::is_same_v<std::remove_const_t<Struct>, Plain>;

void visit_members(ConstOrNot<coupling::HoldingSpring> auto& s, auto& visit) {
  visit(s.node), visit(s.cosine), visit(s.sine), visit(s.stiffness), visit(s.anchor);
}
void visit_members(ConstOrNot<fracture::HistoryEntry> auto& h, auto& visit) {
  visit(h.event), visit(h.total_broken_bonds), visit(h.load_factor), visit(h.stretch_ratio), visit(h.stored_energy);
  visit(h.released_energy), visit(h.work), visit(h.energy_balance_error), visit(h.residual);
  visit(h.critical_load_factor), visit(h.critical_stored_energy), visit(h.bond_energy), visit(h.load_factor_before);
  visit(h.stored_energy_before), visit(h.work_before), visit(h.resistance_before), visit(h.resistance), visit(h.ties);
}
void visit_members(ConstOrNot<fracture::CrackExtension> auto& e, auto& visit) {
  visit(e.x), visit(e.y), visit(e.angle), visit(e.length), visit(e.crack_length), visit(e.load_factor);
  visit(e.rate_before, Allowed::unknown), visit(e.rate_after, Allowed::unknown);
  visit(e.released_energy, Allowed::infinite), visit(e.from_x), visit(e.from_y);
  visit(e.factor_1, Allowed::unknown), visit(e.factor_2, Allowed::unknown), visit(e.resistance, Allowed::infinite);
  visit(e.surface_energy, Allowed::unknown), visit(e.event), visit(e.crack), visit(e.end), visit(e.state);
}
void visit_members(ConstOrNot<crack::TipId> auto& id, auto& visit) { visit(id.crack), visit(id.end); }
void visit_members(ConstOrNot<fracture::GrowingTip> auto& t, auto& visit) {
  visit(t.place.x()), visit(t.place.y()), visit(t.direction.x()), visit(t.direction.y());
  visit(t.law), visit(t.energy_ratios), visit(t.id), visit(t.state);
  if (visit.format > 15) visit(t.even_ahead), visit(t.grown);
}
void visit_members(ConstOrNot<fracture::GrownFace> auto& f, auto& visit) {
  visit(f.term), visit(f.normal_x), visit(f.normal_y);
}
void visit_members(ConstOrNot<fracture::FaceState> auto& f, auto& visit) {
  // Flags of the exact constraints, which are the first flags of `closed`. Only bytes of format 14 have these flags in
  // a list of their own.
  std::vector<char> exact;
  visit(f.grown), visit(f.closed), visit(exact), visit(f.pending);
  if constexpr (!std::is_const_v<std::remove_reference_t<decltype(f)>>)
    f.closed.insert(f.closed.begin(), exact.begin(), exact.end());
}
void visit_members(ConstOrNot<scene::SampledValues> auto& s, auto& visit) { visit(s.constant), visit(s.proportional); }
void visit_members(ConstOrNot<scene::PlacedValues> auto& p, auto& visit) {
  visit(p.fractions), visit(p.constant), visit(p.proportional);
}
void visit_members(ConstOrNot<coupling::StageChange> auto& c, auto& visit) { visit(c.term), visit(c.stage); }
void visit_members(ConstOrNot<coupling::TermEntry> auto& e, auto& visit) { visit(e.node), visit(e.x), visit(e.y); }
void visit_members(ConstOrNot<coupling::Constraint> auto& p, auto& visit) { visit(p.pull), visit(p.stiffness); }
void visit_members(ConstOrNot<coupling::FactorChange> auto& c, auto& visit) {
  visit(c.adds), visit(c.end), visit(c.unknown), visit(c.weight);
}
void visit_members(ConstOrNot<coupling::FactorOrigin> auto& o, auto& visit) {
  visit(o.stages), visit(o.springs), visit(o.closed), visit(o.places), visit(o.changes);
}
void visit_members(ConstOrNot<fracture::Zone> auto& zone, auto& visit) {
  for (auto* point : {&zone.centre, &zone.axis, &zone.low, &zone.high, &zone.inner_low, &zone.inner_high})
    visit(point->x()), visit(point->y());
}
void visit_members(ConstOrNot<fracture::WindowOrigin::Computation> auto& l, auto& visit) {
  visit(l.after), visit(l.load_factor), visit(l.largest_force, Allowed::infinite);
}
void visit_members(ConstOrNot<fracture::WindowOrigin> auto& w, auto& visit) {
  visit(w.options.tie_band), visit(w.options.max_breaks_per_solve), visit(w.options.ahead), visit(w.options.control);
  visit(w.load_factor), visit(w.displacement), visit(w.faces), visit(w.computations), visit(w.events_performed);
  visit(w.is_out_of_date), visit(w.has_changed_terms), visit(w.needs_whole_body), visit(w.tips);
}
void visit_members(ConstOrNot<fracture::Continuation> auto& c, auto& visit) {
  visit(c.whole_body_events), visit(c.patience), visit(c.most_events);
  visit(c.place.zones), visit(c.place.nodes), visit(c.place.are_last);
  visit(c.places_met), visit(c.barred), visit(c.changes_that_bar), visit(c.factor), visit(c.window);
}
void visit_members(ConstOrNot<scene::SceneValues> auto& values, auto& visit) {
  visit(values.supports), visit(values.loads);
}

void visit_members(ConstOrNot<fracture::EvolutionState> auto& e, auto& visit) {
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
void visit_members(ConstOrNot<SavedState> auto& state, auto& visit) {
  visit(state.scene.body), visit(state.scene.supports), visit(state.load_fingerprint), visit(state.evolution);
  visit(state.in_force), visit(state.acting), visit(state.path_end), visit(state.acting_values);
  visit(state.scene.loads), visit(state.host_values), visit(state.continuation);
}

}  // namespace bempd::model
