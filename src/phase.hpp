#pragma once

#include <algorithm>
#include <chrono>

namespace bempd {

// Listener that is told how far a long part of a call is; an exception that it throws ends the call.
class PhaseListener {
 public:
  virtual ~PhaseListener() = default;
  virtual void hear(const char* phase, double share, double seconds) = 0;
};

// Scope of a call, in its thread: threads that work for the call report nothing.
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

// Long part of a call, with its total amount of work.
class Phase {
 public:
  explicit Phase(const char* name, double work = 1) : name_(name), work_(work) { reach(0); }

  void reach(double done) const {
    PhaseListener* const listener = ListeningScope::current();
    if (!listener) return;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    listener->hear(name_, work_ > 0 ? std::clamp(done / work_, 0.0, 1.0) : 1.0, seconds);
  }

 private:
  const char* name_;
  double work_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace bempd
