#include "error.hpp"
#include "model/driven_growth.hpp"
#include "model/element_carrier.hpp"
#include "model/model.hpp"

namespace bempd::model {

namespace {

// Whether the body counts as separated although a few bonds still connect the held and the loaded part, like a hinge.
bool hangs(Model& model) {
  const PreparedScene& prepared = model.prepared();
  return prepared.evolution->progress().separated && model.pieces().anchored_count() <= prepared.anchored_pieces;
}

}  // namespace

void LoadDriver::run_recording(double target, fracture::Goal goal, const fracture::SteppingOptions& stepping,
                               ElementCarrier& elements, StepResult& result) {
  const std::size_t recorded = model_.cracks().history().size();
  const auto every = static_cast<std::int64_t>(model_.options().number("tips.record"));
  const auto on_event = [&](const fracture::EvolutionState& state) {
    if (every > 0 && state.events % every == 0) model_.cracks().record();
    if (!model_.host().goes_on(state))
      fail(Failure::cancelled, "the progress callback asked to stop; the model is back at the start of the step");
    if (model_.host().cancel_requested())
      fail(Failure::cancelled, "cancelled on request; the model is back at the start of the step");
  };
  const auto on_end = [&] {
    if (every > 0 && model_.prepared().evolution->progress().history.back().event == 0) model_.cracks().record();
    result.hanging = hangs(model_);
  };
  try {
    result.reason = model_.prepared().evolution->advance(target, goal, stepping, on_event, on_end);
  } catch (...) {
    model_.cracks().keep_records(recorded);
    elements.take_back();
    throw;
  }
}

}  // namespace bempd::model
