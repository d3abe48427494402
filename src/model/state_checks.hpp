#pragma once

#include "model/saved_state.hpp"

namespace bempd::model {

// Throws Error (argument) unless the numbers of a state that was read from bytes go together.
void require_consistent(const SavedState& state);

}  // namespace bempd::model
