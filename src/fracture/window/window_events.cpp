#include "fracture/window/window_events.hpp"

#include <algorithm>
#include <optional>

#include "error.hpp"
#include "stopwatch.hpp"

namespace bempd::fracture {

namespace {

// Stopwatch that adds the time of its scope to a sum of seconds, less the time that the system's own counters count in
// that scope.
class WindowWatch {
 public:
  WindowWatch(double& seconds, const coupling::SolverCounters& counters)
      : seconds_(seconds), counters_(counters), counted_(counted()) {
    watch_.emplace(elapsed_);
  }
  ~WindowWatch() {
    watch_.reset();
    seconds_ += elapsed_ - (counted() - counted_);
  }
  WindowWatch(const WindowWatch&) = delete;
  WindowWatch& operator=(const WindowWatch&) = delete;

 private:
  double counted() const {
    return counters_.seconds_assembly + counters_.seconds_factorization + counters_.seconds_solve +
           counters_.seconds_update;
  }

  double& seconds_;
  const coupling::SolverCounters& counters_;
  double counted_, elapsed_ = 0;
  std::optional<Stopwatch> watch_;
};

WindowOptions options_of(const SteppingOptions& options) {
  return {options.tie_band, options.max_breaks_per_solve, options.window_ahead, options.control};
}

}  // namespace

WindowEvents::WindowEvents(LoadedBody& body, std::function<void()> before_forgetting)
    : forecast_(body), body_(body), before_forgetting_(std::move(before_forgetting)) {}

bool WindowEvents::open(double load_factor, const SteppingOptions& options) {
  events_performed_ = 0;
  try {
    const WindowWatch watch(body_.response().seconds_search(), body_.system().counters());
    const int most_events = forecast_.most_events();
    const BodyState& state = body_.state();
    if (!forecast_.open(state, load_factor, options_of(options))) return false;
    origin_ = {forecast_.options(), state.load_factor, state.displacement, state.tips, state.faces, {}};
    faces_have_switched_ = false;
    most_events_at_first_ = most_events;
    return true;
  } catch (const Error& error) {
    // A fresh factorization may fail if the body is close to a mechanism (free motion). In that case no window is
    // opened, and the whole body finds the next break.
    if (error.failure() != Failure::unsolvable) throw;
    return false;
  }
}

bool WindowEvents::suits(const SteppingOptions& options) const { return forecast_.options() == options_of(options); }

WindowOrigin WindowEvents::origin() const {
  WindowOrigin origin = origin_;
  origin.events_performed = events_performed_;
  origin.is_out_of_date = is_out_of_date_ || is_updated_for_reader_;
  origin.has_changed_terms = forecast_.events().have_changed_terms();
  origin.needs_whole_body = forecast_.frees_a_motion();
  if (!faces_have_switched_) origin.faces.reset();
  return origin;
}

bool WindowEvents::open_again(const WindowOrigin& origin) {
  events_performed_ = 0;
  is_out_of_date_ = is_updated_for_reader_ = false;
  origin_ = origin;
  most_events_at_first_ = forecast_.most_events();
  BodyState& state = body_.state();
  origin_.faces = state.faces;
  faces_have_switched_ = false;
  forecast_.open_again(state, origin.options);
  for (const WindowOrigin::Computation& computation : origin.computations) {
    while (events_performed_ < computation.after)
      if (!take_again()) return false;
    if (!forecast_.must_compute()) return false;
    state.load_factor = computation.load_factor;
    state.largest_force = computation.largest_force;
    forecast_.compute(state);
  }
  while (events_performed_ < origin.events_performed)
    if (!take_again()) return false;
  is_updated_for_reader_ = origin.is_out_of_date;
  return true;
}

bool WindowEvents::take_again() {
  const ForecastEvent* foreseen = forecast_.events().next();
  if (!foreseen) return false;
  take(*foreseen);
  return true;
}

void WindowEvents::take(const ForecastEvent& next) {
  BodyState& state = body_.state();
  const std::vector<coupling::StageChange>& changes = next.event.changes;
  for (const coupling::StageChange& c : changes) state.stages[c.term] = static_cast<std::uint8_t>(c.stage);
  const std::vector<int> broken = body_.system().terms().broken_by(changes);
  if (!state.tips.empty()) state.tips = next.tips;
  forecast_.events().take();
  if (next.faces) {
    take_faces(*next.faces);
  } else {
    body_.faces().note_broken(broken, state.faces);
  }
  ++events_performed_;
}

void WindowEvents::close() {
  bring_up_to_date();
  forecast_.close();
}

void WindowEvents::forget() {
  forecast_.forget();
  is_out_of_date_ = is_updated_for_reader_ = false;
}

void WindowEvents::abandon() noexcept {
  forecast_.close();
  is_out_of_date_ = is_updated_for_reader_ = false;
}

const Event* WindowEvents::next(double, const SteppingOptions&) {
  const WindowWatch watch(body_.response().seconds_search(), body_.system().counters());
  if (forecast_.must_compute()) {
    before_forgetting_();
    // The next events are computed from this state, whose displacements from then on have other rounding errors than
    // those that were brought up to date for a reader.
    is_out_of_date_ = is_out_of_date_ || is_updated_for_reader_;
    is_updated_for_reader_ = false;
    const BodyState& state = body_.state();
    origin_.computations.push_back({events_performed_, state.load_factor, state.largest_force});
    forecast_.compute(state);
  }
  const ForecastEvent* foreseen = forecast_.events().next();
  return foreseen ? &foreseen->event : nullptr;
}

Outcome WindowEvents::perform() {
  const ForecastEvent& foreseen = *forecast_.events().next();
  if (foreseen.faces) before_forgetting_();  // earlier positions have another contact state
  const Event& event = foreseen.event;
  BodyState& state = body_.state();
  Outcome outcome = foreseen.outcome;
  outcome.work_before = foreseen.before.at(event.load_factor) - foreseen.before.at(state.load_factor);
  outcome.residual = forecast_.residual();
  state.load_factor = event.load_factor;
  state.largest_force = std::max(state.largest_force, foreseen.largest_force);
  take(foreseen);
  is_out_of_date_ = true;
  is_updated_for_reader_ = false;
  return outcome;
}

void WindowEvents::take_faces(FaceState faces) {
  faces_have_switched_ = true;
  body_.faces().go_on_from(faces);
  body_.state().faces = std::move(faces);
}

void WindowEvents::bring_up_to_date() {
  update_for_reader();
  is_updated_for_reader_ = false;
}

void WindowEvents::update_for_reader() {
  if (!is_out_of_date_) return;
  body_.response().set_solution(forecast_.displacement(forecast_.events().position()));
  is_out_of_date_ = false;
  is_updated_for_reader_ = true;
}

WindowEvents::Place WindowEvents::place() const {
  const BodyState& state = body_.state();
  return {forecast_.events().position(), events_performed_, state.load_factor,
          state.largest_force,           state.separated,   state.tips,
          state.faces.pending.size()};
}

BodyState WindowEvents::state_at(const Place& place) const {
  const BodyState& present = body_.state();
  BodyState state;
  state.load_factor = place.load_factor;
  state.in_equilibrium = present.in_equilibrium;
  state.separated = place.separated;
  state.first_unit_energy = present.first_unit_energy;
  state.largest_force = place.largest_force;
  state.displacement = forecast_.displacement(place.position);
  state.total_displacement = coupling::evaluate(state.displacement, state.load_factor);
  state.total_force = body_.system().response().internal_force(state.total_displacement, state.load_factor);
  state.stages = forecast_.events().stages(place.position);
  state.springs = present.springs;
  state.unloaded = present.unloaded;
  state.faces = present.faces;
  state.faces.pending.resize(place.pending_faces);
  state.tips = place.tips;
  return state;
}

void WindowEvents::return_to(Place& place) noexcept {
  forecast_.events().return_to(place.position);
  BodyState& state = body_.state();
  state.load_factor = place.load_factor;
  state.largest_force = place.largest_force;
  state.separated = place.separated;
  state.tips.swap(place.tips);
  body_.faces().keep_first_pending(place.pending_faces, state.faces);
  state.stages = body_.system().stages().numbers();
  events_performed_ = place.events_performed;
  is_out_of_date_ = true;
  is_updated_for_reader_ = false;
}

}  // namespace bempd::fracture
