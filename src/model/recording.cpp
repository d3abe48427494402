#include "error.hpp"
#include "model/driven_growth.hpp"
#include "model/element_carrier.hpp"
#include "model/model.hpp"

namespace bempd::model {

void Model::record_tips() {
  const fracture::HistoryEntry& line = prepared_->evolution->state().history.back();
  for (const regions::TipValues& tip : compute_tips())
    tip_history_.push_back({line.event, line.total_broken_bonds, line.load_factor, tip});
}

void Model::run_recording(double target, fracture::Goal goal, const fracture::SteppingOptions& stepping,
                          ElementCarrier& elements, StepResult& result) {
  const auto recorded = static_cast<std::ptrdiff_t>(tip_history_.size());
  const auto every = static_cast<std::int64_t>(options_.number("tips.record"));
  const auto on_event = [&](const fracture::EvolutionState& state) {
    if (every > 0 && state.events % every == 0) record_tips();
    const bool go_on = !progress_ || progress_(state.load_factor, state.events, state.broken_bonds);
    if (!go_on)
      fail(Failure::cancelled, "the progress callback asked to stop; the model is back at the start of the step");
    if (cancel_requested_) fail(Failure::cancelled, "cancelled on request; the model is back at the start of the step");
  };
  const auto on_end = [&] {
    if (every > 0 && prepared_->evolution->progress().history.back().event == 0) record_tips();
    result.hanging = hangs();
  };
  try {
    result.reason = prepared_->evolution->advance(target, goal, stepping, on_event, on_end);
  } catch (...) {
    tip_history_.erase(tip_history_.begin() + recorded, tip_history_.end());
    elements.take_back();
    throw;
  }
}

}  // namespace bempd::model
