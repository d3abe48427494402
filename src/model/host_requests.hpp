#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <utility>

#include "cancellation.hpp"
#include "fracture/evolution_state.hpp"
#include "model/host_listener.hpp"

namespace bempd::model {

// Requests of a host to a running call (cancel, stop), and the functions of the host that a call reports to.
class HostRequests {
 public:
  using Progress = std::function<bool(double load_factor, std::int64_t events, std::int64_t broken_bonds)>;
  using Log = HostListener::Log;

  void set_progress(Progress progress) { progress_ = std::move(progress); }
  void set_log(Log log) {
    phases_.write(log);
    log_ = std::move(log);
  }
  void set_phase_progress(HostListener::Function function) { phases_.tell(std::move(function)); }
  const Log& log() const { return log_; }
  // Functions for progress and log, also for the log of phases. While they are exchanged for empty functions, a call
  // reports nothing but its phases to the host's phase function.
  struct Listeners {
    Progress progress;
    Log log, log_of_phases;
  };
  Listeners exchange(Listeners next) noexcept {
    return {std::exchange(progress_, std::move(next.progress)), std::exchange(log_, std::move(next.log)),
            phases_.exchange_log(std::move(next.log_of_phases))};
  }
  PhaseListener* phase_listener() { return phases_.or_null(); }
  // Calls the host's progress function; returns false if the function asks to stop.
  bool goes_on(const fracture::EvolutionState& state) const {
    return !progress_ || progress_(state.load_factor, state.events, state.broken_bonds);
  }

  void request_cancel() { cancel_ = true; }
  void request_stop() { stop_ = true; }
  bool cancel_requested() const { return cancel_; }
  bool stop_requested() const { return stop_; }
  const std::atomic<bool>* stop_request() const { return &stop_; }
  // Begins a call: forgets earlier requests to cancel or stop. While the returned scope exists, the call can be
  // cancelled.
  [[nodiscard]] CancellationScope hear() {
    cancel_ = stop_ = false;
    return CancellationScope(&cancel_);
  }

 private:
  Progress progress_;
  Log log_;
  HostListener phases_;
  std::atomic<bool> cancel_{false}, stop_{false};
};

}  // namespace bempd::model
