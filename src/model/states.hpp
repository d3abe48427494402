#pragma once

#include <functional>
#include <memory>

#include "model/load_values.hpp"
#include "model/prepared_scene.hpp"
#include "model/saved_state.hpp"

namespace bempd::model {

class Model;

// Saves the state of a model's run, and restores a state in this model or in another model that was built in the same
// way.
class States {
 public:
  explicit States(Model& model) : model_(model) {}

  // `with_values`: the state also has the values that the host has set, and the tips that the host keeps frozen.
  SavedState save(bool with_values = false) const;
  void restore(const SavedState& state);

 private:
  void restore_body(const SavedState& state);
  // Prepares the scene with the crack growth of a saved state, checks that the state fits the scene, and calls `go_on`
  // in it. After a failure the scene is as before.
  void grow_as(const SavedState& state, const std::function<void()>& go_on);
  // Lets the loads of a saved state act on the prepared scene, as far as they are known. `evolution` is the state's.
  LoadValues::ActingValues take_loads(const SavedState& state, fracture::EvolutionState& evolution);
  // Scene with the crack growth of a saved state; null if the present scene has this growth already.
  std::unique_ptr<PreparedScene> as_grown(const fracture::EvolutionState& state);
  bool has_grown_as(const fracture::EvolutionState& state) const;

  Model& model_;
};

}  // namespace bempd::model
