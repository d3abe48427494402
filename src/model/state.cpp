#include <algorithm>
#include <cmath>
#include <set>

#include "error.hpp"
#include "model/fingerprint.hpp"
#include "model/model.hpp"

namespace bempd::model {

namespace {

bool is_sound(const fracture::GrowingTip& tip) {
  const auto is_ratio = [](double ratio) { return ratio >= 0 && std::isfinite(ratio); };
  return tip.place.allFinite() && std::abs(tip.direction.norm() - 1) < 1e-6 &&
         std::all_of(tip.energy_ratios.begin(), tip.energy_ratios.end(), is_ratio);
}

// A state whose numbers go together may still have been made for another body.
void require_fit(const fracture::EvolutionState& state, const PreparedScene& scene) {
  const auto dofs = static_cast<Eigen::Index>(2 * scene.discretization.positions.size());
  const coupling::Terms& terms = scene.system->terms();
  const auto fits = [](bool good) {
    require(good, "the state's arrays do not fit the scene that it names; its bytes were altered");
  };
  fits(state.total_displacement.size() == dofs && state.stages.size() == terms.size() &&
       state.reactions.size() == 2 * state.history.size() * scene.conditions.reaction_dofs.size());
  fits(state.tips.size() >= scene.first_tips && (scene.tip_laws > 0 || state.tips.empty()));
  for (std::size_t k = 0; k < state.tips.size(); ++k) {
    const int number = state.tips[k].law;
    const auto law = static_cast<std::size_t>(number < 0 ? -1 - number : number);  // negative: it has ended
    const bool is_first = k < scene.first_tips;
    fits(is_sound(state.tips[k]) && (is_first ? law == k : law >= scene.first_tips && law < scene.tip_laws));
  }
  const auto is_gone = [&](std::size_t term) { return state.stages[term] == terms.law_of(term).gone(); };
  std::int64_t broken = 0;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    fits(state.stages[t] <= terms.law_of(t).gone());
    broken += is_gone(t) && !terms.follows(static_cast<int>(t)) ? 1 : 0;
  }
  for (const coupling::Terms::Following& pair : terms.following)
    fits(!is_gone(static_cast<std::size_t>(pair.leader)) || is_gone(static_cast<std::size_t>(pair.follower)));
  // Every grown face that the state has is one of a bond that is gone, and the list of closed ones has it.
  std::set<int> grown;
  for (const fracture::GrownFace& face : state.faces.grown) {
    fits(face.term >= 0 && face.term < static_cast<int>(terms.size()) && grown.insert(face.term).second &&
         is_gone(static_cast<std::size_t>(face.term)) && scene.evolution->can_have(face));
  }
  fits(state.faces.closed.size() == scene.evolution->initial_faces() + grown.size() &&
       state.faces.closed_inside.size() == scene.system->face_count());
  const std::vector<int>& cut = scene.cut_bonds;
  fits(broken == static_cast<std::int64_t>(cut.size()) + state.broken_bonds &&
       std::all_of(cut.begin(), cut.end(), [&](int bond) { return is_gone(static_cast<std::size_t>(bond)); }));
}

// Values of a state in the form that the scene's have; those that the scene has at present where the state has none:
// functions are not among its bytes, and its loads may have been others.
scene::SceneValues fitted(const scene::SceneValues& values, const scene::SceneValues& present) {
  const auto fit = [](const std::vector<scene::Values>& of_state, const std::vector<scene::Values>& of_scene) {
    std::vector<scene::Values> all = of_scene;
    for (std::size_t i = 0; of_state.size() == of_scene.size() && i < all.size(); ++i)
      if (scene::are_alike(of_state[i], of_scene[i])) all[i] = of_state[i];
    return all;
  };
  return {fit(values.supports, present.supports), fit(values.loads, present.loads)};
}

bool has_lost_functions(const scene::SceneValues& values) {
  const auto is_lost = [](const scene::Values& one) {
    const auto* function = std::get_if<scene::BoundaryFunction>(&one);
    return function && !*function;
  };
  return std::any_of(values.supports.begin(), values.supports.end(), is_lost) ||
         std::any_of(values.loads.begin(), values.loads.end(), is_lost);
}

}  // namespace

SavedState Model::save(bool with_values) {
  if (!prepared_) fail(Failure::order, "there is no state yet; call bempd_prepare() or step first");
  if (loads_.acting == Acting::others) act_as_said();
  // From here on the run must not depend on how the present factorization came about: a restored one has a fresh one.
  prepared_->evolution->synchronize();
  const bool on_a_way = loads_.acting == Acting::on_a_way;
  const std::uint64_t said = on_a_way ? load_fingerprint(scene_, conditions_under(scene_.values()))
                                      : load_fingerprint(scene_, prepared_->conditions);
  return {prepared_->fingerprint,
          said,
          prepared_->evolution->state(),
          tip_history_,
          loads_.in_force,
          on_a_way,
          loads_.end_of_way,
          with_values ? std::optional(scene_.values()) : std::nullopt};
}

void Model::restore(const SavedState& state) {
  prepare();
  require(!state.said || state.scene.loads == prepared_->fingerprint.loads,
          "the state has the values of other loads, or of the same ones in another order; add those of the model that "
          "was saved, in its order");
  scene::SceneValues said = state.said ? fitted(*state.said, scene_.values()) : scene_.values();
  scene_.exchange_values(said);
  try {
    restore_body(state);
  } catch (...) {
    scene_.exchange_values(said);
    throw;
  }
}

void Model::restore_body(const SavedState& state) {
  require(state.scene.body == prepared_->fingerprint.body,
          "the state belongs to another scene; restore it into the model that was saved or one built in the same way");
  require(state.scene.supports == prepared_->fingerprint.supports,
          "the state was saved with other supports, or with the same ones in another order; add those of the model "
          "that was saved, in its order");
  const std::vector<scene::Crack> cracks = scene_.cracks();
  try {
    std::unique_ptr<PreparedScene> grown = as_grown(state.evolution.extensions);
    require_fit(state.evolution, grown ? *grown : *prepared_);
    if (grown) prepared_ = std::move(grown);
  } catch (...) {
    scene_.set_cracks(cracks);
    throw;
  }
  fracture::EvolutionState copy = state.evolution;
  Loads loads;
  if (state.in_force) loads.in_force = fitted(*state.in_force, scene_.values());
  regions::DofConditions conditions = conditions_under(scene_.values());
  const bool same_loads = state.load_fingerprint == load_fingerprint(scene_, conditions);
  if (same_loads && state.on_a_way) {
    conditions = conditions_under(*loads.in_force);
    loads.acting = Acting::on_a_way;
    loads.end_of_way = state.end_of_way;
  }
  replace_loads(std::move(conditions), loads.acting);
  // Loads given new values since the state was saved act on it from here on, and so do functions that its bytes do not
  // have.
  if (!same_loads || (state.on_a_way && has_lost_functions(*state.in_force))) {
    copy.in_equilibrium = false;
    copy.first_unit_energy = -1;
  }
  prepared_->evolution->restore(std::move(copy));
  loads_ = std::move(loads);
  tip_history_ = state.tips;
  ++generation_;
}

}  // namespace bempd::model
