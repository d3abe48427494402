#include "model/run_journal.hpp"

#include <algorithm>
#include <utility>

namespace bempd::model {

// Largest number of pieces of a journal (successive steps under the same loads): hosts that change values before each
// of very many steps would fill the memory with copies of the values.
constexpr std::size_t most_pieces = 1000;

RunJournal RunJournal::continued(const std::optional<RunJournal>& of_state) {
  RunJournal journal = of_state.value_or(RunJournal());
  journal.is_known &= of_state.has_value();
  journal.has_new_values = true;
  return journal;
}

void RunJournal::enter(double from, double target, double end, scene::SceneValues values,
                       const std::set<crack::TipId>& frozen, std::span<const crack::Extension> all,
                       double seconds_of_step) {
  seconds += seconds_of_step;
  if (!is_known) return;
  const bool upwards = target >= from;
  if (pieces.empty() || has_new_values || pieces.back().upwards != upwards || pieces.back().frozen != frozen) {
    is_known = pieces.size() < most_pieces;
    if (!is_known) return pieces.clear();
    pieces.push_back({std::make_shared<const scene::SceneValues>(std::move(values)), frozen, target, end, upwards, -1});
    has_new_values = false;
  }
  Piece& piece = pieces.back();
  piece.end = end;
  piece.target = upwards ? std::max(piece.target, target) : std::min(piece.target, target);
  for (; extensions < all.size(); ++extensions) piece.grown = grown += all[extensions].length;
}

}  // namespace bempd::model
