#include <algorithm>
#include <cmath>
#include <set>

#include "error.hpp"
#include "model/fingerprint.hpp"
#include "model/model.hpp"
#include "model/state_checks.hpp"

namespace bempd::model {

bool is_sound(const fracture::GrowingTip& tip) {
  const auto is_ratio = [](double ratio) { return ratio >= 0 && std::isfinite(ratio); };
  return tip.place.allFinite() && std::abs(tip.direction.norm() - 1) < 1e-6 && tip.law >= 0 && tip.id.crack >= 1 &&
         (tip.id.end == 0 || tip.id.end == 1) && std::isfinite(tip.even_ahead.value_or(0)) && tip.grown >= 0 &&
         std::isfinite(tip.grown) && tip.state <= crack::TipState::carried_on &&
         std::all_of(tip.energy_ratios.begin(), tip.energy_ratios.end(), is_ratio);
}

namespace {

// Throws Error (argument) for a state of format 15 or older if cuts of initial cracks are placed by their effective
// tips now, which those versions did not do.
void require_same_ends(const SavedState& saved, const regions::LatticeCracks& cracks) {
  const bool are_placed = std::ranges::any_of(cracks.even_ahead, [](const auto& ends) { return ends[0] || ends[1]; });
  require(saved.format > 15 || !are_placed, "the state has format version ", saved.format,
          ", in which initial cracks of lattices acted up to 0.6 spacings longer; repeat the run, or go on with the "
          "version of bempd that wrote it");
}

// Throws Error (argument) unless a state belongs to this body: its numbers may be consistent and still be those of
// another body.
void require_fit(const SavedState& saved, const PreparedScene& scene) {
  const fracture::EvolutionState& state = saved.evolution;
  const auto dofs = static_cast<Eigen::Index>(2 * scene.discretization.positions.size());
  const coupling::Terms& terms = scene.system->terms();
  const auto must = [](bool good) {
    require(good, "the state's arrays do not fit the scene that it names; its bytes were altered");
  };
  must(state.total_displacement.size() == dofs && state.stages.size() == terms.size() &&
       state.reactions.size() == 2 * state.history.size() * scene.conditions.reaction_dofs.size());
  must(state.tips.size() >= scene.first_tips && (scene.tip_laws > 0 || state.tips.empty()));
  for (const fracture::GrowingTip& tip : state.tips)
    must(is_sound(tip) && static_cast<std::size_t>(tip.law) < scene.tip_laws);
  const auto is_broken = [&](std::size_t term) { return terms.is_broken(term, state.stages[term]); };
  std::int64_t broken = 0;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    must(state.stages[t] <= terms.law_of(t).broken_stage());
    broken += is_broken(t) && !terms.follows(static_cast<int>(t)) ? 1 : 0;
  }
  for (const coupling::Terms::Following& pair : terms.following)
    must(!is_broken(static_cast<std::size_t>(pair.leader)) || is_broken(static_cast<std::size_t>(pair.follower)));
  // Each grown contact place of a state must belong to a broken bond, and the list of closed constraints must have an
  // entry for it.
  std::set<int> grown;
  for (const fracture::GrownFace& face : state.faces.grown) {
    must(face.term >= 0 && face.term < static_cast<int>(terms.size()) && grown.insert(face.term).second &&
         is_broken(static_cast<std::size_t>(face.term)) && scene.evolution->can_have(face));
  }
  must(state.faces.closed.size() == scene.evolution->first_grown_constraint() + grown.size());
  for (const std::vector<int>& terms_of_event : state.faces.pending)
    for (const int term : terms_of_event)
      must(term >= 0 && term < static_cast<int>(terms.size()) && is_broken(static_cast<std::size_t>(term)));
  const std::vector<int>& cut = scene.cut_bonds;
  // A crack line that has continued in elements may have broken bonds that the scene's longer crack cuts now, so these
  // may be counted twice.
  const bool both = std::any_of(scene.discretization.cracks.begin(), scene.discretization.cracks.end(),
                                [](const auto& crack) { return crack.has_elements() && crack.cuts_bonds(); });
  const auto most = static_cast<std::int64_t>(cut.size()) + state.broken_bonds;
  must((both ? broken <= most && broken >= state.broken_bonds : broken == most) &&
       std::all_of(cut.begin(), cut.end(), [&](int bond) { return is_broken(static_cast<std::size_t>(bond)); }));
  must(fits(saved.continuation, state, scene));
}

// Values of a state, for conditions of the scene that are given in the same form. Present values replace those that the
// state lacks: functions are not written to bytes, and the scene may have other loads.
scene::SceneValues fitted(const scene::SceneValues& values, const scene::SceneValues& present) {
  const auto fit = [](const std::vector<scene::Values>& of_state, const std::vector<scene::Values>& of_scene) {
    std::vector<scene::Values> all = of_scene;
    for (std::size_t i = 0; of_state.size() == of_scene.size() && i < all.size(); ++i)
      if (scene::are_alike(of_state[i], of_scene[i])) all[i] = of_state[i];
    return all;
  };
  return {fit(values.supports, present.supports), fit(values.loads, present.loads)};
}

// Whether all values of a state are known and fit the conditions of this scene.
bool are_known(const scene::SceneValues& values, const scene::SceneValues& present) {
  return std::equal(values.supports.begin(), values.supports.end(), present.supports.begin(), present.supports.end(),
                    scene::are_alike) &&
         std::equal(values.loads.begin(), values.loads.end(), present.loads.begin(), present.loads.end(),
                    scene::are_alike);
}

}  // namespace

