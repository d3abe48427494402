#pragma once

#include <string>
#include <vector>

#include "fracture/evolution_state.hpp"

namespace bempd::results {

// Writes the history as a CSV table, a line per entry, with the reactions of all supports that are `there` (not
// removed). `state` is null before the first step: then there are no lines. Throws Error (io).
void write_history(const std::string& path, const fracture::EvolutionState* state, const std::vector<char>& there);

}  // namespace bempd::results
