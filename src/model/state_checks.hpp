#pragma once

#include "model/prepared_scene.hpp"
#include "model/saved_state.hpp"

namespace bempd::model {

// Throws Error (argument) unless the numbers of a state that was read from bytes are consistent with each other.
void require_consistent(const SavedState& state);

bool is_sound(const fracture::GrowingTip& tip);

// Whether a continuation fits the saved state and the scene (continuation_checks.cpp).
bool fits(const fracture::Continuation& continuation, const fracture::EvolutionState& state,
          const PreparedScene& scene);

}  // namespace bempd::model
