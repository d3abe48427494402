#include <algorithm>

#include "error.hpp"
#include "model/model.hpp"
#include "model/step_beginning.hpp"

// Load programs: tables of values by time, where the load factor is the time.
namespace bempd::model {

namespace {

void add(StepResult& sum, const StepResult& step) {
  sum.reason = step.reason;
  sum.events += step.events;
  sum.broken_bonds += step.broken_bonds;
  sum.face_switches += step.face_switches;
  sum.ties += step.ties;
  if (sum.unstable_event == 0) sum.unstable_event = step.unstable_event;
  sum.seconds_total += step.seconds_total;
  sum.seconds += step.seconds;
  sum.hanging = step.hanging;
}

}  // namespace

// Runs to the time of one row of a table, with values that change linearly from those of the previous row.
StepResult LoadDriver::run_to_row(const scene::LoadTable& table, std::size_t row, const scene::SceneValues& given,
                                  fracture::Goal goal) {
  LoadValues& loads = model_.loads();
  const double present = model_.load_factor(), end = table.times[row];
  const scene::SceneValues at_end = table.at(row, given);
  std::optional<scene::SceneValues> way;
  if (end == present) {
    way = at_end;
  } else if (row == 0) {
    way = scene::line_between(loads.present().in_force ? *loads.present().in_force : scene::at_rest(given), present,
                              at_end, end);
  } else {
    way = scene::line_between(table.at(row - 1, given), table.times[row - 1], at_end, end);
  }
  LoadValues::Before before = loads.replace(loads.conditions_under(*way), Acting::on_path);
  StepResult result;
  try {
    result = run(end, goal, &*way);
    model_.accuracy().journal().is_known = false;
  } catch (const EventGivenUp&) {  // before the first equilibrium of this row: the rows before stay
    loads.go_back_to(std::move(before));
    return {fracture::StopReason::requested};
  }
  // If nothing can break before the row's time, the run moves on to that time.
  if (result.reason == fracture::StopReason::no_further_event && model_.load_factor() != end) {
    add(result, run(end, fracture::Goal::load_factor, &*way));
  }
  if (result.reason == fracture::StopReason::no_further_event) result.reason = fracture::StopReason::load_factor;
  loads.present().in_force.swap(way);
  loads.present().path_end = end;
  return result;
}

StepResult LoadDriver::run_program(const scene::LoadTable& table, fracture::Goal goal) {
  table.check(model_.scene());
  require(
      model_.options().text_value("stepping.control") == "load",
      "stepping.control is path, by which the load factor falls where growth is unstable; a program goes on in time: "
      "set it to load");
  prepare_for_step(model_);
  const double present = model_.load_factor(), end = table.times.back();
  const fracture::EvolutionState& state = model_.prepared().evolution->progress();
  const bool has_begun = state.in_equilibrium || !state.history.empty();
  require(end > present || (end == present && !has_begun), "the last time of the program is ", end,
          ", and the load factor is ", present, " already; times go on from there");
  const SavedState start = model_.states().save();
  try {
    const scene::SceneValues given = model_.scene().values();
    StepResult sum{fracture::StopReason::load_factor};
    auto row = static_cast<std::size_t>(std::lower_bound(table.times.begin(), table.times.end(), present) -
                                        table.times.begin());
    // A row whose time is the present load factor is skipped, unless it is the first or the last row.
    if (row + 1 < table.times.size() && row > 0 && table.times[row] == present) ++row;
    for (; row < table.times.size(); ++row) {
      add(sum, run_to_row(table, row, given, goal));
      const bool arrived = sum.reason == fracture::StopReason::load_factor ||
                           (sum.reason == fracture::StopReason::separated && goal == fracture::Goal::load_factor);
      if (!arrived) break;
    }
    return sum;
  } catch (...) {
    // The host's wish to cancel has been heard: it does not end the way back.
    const CancellationScope no_cancel(nullptr);
    const ListeningScope no_listener(nullptr);
    model_.states().restore(start);
    throw;
  }
}

}  // namespace bempd::model
