#pragma once

#include <string>
#include <vector>

#include "fracture/evolution_state.hpp"

namespace bempd::results {

// Support in the table of the history. A removed support (`there` is false) has no columns. A name stands behind the
// headings: reaction_x_1 (clamp).
struct SupportColumns {
  bool there;
  std::string name;  // empty: the support has no name
};

// Writes the history as a CSV table: a line per entry, with the reactions of all supports. If `state` is null, before
// the first step, the table has no lines. Throws Error (io).
void write_history(const std::string& path, const fracture::EvolutionState* state,
                   const std::vector<SupportColumns>& supports);

}  // namespace bempd::results
