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

// Record of the steps of a run so far, by which another mesh of the same scene can repeat the run: how far cracks have
// grown, and under which loads. A run with other calls than steps cannot be repeated.
struct RunJournal {
  // Successive steps in one direction of the load factor, under the same values of loads and supports and with the same
  // frozen tips.
  struct Piece {
    std::shared_ptr<const scene::SceneValues> values;  // shared with copies of the journal in states
    std::set<crack::TipId> frozen;
    double target = 0;    // target load factor
    double end = 0;       // load factor reached
    bool upwards = true;  // towards the target
    double grown = -1;    // length of all growth at the end of the steps [m]; negative: no growth in them
  };

  std::vector<Piece> pieces;
  // Whether the run can be repeated: not after growth by given lengths or cycles, load programs, or a state that was
  // read from bytes.
  bool is_known = true;
  bool has_new_values = false;  // whether values were set since the last piece
  std::size_t extensions = 0;   // number of extensions that are counted in `grown`
  double grown = 0;             // length of all growth [m]
  double seconds = 0;           // time that all steps took

  // Journal of a run that continues from a state: the journal of the state or, if the state has none, a journal that
  // says that the run cannot be repeated.
  static RunJournal continued(const std::optional<RunJournal>& of_state);
  // Enters a step from the load factor `from` towards `target`, which ended at `end`. `values` are stored only if they
  // are new; `all` are all extensions of the run.
  void enter(double from, double target, double end, scene::SceneValues values, const std::set<crack::TipId>& frozen,
             std::span<const crack::Extension> all, double seconds_of_step);
};

}  // namespace bempd::model
