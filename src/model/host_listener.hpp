#pragma once

#include <chrono>
#include <functional>
#include <utility>

#include "error.hpp"
#include "phase.hpp"

namespace bempd::model {

// Reports the progress of long phases of a call to the host, at most ten times a second.
class HostListener final : public PhaseListener {
 public:
  // Function of the host. It receives the phase, the share done, the seconds so far and the expected total (0 if
  // unknown), and returns false to cancel the call.
  using Function = std::function<bool(const char* phase, double share, double seconds, double expected)>;

  HostListener() = default;
  explicit HostListener(Function function) : function_(std::move(function)) {}

  // Returns this listener, or null if the host has given no function.
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
