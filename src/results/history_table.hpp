#pragma once

#include <string>
#include <vector>

#include "fracture/evolution_state.hpp"

namespace bempd::results {

// Writes a line for every entry of the history with the reactions of all supports that are `there`; `state` is null
// before the first step. Throws Error (io).
void write_history(const std::string& path, const fracture::EvolutionState* state, const std::vector<char>& there);

}  // namespace bempd::results
