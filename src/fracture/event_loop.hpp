#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>

#include "fracture/body_carrier.hpp"
#include "fracture/crack_evolution.hpp"

namespace bempd::fracture {

// Detects the end of an equilibrium path at contact events (crack faces that open or close), where the load factor on
// the path may change its direction. A path that reverses twice at one load factor cannot continue: with the contact
// state of higher load factors the path leads down, with that of lower load factors it leads up.
class PathReversals {
 public:
  // Records a contact event; returns false if the path ends there.
  bool pass(const Event& event);

 private:
  double load_factor_ = std::numeric_limits<double>::quiet_NaN();
  bool down_ = false;
  int reversals_ = 0, events_ = 0;
};

// Loop of one run over its events: the loop performs the first event on the way to the target, then looks for the next
// one. An event is a step of a crack's tip, which its carrier advances (crack/carrier.hpp); or bonds that break by
// themselves; or crack faces that close or open. A step of a crack in boundary elements makes another body with the
// longer crack, in which the loop continues.
class EventLoop {
 public:
  using OnEvent = std::function<void(const EvolutionState&)>;
  using OnEnd = std::function<void()>;

  EventLoop(CrackEvolution& body, double target, Goal goal, const SteppingOptions& options, const OnEvent& on_event,
            const OnEnd& on_end)
      : body_(&body),
        bodies_before_(options.elements ? options.elements->bodies_before() : 0),
        target_(target),
        goal_(goal),
        options_(options),
        on_event_(on_event),
        on_end_(on_end) {}

  // Runs to the target or goal. If the run fails, or if the host asks for the end before the first equilibrium is found
  // (EventGivenUp is thrown), the body with which the run began is as it was before.
  StopReason run();

 private:
  StopReason go_on();
  std::optional<StopReason> perform(const Event& event);
  std::optional<StopReason> advance(crack::Carrier& carrier, const Event& event);
  std::optional<StopReason> after_event(bool crack_has_stopped, const std::vector<coupling::StageChange>& broken);
  StopReason separated_before_growth();
  std::optional<StopReason> reason_without_event();
  bool has_come_apart(const Event* next);
  StopReason end_with(StopReason reason);
  void follow_body();
  template <class Work>
  bool done_unless_stopped(const Work& work);
  void time_event();

  CrackEvolution* body_;   // body in which the run is at present
  int bodies_before_;      // number of that body, as BodyCarrier counts them
  bool has_begun_ = true;  // whether RunEvents::begin() was called in this body
  double target_;
  Goal goal_;
  const SteppingOptions& options_;
  const OnEvent& on_event_;
  const OnEnd& on_end_;
  std::int64_t events_before_ = 0;
  // Body before the next event, to return to if the event is given up. It is kept only if the last event took long or
  // none has been timed yet, and not while events come from a window.
  std::optional<RunEvents::Before> before_event_;
  std::chrono::steady_clock::time_point last_event_;
  bool events_are_long_ = true;
  PathReversals reversals_;
};

}  // namespace bempd::fracture
