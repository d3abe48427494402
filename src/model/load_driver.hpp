#pragma once

#include <cstddef>

#include "model/answers.hpp"
#include "scene/load_table.hpp"
#include "scene/scene_values.hpp"

namespace bempd::model {

class ElementCarrier;
class Model;

// Steps and load programs: moves the load factor, and with it the values of loads and supports, while bonds break and
// cracks grow. A call that fails or is cancelled leaves the model as it was before.
class LoadDriver {
 public:
  explicit LoadDriver(Model& model) : model_(model) {}

  // Moves the load factor to a target, at the values of loads and supports that the host has set.
  StepResult advance(double target, fracture::Goal goal);
  // Moves the load factor to a target. On the way loads and supports change linearly with the load factor, from their
  // values at the end of the last step to the values that the host has set since.
  StepResult advance_to_values(double target, fracture::Goal goal);
  // Runs a table of load values row by row, from the present load factor on (programs.cpp). The load factor is the time
  // of the table.
  StepResult run_program(const scene::LoadTable& table, fracture::Goal goal);

  fracture::LoadInterval admissible_load_factors();

 private:
  // Runs to a target load factor. `on_way` are the values of loads and supports that act; null for those that the host
  // has set.
  StepResult run(double target, fracture::Goal goal, const scene::SceneValues* on_way = nullptr);
  // Runs to a target, records tips meanwhile, and calls the host's progress function after each event (recording.cpp).
  void run_recording(double target, fracture::Goal goal, const fracture::SteppingOptions& stepping,
                     ElementCarrier& elements, StepResult& result);
  StepResult run_to_row(const scene::LoadTable& table, std::size_t row, const scene::SceneValues& given,
                        fracture::Goal goal);

  Model& model_;
};

}  // namespace bempd::model
