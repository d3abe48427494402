#include "model/model.hpp"

#include "error.hpp"
#include "linalg/blas.hpp"
#include "model/growth_options.hpp"
#include "regions/memory_limit.hpp"

namespace bempd::model {

void Model::set_option_text(std::string_view name, std::string_view value) {
  const KinkCriterion before = growth_criterion(options_);
  options_.set_text(name, value);
  if (growth_criterion(options_) == before) return;
  growth_.forget_factors();  // tips that are known have load factors by the other criterion
  preparation_.has_changed();
}

scene::Scene& Model::editable_scene() {
  if (preparation_.prepared())
    fail(Failure::order,
         "the model is prepared and its scene can no longer change; add everything before the first step or result, or "
         "create a new model");
  treatments_.remove_patches(), accuracy_.forget();
  return preparation_.scene();
}

void Model::prepare() {
  if (preparation_.prepared()) return;
  if (scene().region_ids().empty()) fail(Failure::order, "the scene has no region; add one first");
  treatments_.add_patches();
  regions::require_memory(scene(), options_);
  linalg::require_blas_buffer();
  accuracy_.prepare();
  preparation_.has_changed();
  preparation_.prepared()->anchored_pieces = pieces_.anchored_count();
  say([&] { reports_.tell_of_preparation(); });
}

PreparedScene& Model::prepared() {
  prepare();
  return *preparation_.prepared();
}

PreparedScene& Model::in_equilibrium() {
  prepare();
  if (loads_.present().acting == Acting::earlier) loads_.apply_pending();
  PreparedScene& prepared = *preparation_.prepared();
  fracture::CrackEvolution& evolution = *prepared.evolution;
  if (evolution.progress().in_equilibrium) return prepared;
  evolution.loads().find_equilibrium();
  say([&] {
    reports_.warn_of_equilibrium();
    if (evolution.progress().fragments == 0) return;
    reports_.log(1, text(evolution.progress().fragments,
                         " pieces are cut off from all supports by initial cracks; they are held"));
  });
  return prepared;
}

double Model::load_factor() const {
  const PreparedScene* const prepared = preparation_.prepared();
  return prepared ? prepared->evolution->progress().load_factor : 0.0;
}

void Model::call_failed(bool was_prepared, bool unsolvable) noexcept {
  const PreparedScene* const prepared = preparation_.prepared();
  if (!prepared) return treatments_.remove_patches();
  const fracture::EvolutionState& state = prepared->evolution->progress();
  const bool has_begun = state.in_equilibrium || !state.history.empty() || state.load_factor != 0;
  if (was_prepared && (has_begun || !unsolvable)) return;
  preparation_.exchange(nullptr);
  growth_.forget_factors();
  treatments_.remove_patches(), accuracy_.forget();
  loads_.present() = {};
  results_.forget();
  preparation_.has_changed();
}

}  // namespace bempd::model
