#pragma once

#include <string>

#include "fracture/evolution_state.hpp"

namespace bempd::results {

// A line for every entry of the history with the reactions of all supports; `state` is null before the first step.
// Throws Error (io).
void write_history(const std::string& path, const fracture::EvolutionState* state, std::size_t support_count);

}  // namespace bempd::results
