#pragma once

#include "cancellation.hpp"
#include "model/model.hpp"

namespace bempd::model {

// Prepares the scene of a step. If the host asks to stop meanwhile, throws EventGivenUp and leaves the model
// unprepared.
inline void prepare_for_step(Model& model) {
  if (model.prepared_or_null()) return;
  const CancellationScope scope({CancellationScope::current().cancel, model.host().stop_request()});
  try {
    model.prepare();
  } catch (const EventGivenUp&) {
    model.call_failed(false, false);
    throw;
  }
}

// Result of a step. If the host asks to stop before the first equilibrium, the step has done nothing: the model is as
// before.
template <class Step>
StepResult unless_stopped(const Step& step) {
  try {
    return step();
  } catch (const EventGivenUp&) {
    return {fracture::StopReason::requested};
  }
}

}  // namespace bempd::model
