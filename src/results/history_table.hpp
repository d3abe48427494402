#pragma once

#include <string>
#include <vector>

#include "fracture/evolution_state.hpp"

namespace bempd::results {

// Support whose columns a table has, unless it was removed. A name stands behind the headings: reaction_x_1 (clamp).
struct SupportColumns {
  bool there;
  std::string name;  // empty: none
};

// Writes the history as a CSV table, a line per entry, with the reactions of all supports. `state` is null before the
// first step: then there are no lines. Throws Error (io).
void write_history(const std::string& path, const fracture::EvolutionState* state,
                   const std::vector<SupportColumns>& supports);

}  // namespace bempd::results
