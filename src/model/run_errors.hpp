#pragma once

#include <vector>

#include "crack/extension.hpp"
#include "fracture/evolution_state.hpp"

namespace bempd::model {

class Model;

// Results of a run that can be compared with those of a run of the same scene in another mesh.
struct RunAnswers {
  // Growth of all cracks before an event [m], and the resistance of the body at the event [N].
  struct Place {
    double grown, resistance;
  };
  std::vector<Place> places;  // one for each event
  std::vector<crack::Extension> extensions;
};

RunAnswers run_answers(const fracture::EvolutionState& state);

// Differences between the results of two runs, or errors of the results of one run.
struct RunDifference {
  double first_growth = 0;  // relative difference of the load factor of the first growth
  double peak = 0;          // relative difference of the largest resistance
  bool is_at_start = true;  // whether the largest resistance occurs before any growth
  double path = 0;          // largest distance between crack paths, or between tips along a path [m]
  int crack = 0;            // id of the crack with that distance
};

RunDifference difference(const RunAnswers& run, const RunAnswers& other);
// Relative amount by which the largest resistance of `other` exceeds that of `run`; 0 if it does not exceed it.
double rise_above_peak(const RunAnswers& run, const RunAnswers& other);
// Largest angle by which an extension turns from the previous extension of the same tip [rad].
double largest_turn_of(const RunAnswers& run);

// Errors of a run by source. The sources are reported side by side and never summed up.
struct RunErrors {
  double expected_seconds = 0;  // estimated time for finding the errors
  double seconds = 0;           // time that finding the errors took
  bool is_made = false;         // whether the errors were found
  bool has_patches = false;
  RunDifference boundary;  // error by the lengths of boundary elements and extensions
  RunDifference lattice;   // error by lattice patches in place of elements
};

// Errors of the model's run so far, found by further runs of its scene: one with extensions twice as long (and elements
// twice as long if the host gave the elements); one of the first extensions only, a quarter as long; and, if the scene
// has lattice patches, one with elements in place of the patches. If the estimated time exceeds `allowed` seconds,
// nothing is run and only that time is returned. Throws Error (order) for a run that cannot be repeated.
RunErrors errors_of_run(Model& model, double allowed);

}  // namespace bempd::model
