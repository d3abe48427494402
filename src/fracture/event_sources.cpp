#include "fracture/event_sources.hpp"

#include <algorithm>
#include <utility>

#include "fracture/window/window_settings.hpp"

namespace bempd::fracture {

EventSources::EventSources(LoadedBody& body, const std::vector<int>& cut)
    : body_(body),
      whole_body_(body),
      contact_(body),
      window_(body, [this] { return_point_.mark(), return_point_.complete(); }),
      resumption_(body, window_, patience_),
      return_point_(body, window_, resumption_) {
  window_.expect_cracks(cut);
}

bool EventSources::may_use_window(double target, const SteppingOptions& options) const {
  return options.window && options.mode == SteppingMode::events && has_window_form(body_.system()) &&
         !body_.loads().has_fluid() && target >= body_.state().load_factor;
}

void EventSources::grow_lines(pd::TipLaws laws, FactorsAround factors) {
  settle();
  lines_.emplace(body_, whole_body_, std::move(laws), std::move(factors));
  window_.grow_lines(lines_->steps());
}

void EventSources::freeze(const std::set<crack::TipId>& tips) {
  if (!lines_ || lines_->steps().frozen() == tips) return;
  if (window_.is_open()) settle();
  lines_->freeze(tips);
}

const Event* EventSources::next(double target, const SteppingOptions& options) {
  const bool possible = may_use_window(target, options);
  // The load factor at which a tip in boundary elements grows needs the displacements of the whole body, which are
  // therefore computed at each event of a window.
  const auto comes_first = [&](const Event* event) {
    const double present = body_.state().load_factor;
    return options.elements && event &&
           first_with(*options.elements, event, {present, target >= present, options.control}) != event;
  };
  if (window_.is_open() && !(possible && window_.suits(options))) settle();
  while (possible) {
    if (!window_.is_open()) open_window(target, options);
    if (!window_.is_open()) break;
    source_of_next_ = &window_;
    const Event* breaks = window_.next(target, options);
    const bool element_comes_first = comes_first(breaks);
    if (breaks && !element_comes_first) return breaks;
    if (window_.events_performed() >= (lines_ ? WindowSettings::worthwhile_steps : 1)) {
      patience_.note_useful();
      if (window_.needs_whole_body()) patience_.wait_for(1);
      if (window_.ended_at_faces()) patience_.wait_for(WindowSettings::events_beside_faces);
    } else {
      patience_.note_useless();
    }
    settle();
    if (element_comes_first) break;
  }
  EventSource& source = source_without_window();
  const Event* event = source.next(target, options);
  if (options.elements) {
    const double present = body_.state().load_factor;
    event = first_with(*options.elements, event, {present, target >= present, options.control});
  }
  return first_of(source, event, target);
}

// First of two events in the order of growth (crack/order.hpp): `event`, a break or a step of a crack line in lattices
// (null if there is none), and the next growth of a tip in boundary elements. Null if there is neither.
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

EventSource& EventSources::source_without_window() {
  if (lines_) return *lines_;
  return whole_body_;
}

// First event on the way to the target: `event`, which `source` has found, or crack faces that close or open before it.
const Event* EventSources::first_of(EventSource& source, const Event* event, double target) {
  const Event* contact = contact_.before(event, target);
  source_of_next_ = contact ? static_cast<EventSource*>(&contact_) : &source;
  return contact ? contact : event;
}

void EventSources::open_window(double target, const SteppingOptions& options) {
  if (body_.state().separated || patience_.waits()) return;
  const std::optional<double> next = next_in_window(target, options);
  if (!next || *next > target || contact_.is_before(*next)) return;
  Event breaks;
  breaks.load_factor = *next;
  const LoadWay way{body_.state().load_factor, true, options.control};
  if (options.elements && first_with(*options.elements, &breaks, way) != &breaks) return;
  if (!window_.open(*next, options)) patience_.note_useless();
}

// Load factor of the next event if a window could perform it; empty otherwise.
std::optional<double> EventSources::next_in_window(double target, const SteppingOptions& options) {
  if (!lines_) return body_.response().next_critical(body_.response().load_path_to(target, options.control));
  const Event* event = lines_->next(target, options);
  return event && lines_->is_step_of_tip() ? std::optional(event->load_factor) : std::nullopt;
}

Outcome EventSources::perform() {
  if (source_of_next_ == &source_without_window()) patience_.note_event();
  return source_of_next_->perform();
}

void EventSources::settle() {
  return_point_.keep();
  resumption_.close();
  window_.close();
}

void EventSources::forget() {
  resumption_.await_nothing();
  window_.forget();
  patience_ = {};
}

void EventSources::abandon() noexcept {
  window_.abandon();
  resumption_.await_nothing();
  is_stale_ = true;
}

void EventSources::refresh() {
  if (!is_stale_) return;
  window_.forget();
  patience_ = {};
  body_.restore();
  resumption_.recall();
  is_stale_ = false;
}

void EventSources::go_on() {
  try {
    if (resumption_.reopen()) return;
    abandon();
    refresh();
  } catch (...) {
    is_stale_ = true;
    throw;
  }
}

void EventSources::give_up_event(const BodyState& before) {
  return_point_.replace_place(before);
  abandon();
}

void EventSources::return_to_mark() noexcept {
  ReturnPoint::Back back = return_point_.go_back();
  if (back.is_in_window) return;
  abandon();
  if (back.continuation) resumption_.await(std::move(*back.continuation));
}

}  // namespace bempd::fracture
