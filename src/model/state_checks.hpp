#pragma once

#include "model/prepared_scene.hpp"
#include "model/saved_state.hpp"

namespace bempd::model {

// Throws Error (argument) unless the numbers of a state that was read from bytes are consistent with each other.
void require_consistent(const SavedState& state);

// Throws Error (argument) unless all extensions of a state lie in the scene's bounding box, or less than its diagonal
// away from it: what follows cracks, such as grids of blocks, may take numbers and time beyond all bounds otherwise.
void require_nearby(const std::vector<crack::Extension>& extensions, const Box& scene);

bool is_sound(const fracture::GrowingTip& tip);

// Throws Error (argument) for a state of format 15 or older if the scene places the cuts of initial cracks by their
// effective tips, because versions of that format did not do so.
void require_same_ends(const SavedState& saved, const regions::LatticeCracks& cracks);

// Whether a continuation fits the saved state and the scene (continuation_checks.cpp).
bool fits(const fracture::Continuation& continuation, const fracture::EvolutionState& state,
          const PreparedScene& scene);

}  // namespace bempd::model