scene::SceneValues Model::acting_values() const {
  switch (loads_.acting) {
    case Acting::others:
      return *loads_.others;
    case Acting::on_a_way:
      return *loads_.in_force;
    case Acting::values:
      break;
  }
  return scene_.values();
}

SavedState Model::save(bool with_values) const {
  if (!prepared_) fail(Failure::order, "there is no state yet; call bempd_prepare() or step first");
  const std::uint64_t said =
      loads_.acting == Acting::values
          ? load_fingerprint(scene_, prepared_->conditions)
          : load_fingerprint(scene_, regions::apply_conditions(scene_, prepared_->discretization));
  std::vector<int> frozen;
  if (with_values)
    for (const auto& [crack, end] : frozen_tips_) frozen.insert(frozen.end(), {crack, end});
  return {
      .scene = prepared_->fingerprint,
      .load_fingerprint = said,
      .evolution = prepared_->evolution->state(),
      .continuation = prepared_->evolution->continuation(),
      .tips = tip_history_,
      .in_force = loads_.in_force,
      .acting = loads_.acting,
      .end_of_way = loads_.acting == Acting::on_a_way ? loads_.end_of_way : 0,
      .acting_values = acting_values(),
      .said = with_values ? std::optional(scene_.values()) : std::nullopt,
      .frozen = std::move(frozen),
      .overloads = numbers_of(fatigue_.overloads()),
  };
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
  if (!state.said) return;
  frozen_tips_.clear();
  for (std::size_t k = 1; k < state.frozen.size(); k += 2) frozen_tips_.insert({state.frozen[k - 1], state.frozen[k]});
}

void Model::restore_body(const SavedState& state) {
  const SceneFingerprint& present = prepared_->fingerprint;
  std::vector<RememberedOverload> overloads = overloads_of(state.overloads);
  require(state.scene.body == (state.format == 14 ? present.body_of_format_14 : present.body),
          "the state belongs to another scene; restore it into the model that was saved or one built in the same way");
  require_same_ends(state, prepared_->in_lattices);
  require(state.scene.supports == present.supports,
          "the state was saved with other supports, or with the same ones in another order; add those of the model "
          "that was saved, in its order");
  const std::vector<scene::Crack> cracks = scene_.cracks();
  try {
    std::unique_ptr<PreparedScene> grown = as_grown(state.evolution.extensions);
    require_fit(state, grown ? *grown : *prepared_);
    if (grown) prepared_ = std::move(grown);
  } catch (...) {
    scene_.set_cracks(cracks);
    throw;
  }
  fracture::EvolutionState copy = state.evolution;
  fracture::Continuation continuation = state.continuation;
  Loads loads;
  if (state.in_force) loads.in_force = fitted(*state.in_force, scene_.values());
  regions::DofConditions conditions = conditions_under(scene_.values());
  const bool same_loads = state.load_fingerprint == load_fingerprint(scene_, conditions);
  // If the saved loads differ from the present ones, they act until the next step, so that the change does work.
  loads.acting = same_loads ? state.acting : Acting::others;
  const bool known = loads.acting == Acting::values || are_known(state.acting_values, scene_.values());
  if (!known) {  // functions that its bytes do not have, or other loads: the present ones act at once
    if (loads.acting == Acting::others) loads.acting = Acting::values;
    copy.in_equilibrium = false;
    copy.first_unit_energy = -1;
  }
  if (loads.acting != Acting::values) {
    scene::SceneValues acting = fitted(state.acting_values, scene_.values());
    conditions = conditions_under(acting);
    if (loads.acting == Acting::on_a_way) {
      loads.end_of_way = state.end_of_way;
    } else {
      loads.others = std::move(acting);
    }
  }
  replace_loads(std::move(conditions), loads.acting);
  prepared_->evolution->restore(std::move(copy), std::move(continuation));
  loads_ = std::move(loads);
  tip_history_ = state.tips;
  fatigue_.set_overloads(std::move(overloads));
  ++generation_;
}

}  // namespace bempd::model
