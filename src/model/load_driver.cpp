#include "model/load_driver.hpp"

#include <cmath>
#include <span>

#include "error.hpp"
#include "model/element_carrier.hpp"
#include "model/model.hpp"
#include "model/step_beginning.hpp"
#include "model/stepping_options.hpp"
#include "stopwatch.hpp"

namespace bempd::model {

namespace {

// Number of the first event in the lines of a run's history at which equilibrium was lost; 0 if equilibrium was never
// lost.
std::int64_t first_unstable(std::span<const fracture::HistoryEntry> lines) {
  for (const fracture::HistoryEntry& line : lines)
    if (line.stretch_ratio > 1 + fracture::ratio_rounding) return line.event;
  return 0;
}

}  // namespace

StepResult LoadDriver::advance(double target, fracture::Goal goal) {
  prepare_for_step(model_);
  LoadValues& loads = model_.loads();
  std::optional<scene::SceneValues> host_values = model_.scene().values();
  std::optional<LoadValues::Before> before;
  const double from = model_.load_factor();
  if (loads.present().acting != Acting::values) before = loads.apply_pending();
  try {
    const StepResult result = run(target, goal);
    say([&] {
      model_.accuracy().journal().enter(from, target, model_.load_factor(), *host_values, model_.growth().frozen(),
                                        model_.cracks().extensions(), result.seconds_total);
    });
    loads.present().in_force.swap(host_values);
    return result;
  } catch (...) {
    if (before) loads.go_back_to(std::move(*before));
    throw;
  }
}

StepResult LoadDriver::advance_to_values(double target, fracture::Goal goal) {
  prepare_for_step(model_);
  LoadValues& loads = model_.loads();
  const double present = model_.load_factor();
  std::optional<scene::SceneValues> host_values = model_.scene().values();
  regions::DofConditions at_end = regions::apply_conditions(model_.scene(), model_.prepared().discretization);
  std::optional<LoadValues::Before> before;
  std::optional<scene::SceneValues> way;
  if (loads.present().acting == Acting::on_path && target == loads.present().path_end) {
    way = loads.present().in_force;
  } else {
    require(target != present, "load_factor is ", target,
            ", where the model is already; values move with the load factor, so give another one, such as the time at "
            "the end of the step");
    require(std::abs(target - present) >= 1e-8 * std::abs(target), "load_factor is ", target,
            ", nearer than 1e-8 of it to ", present,
            ", where the model is: values on so short a way lose that many digits; let the load factor count "
            "from a later beginning, or in larger steps");
    way = scene::line_between(loads.present().in_force ? *loads.present().in_force : scene::at_rest(*host_values),
                              present, *host_values, target);
    before = loads.replace(loads.conditions_under(*way), Acting::on_path);
  }
  try {
    const PreparedScene* const before_run = model_.prepared_or_null();
    const StepResult result = run(target, goal, &*way);
    model_.accuracy().journal().is_known = false;
    loads.present().in_force.swap(way);
    loads.present().path_end = target;
    using fracture::StopReason;
    const bool arrived = result.reason == StopReason::load_factor ||
                         (result.reason == StopReason::separated && goal == fracture::Goal::load_factor);
    if (arrived)
      loads.arrive(model_.prepared_or_null() == before_run ? std::optional(std::move(at_end)) : std::nullopt,
                   std::move(host_values));
    return result;
  } catch (...) {
    if (before) loads.go_back_to(std::move(*before));
    throw;
  }
}

fracture::LoadInterval LoadDriver::admissible_load_factors() {
  return model_.in_equilibrium().evolution->body().response().admissible();
}

StepResult LoadDriver::run(double target, fracture::Goal goal, const scene::SceneValues* on_way) {
  fracture::SteppingOptions stepping = stepping_options(model_.options());
  stepping.stop = model_.host().stop_request();
  stepping.frozen = model_.growth().frozen();
  const bool drives = model_.growth().is_driven_by(stepping);
  if (drives) say([&] { model_.reports().tell_of_whole_body(); });
  ElementCarrier elements(model_, on_way, drives);
  stepping.elements = &elements;
  const fracture::EvolutionState& begin = model_.prepared().evolution->progress();
  const fracture::Sums sums = begin;
  const auto lines = static_cast<std::ptrdiff_t>(begin.history.size());
  const TimeSpent before = time_spent_in(model_.prepared());
  StepResult result;
  {
    const Stopwatch watch(result.seconds_total);
    model_.preparation().has_changed();
    run_recording(target, goal, stepping, elements, result);
  }
  const fracture::EvolutionState& end = model_.prepared().evolution->progress();
  result.events = end.events - sums.events;
  result.broken_bonds = end.broken_bonds - sums.broken_bonds;
  result.face_switches = end.contact_switches - sums.contact_switches;
  result.ties = end.ties - sums.ties;
  result.unstable_event = first_unstable(std::span(end.history).subspan(lines));
  result.seconds = time_spent_in(model_.prepared());
  result.seconds += elements.spent();
  result.seconds -= before;
  say([&] { model_.reports().tell_of_step(result, end.fragments - sums.fragments, target >= end.load_factor); });
  return result;
}

}  // namespace bempd::model
