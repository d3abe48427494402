#include "fracture/event_sources.hpp"

#include <algorithm>
#include <utility>

#include "fracture/window/window_settings.hpp"

namespace bempd::fracture {

EventSources::EventSources(LoadedBody& body, const std::vector<int>& cut)
    : body_(body), whole_body_(body), contact_(body), window_(body, [this] { keep_present(); }) {
  window_.expect_cracks(cut);
}

bool EventSources::may_use_window(double target, const SteppingOptions& options) const {
  return options.window && options.mode == SteppingMode::events && has_window_form(body_.system()) &&
         !body_.has_fluid() && target >= body_.state().load_factor;
}

void EventSources::grow_lines(pd::TipLaws laws, FactorsAround factors) {
  settle();
  lines_.emplace(body_, whole_body_, std::move(laws), std::move(factors));
  window_.follow(lines_->steps());
}

void EventSources::freeze(const std::set<crack::TipId>& tips) {
  if (!lines_ || lines_->steps().frozen() == tips) return;
  if (window_.is_open()) settle();
  lines_->freeze(tips);
}

const Event* EventSources::next(double target, const SteppingOptions& options) {
  const bool possible = may_use_window(target, options);
  // Tips with elements need the displacements of the whole body, which are then computed at each event of a window.
  const auto comes_first = [&](const Event* event) {
    const double present = body_.state().load_factor;
    return options.elements && event &&
           first_with(*options.elements, event, {present, target >= present, options.control}) != event;
  };
  if (window_.is_open() && !(possible && window_.suits(options))) settle();
  while (possible) {
    if (!window_.is_open()) open_window(target, options);
    if (!window_.is_open()) break;
    told_ = &window_;
    const Event* breaks = window_.next(target, options);
    const bool element_comes_first = comes_first(breaks);
    if (breaks && !element_comes_first) return breaks;
    if (window_.events_performed() >= (lines_ ? WindowSettings::worthwhile_steps : 1)) {
      patience_ = 1;
      if (window_.needs_whole_body()) whole_body_events_ = 1;
      if (window_.ended_at_faces()) whole_body_events_ = WindowSettings::events_beside_faces;
    } else {
      be_patient();
    }
    settle();
    if (element_comes_first) break;
  }
  EventSource& source = everywhere();
  const Event* event = source.next(target, options);
  if (options.elements) {
    const double present = body_.state().load_factor;
    event = first_with(*options.elements, event, {present, target >= present, options.control});
  }
  return first_of(source, event, target);
}

// First of two events in the order of all tips: `event`, a break or line step in lattices (null if there is none), and
// the next growth of tips with elements. Null if neither exists.
const Event* EventSources::first_with(crack::Carrier& elements, const Event* event, const crack::LoadWay& way) {
  std::vector<crack::Candidate> candidates = elements.candidates(way);
  if (event) {
    const bool is_due = event->load_factor == way.present;
    candidates.push_back(crack::candidate(event->tip, event->load_factor, is_due ? event->ratio : 1, way));
  }
  const std::optional<crack::FirstToGrow> first = crack::first_to_grow(candidates, way.upwards);
  if (!first || (event && first->index + 1 == candidates.size())) return event;
  const crack::Candidate& chosen = candidates[first->index];
  growth_ = {way.place_of(chosen.load_factor), chosen.ratio, chosen.load_factor, {}};
  growth_.tip = chosen.tip, growth_.ties = first->ties, growth_.is_growth = true;
  return &growth_;
}

EventSource& EventSources::everywhere() {
  if (lines_) return *lines_;
  return whole_body_;
}

// First event on the way to the target: `event` of the given source, or faces that close or open before it.
const Event* EventSources::first_of(EventSource& source, const Event* event, double target) {
  const Event* contact = contact_.before(event, target);
  told_ = contact ? static_cast<EventSource*>(&contact_) : &source;
  return contact ? contact : event;
}

void EventSources::open_window(double target, const SteppingOptions& options) {
  if (body_.state().separated || whole_body_events_ > 0) return;
  const std::optional<double> next = next_in_window(target, options);
  if (!next || *next > target || contact_.is_before(*next)) return;
  Event breaks;
  breaks.load_factor = *next;
  const LoadWay way{body_.state().load_factor, true, options.control};
  if (options.elements && first_with(*options.elements, &breaks, way) != &breaks) return;
  if (!window_.open(*next, options)) be_patient();
}

// Load factor of the next event if a window could perform it; empty otherwise.
std::optional<double> EventSources::next_in_window(double target, const SteppingOptions& options) {
  if (!lines_) return body_.next_critical(body_.way_to(target, options.control));
  const Event* event = lines_->next(target, options);
  return event && lines_->tells_step() ? std::optional(event->load_factor) : std::nullopt;
}

void EventSources::be_patient() {
  patience_ = std::min(2 * patience_, WindowSettings::most_patience);
  whole_body_events_ = patience_;
}

Outcome EventSources::perform() {
  if (told_ == &everywhere()) whole_body_events_ = std::max(0, whole_body_events_ - 1);
  return told_->perform();
}

void EventSources::settle() {
  keep_way_on();
  complete_mark();
  close_awaited();
  window_.close();
}

void EventSources::forget() {
  awaited_.reset();
  window_.forget();
  whole_body_events_ = 0;
  patience_ = 1;
}

void EventSources::abandon() noexcept {
  window_.abandon();
  awaited_.reset();
  is_stale_ = true;
}

void EventSources::refresh() {
  if (!is_stale_) return;
  std::optional<Continuation> awaited = std::move(awaited_);
  try {
    forget();
    body_.restore();
    if (awaited) remember(*awaited);
  } catch (...) {
    awaited_ = std::move(awaited);
    throw;
  }
  is_stale_ = false;
  if (!awaited || !awaited->window) return;
  awaited_ = std::move(awaited);
  if (!body_.state().in_equilibrium) close_awaited();  // other loads act since
}

// Begins a call that can be taken back. The continuation is kept at once only if no window is open, because the first
// search for an event may then change the system's factor. With an open window nothing changes before the first mark.
void EventSources::begin_call() {
  call_.emplace();
  if (!window_.is_open()) keep_way_on();
}

void EventSources::keep_way_on() {
  if (call_ && !call_->way_on) call_->way_on = continuation();
}

void EventSources::give_up_event(const BodyState& before) {
  // A window that was opened meanwhile has its only mark at this state.
  if (mark_ && mark_->place) mark_ = Mark{before, {}};
  abandon();
}

void EventSources::drop_mark() {
  mark_.reset();
  call_.reset();
}

void EventSources::mark() {
  if (mark_) return;
  keep_way_on();
  mark_ = window_.is_open() ? Mark{{}, window_.place()} : Mark{body_.state(), {}};
}

// Keeps the present state to the last bit, because displacements that are computed again later would have other
// rounding errors.
void EventSources::keep_present() {
  mark();
  complete_mark();
}

void EventSources::complete_mark() {
  if (!mark_ || !mark_->place) return;
  mark_->state = window_.state_at(*mark_->place);
  mark_->place.reset();
}

void EventSources::return_to_mark() noexcept {
  const bool has_state = mark_ && !mark_->place;
  if (has_state) body_.state() = std::move(mark_->state);
  if (mark_ && mark_->place) window_.return_to(*mark_->place);
  // An open window is intact if the mark is a position in it, or if nothing was marked; all else may be half done.
  if (has_state || !window_.is_open()) {
    abandon();
    if (call_ && call_->way_on) continue_with(std::move(*call_->way_on));
  }
  drop_mark();
}

}  // namespace bempd::fracture
