#pragma once

#include <chrono>
#include <functional>
#include <utility>

#include "error.hpp"
#include "phase.hpp"

namespace bempd::model {

// Reports to a host how far a long part of a call is, ten times a second at most.
class HostListener final : public PhaseListener {
 public:
  // Host's function, with the seconds that the part has taken and those that it is expected to take in all, 0 if
  // nothing is known; it returns false to cancel the call.
  using Function = std::function<bool(const char* phase, double share, double seconds, double expected)>;

  HostListener() = default;
  explicit HostListener(Function function) : function_(std::move(function)) {}

  // The listener, or null if the host does not listen.
  PhaseListener* or_null() { return function_ ? this : nullptr; }

  void hear(const char* phase, double share, double seconds) override {
    const auto now = std::chrono::steady_clock::now();
    if (now - told_ < std::chrono::milliseconds(100)) return;
    told_ = now;
    if (!function_(phase, share, seconds, share > 0 ? seconds / share : 0))
      fail(Failure::cancelled, "the phase callback asked to stop; the model is as it was before the call");
  }

 private:
  Function function_;
  std::chrono::steady_clock::time_point told_;
};

}  // namespace bempd::model
