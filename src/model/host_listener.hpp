#pragma once

#include <chrono>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "error.hpp"
#include "phase.hpp"

namespace bempd::model {

// Reports the progress of long phases of a call to the host, at most ten times a second. The beginning of a phase with
// an estimated time is always reported, and written to the log if the estimate is at least a second.
class HostListener final : public PhaseListener {
 public:
  // Progress function of the host. It receives the phase, the share of it that is done, the seconds so far and the
  // expected total (0 if unknown), and returns false to cancel the call.
  using Function = std::function<bool(const char* phase, double share, double seconds, double expected)>;

  // Function of the host's log, which receives the level of a message (1 warning, 2 information, 3 detail) and its
  // text.
  using Log = std::function<void(int level, const std::string& message)>;

  void tell(Function function) { function_ = std::move(function); }
  void write(Log log) { log_ = std::move(log); }
  Log exchange_log(Log log) noexcept { return std::exchange(log_, std::move(log)); }

  // Returns this listener, or null if the host has given no function.
  PhaseListener* or_null() { return function_ || log_ ? this : nullptr; }

  void hear(const char* phase, double share, double seconds, double expected) override {
    const bool begins = share == 0 && expected > 0;
    if (begins && log_ && expected >= worth_a_line) log_(2, std::string(phase) + ": some " + rounded(expected) + " s");
    const auto now = std::chrono::steady_clock::now();
    if (!function_ || (!begins && now - told_ < std::chrono::milliseconds(100))) return;
    told_ = now;
    if (!function_(phase, share, seconds, expected))
      fail(Failure::cancelled, "the phase callback asked to stop; the model is as it was before the call");
  }

 private:
  static constexpr double worth_a_line = 1;  // seconds

  static std::string rounded(double seconds) { return std::to_string(std::lround(seconds)); }

  Function function_;
  Log log_;
  std::chrono::steady_clock::time_point told_;
};

}  // namespace bempd::model
