#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "crack/extension.hpp"
#include "scene/scene_values.hpp"

namespace bempd::model {

// Steps of a run so far, as another mesh of the same scene can repeat them: how far cracks have grown, and under which
// loads. A run of other calls cannot be repeated.
struct RunJournal {
  // Successive steps to load factors in one direction, under the same values of loads and supports.
  struct Piece {
    std::shared_ptr<const scene::SceneValues> values;  // shared by copies of the journal, which states have
    std::set<crack::TipId> frozen;
    double target = 0;    // load factor
    double end = 0;       // load factor reached
    bool upwards = true;  // towards the target
    double grown = -1;    // length of all growth at their end [m]; negative: none in these steps
  };

  std::vector<Piece> pieces;
  bool is_known = true;  // false: growth by given lengths or cycles, programs, or a state that was read from bytes
  bool has_new_values = false;  // since the last piece
  std::size_t extensions = 0;   // that are counted in `grown`
  double grown = 0;             // [m]
  double seconds = 0;           // that the steps took

  // Journal of a run that goes on from a state: the state's journal, or without one a journal that says that the run
  // before is not known.
  static RunJournal continued(const std::optional<RunJournal>& of_state);
  // Enters a step from one load factor towards another, which ended at a third. `values` are taken if they are new.
  void enter(double from, double target, double end, scene::SceneValues values, const std::set<crack::TipId>& frozen,
             std::span<const crack::Extension> all, double seconds_of_step);
};

}  // namespace bempd::model
