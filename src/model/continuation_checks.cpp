// Checks of the data with which a run continues from a saved state (fracture::Continuation): whether they fit the state
// and the scene. All numbers are known to be finite (state_checks.cpp).
#include <algorithm>
#include <set>

#include "error.hpp"
#include "fracture/window/window_settings.hpp"
#include "model/state_checks.hpp"

namespace bempd::model {

namespace {

using coupling::FactorChange;
using coupling::FactorOrigin;
using fracture::Continuation;
using fracture::WindowOrigin;
using fracture::WindowSettings;

bool are_below(const std::vector<int>& numbers, std::size_t limit) {
  return std::all_of(numbers.begin(), numbers.end(),
                     [&](int number) { return number >= 0 && static_cast<std::size_t>(number) < limit; });
}

bool are_below(const std::vector<std::vector<int>>& lists, std::size_t limit) {
  return std::all_of(lists.begin(), lists.end(), [&](const auto& list) { return are_below(list, limit); });
}

bool is_sound(const FactorChange& change, std::size_t unknowns) {
  const auto falls = [](int one, int next) { return next < one; };
  return change.unknown.size() == change.weight.size() && are_below(change.unknown, unknowns) && !change.end.empty() &&
         change.end.front() >= 0 &&
         std::adjacent_find(change.end.begin(), change.end.end(), falls) == change.end.end() &&
         static_cast<std::size_t>(change.end.back()) == change.unknown.size();
}

bool is_sound(const coupling::Constraint& constraint, std::size_t nodes) {
  return constraint.stiffness > 0 &&
         std::all_of(constraint.pull.begin(), constraint.pull.end(), [&](const coupling::TermEntry& e) {
           return e.node >= 0 && static_cast<std::size_t>(e.node) < nodes;
         });
}

bool is_sound(const FactorOrigin& origin, const fracture::EvolutionState& state, const PreparedScene& scene) {
  const coupling::Terms& terms = scene.system->terms();
  const std::size_t nodes = state.unloaded.size();
  const auto unknowns = static_cast<std::size_t>(scene.system->counters().sparse_unknowns);
  const auto is_stage = [&](const coupling::StageChange& c) {
    return c.term >= 0 && static_cast<std::size_t>(c.term) < terms.size() && c.stage >= 0 &&
           c.stage <= terms.law_of(static_cast<std::size_t>(c.term)).broken_stage();
  };
  return origin.springs <= state.springs.size() && are_below(origin.places, nodes) &&
         std::all_of(origin.stages.begin(), origin.stages.end(), is_stage) &&
         std::all_of(origin.closed.begin(), origin.closed.end(), [&](const auto& c) { return is_sound(c, nodes); }) &&
         std::all_of(origin.changes.begin(), origin.changes.end(),
                     [&](const auto& c) { return is_sound(c, unknowns); });
}

bool is_sound(const fracture::FaceState& faces, const PreparedScene& scene) {
  const std::size_t terms = scene.system->terms().size();
  std::set<int> grown;
  return std::all_of(faces.grown.begin(), faces.grown.end(),
                     [&](const fracture::GrownFace& face) {
                       return face.term >= 0 && static_cast<std::size_t>(face.term) < terms &&
                              grown.insert(face.term).second && scene.evolution->faces().can_have(face);
                     }) &&
         faces.closed.size() == scene.evolution->faces().first_grown() + grown.size() &&
         are_below(faces.pending, terms);
}

// Whether `tips` can be an earlier state of the tips `later` of a window (region around the tips that is solved alone),
// in which tips grow or end, but none begins. `laws` is the number of growth laws to which tips may refer.
bool are_those_of(const std::vector<fracture::GrowingTip>& tips, const std::vector<fracture::GrowingTip>& later,
                  std::size_t laws) {
  const auto is_same = [&](const fracture::GrowingTip& tip, const fracture::GrowingTip& then) {
    return model::is_sound(tip) && static_cast<std::size_t>(tip.law) < laws && tip.id == then.id &&
           (!crack::has_ended(tip.state) || tip.state == then.state);
  };
  return tips.size() == later.size() && std::equal(tips.begin(), tips.end(), later.begin(), is_same);
}

bool is_sound(const WindowOrigin& window, const fracture::EvolutionState& state, const PreparedScene& scene) {
  if (window.faces && !is_sound(*window.faces, scene)) return false;
  if (!are_those_of(window.tips, state.tips, scene.tip_laws)) return false;
  if (window.displacement.rows() != state.displacement.rows() || window.events_performed < 0) return false;
  if (!(window.options.tie_band >= 0 && window.options.tie_band < 1)) return false;
  if (window.options.max_breaks_per_solve < 0 || window.options.control > fracture::Control::path) return false;
  std::int64_t after = 0;
  for (const WindowOrigin::Computation& computation : window.computations) {
    if (computation.after < after || !(computation.largest_force >= 0)) return false;
    after = computation.after;
  }
  return after <= window.events_performed && (window.events_performed == 0 || !window.computations.empty());
}

}  // namespace

bool fits(const Continuation& continuation, const fracture::EvolutionState& state, const PreparedScene& scene) {
  const std::size_t nodes = state.unloaded.size();
  std::vector<int> kept = continuation.place.nodes;
  std::sort(kept.begin(), kept.end());
  return continuation.whole_body_events >= 0 && continuation.whole_body_events <= WindowSettings::most_patience &&
         continuation.patience >= 1 && continuation.patience <= WindowSettings::most_patience &&
         continuation.most_events >= WindowSettings::first_events &&
         continuation.most_events <= 2 * WindowSettings::most_events_at_once && are_below(kept, nodes) &&
         std::adjacent_find(kept.begin(), kept.end()) == kept.end() && are_below(continuation.places_met, nodes) &&
         (!continuation.factor || is_sound(*continuation.factor, state, scene)) &&
         (!continuation.window ||
          (continuation.factor && continuation.place.are_last && !kept.empty() &&
           fracture::has_window_form(*scene.system) && is_sound(*continuation.window, state, scene)));
}

}  // namespace bempd::model
