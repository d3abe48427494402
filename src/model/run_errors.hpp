#pragma once

#include <vector>

#include "crack/extension.hpp"
#include "fracture/evolution_state.hpp"

namespace bempd::model {

class Model;

// Results of a run that another mesh of the scene can have as well.
struct RunAnswers {
  // Growth of all cracks before an event [m], and the resistance of the body there [N].
  struct Place {
    double grown, resistance;
  };
  std::vector<Place> places;  // by event
  std::vector<crack::Extension> extensions;
};

RunAnswers run_answers(const fracture::EvolutionState& state);

// Differences of the results of two runs, or errors of those of a run.
struct RunDifference {
  double first_growth = 0;  // load factor of the first growth, relative
  double peak = 0;          // largest resistance, relative
  bool is_at_start = true;  // that is before any growth
  double path = 0;          // largest distance between paths, or between tips along them [m]
  int crack = 0;            // whose path that is
};

RunDifference difference(const RunAnswers& run, const RunAnswers& other);
// Share by which the resistance of another run exceeds the peak of the first one; 0 if it does not.
double rise_above_peak(const RunAnswers& run, const RunAnswers& other);
// Largest angle by which an extension turns behind another one of the same tip [rad].
double largest_turn_of(const RunAnswers& run);

// Errors of a run, one for each source; they are told side by side and never summed up.
struct RunErrors {
  double expected_seconds = 0;  // that they take, roughly
  double seconds = 0;           // that they took
  bool is_made = false;
  bool has_patches = false;
  RunDifference boundary;  // lengths of boundary elements and of extensions
  RunDifference lattice;   // lattice patches in place of elements
};

// Errors of the run of a model until now, from further runs of its scene: one with extensions twice as long (and
// elements twice as long if the host gave them); one of the first extensions only, a quarter as long; and, if the scene
// has lattice patches, one with elements in their place. Nothing is run if that takes longer than `allowed` seconds by
// estimate. Throws Error (order) for a run that cannot be repeated.
RunErrors errors_of_run(Model& model, double allowed);

}  // namespace bempd::model
