#include "fracture/run_events.hpp"

#include <algorithm>
#include <utility>

#include "error.hpp"

namespace bempd::fracture {

void RunEvents::begin(const SteppingOptions& options) {
  records_.set_mode(options.mode);
  next_ = nullptr;
  sources_.refresh();
  sources_.freeze(options.frozen);
  sources_.go_on();
  sources_.return_point().begin_call();
}

const Event* RunEvents::next(double target, const SteppingOptions& options) {
  next_ = sources_.next(target, options);
  return next_;
}

void RunEvents::move_to(double load_factor) { records_.add_work(body_.response().move_to(load_factor)); }

void RunEvents::perform(const Event& event) {
  const double within_before = inner_work_.at(event.load_factor);
  Outcome outcome = sources_.perform();
  outcome.within_before = within_before;
  records_.book(event, outcome);
}

bool RunEvents::perform_if_possible(const Event& event) {
  BodyState before = state_;
  const RunRecords::Start start = records_.start();
  try {
    perform(event);
    return true;
  } catch (const Error& error) {
    if (error.failure() != Failure::unsolvable) throw;
    records_.forget_since(start);
    static_cast<BodyState&>(state_) = std::move(before);
    sources_.abandon();
    sources_.refresh();
    return false;
  }
}

std::optional<RunEvents::Before> RunEvents::before() {
  if (sources_.is_in_window()) return std::nullopt;
  return Before{state_, records_.start()};
}

void RunEvents::give_up(Before before) {
  records_.forget_since(before.start);
  sources_.give_up_event(before.body);
  static_cast<BodyState&>(state_) = std::move(before.body);
  sources_.refresh();
}

void RunEvents::return_to(const RunRecords::Start& start) noexcept {
  records_.forget_since(start);
  sources_.return_to_mark();
}

void RunEvents::extend_line(const crack::TipId& tip, const std::optional<Point>& direction) {
  sources_.refresh(), sources_.settle();
  const Event* step = sources_.line_step(tip, direction);
  if (step) perform(*step);
  sources_.bring_up_to_date();
}

void RunEvents::stop_line(const crack::TipId& tip, crack::TipState state) {
  sources_.refresh();
  sources_.settle();
  for (GrowingTip& one : state_.tips)
    if (one.id == tip) one.state = state;
  const auto last = std::find_if(state_.extensions.rbegin(), state_.extensions.rend(),
                                 [&](const CrackExtension& e) { return e.tip() == tip; });
  if (last != state_.extensions.rend()) last->state = crack::TipState::at_interface;
}

void RunEvents::stop(const std::vector<crack::TipId>& tips) {
  state_.stopped.insert(state_.stopped.end(), tips.begin(), tips.end());
}

}  // namespace bempd::fracture
