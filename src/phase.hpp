#pragma once

#include <algorithm>
#include <chrono>

namespace bempd {

// Receiver of progress reports. hear() gets the name of the running phase of a call, the share of the phase that is
// done (0 to 1), the seconds since the phase began, and the expected seconds of the whole phase (0: not known). An
// exception that hear() throws ends the call.
class PhaseListener {
 public:
  virtual ~PhaseListener() = default;
  virtual void hear(const char* phase, double share, double seconds, double expected) = 0;
};

// Scope in which phases report to `listener` (null: to nobody), in the same thread. Worker threads that a call starts
// report nothing.
class ListeningScope {
 public:
  explicit ListeningScope(PhaseListener* listener) : before_(current()) { current() = listener; }
  ~ListeningScope() { current() = before_; }
  ListeningScope(const ListeningScope&) = delete;
  ListeningScope& operator=(const ListeningScope&) = delete;

  static PhaseListener*& current() {
    thread_local PhaseListener* listener = nullptr;
    return listener;
  }

 private:
  PhaseListener* before_;
};

// Phase of a call that may take long. `work` is the whole amount of work, in any unit; reach() reports how much is
// done. `estimate` is the expected number of seconds of the phase, if that is known before it begins.
class Phase {
 public:
  explicit Phase(const char* name, double work = 1, double estimate = 0)
      : name_(name), work_(work), estimate_(estimate) {
    tell(0);
  }

  // Whether somebody listens to phases, so that an estimate is worth its cost.
  static bool is_heard() { return ListeningScope::current() != nullptr; }

  void reach(double done) const {
    if (done > 0) tell(done);
  }

 private:
  void tell(double done) const {
    PhaseListener* const listener = ListeningScope::current();
    if (!listener) return;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    const double share = work_ > 0 ? std::clamp(done / work_, 0.0, 1.0) : 1.0;
    listener->hear(name_, share, seconds, share > 0 ? seconds / share : estimate_);
  }

  const char* name_;
  double work_, estimate_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace bempd
