#pragma once

#include <atomic>

#include "error.hpp"

namespace bempd {

// Scope in which check_cancelled() of the same thread reads `request`, the host's wish to cancel the call (null: none).
// Long loops call check_cancelled() often: it costs two loads.
class CancellationScope {
 public:
  using Request = std::atomic<bool>;

  explicit CancellationScope(const Request* request) : before_(current()) { current() = request; }
  ~CancellationScope() { current() = before_; }
  CancellationScope(const CancellationScope&) = delete;
  CancellationScope& operator=(const CancellationScope&) = delete;

  static const Request*& current() {
    thread_local const Request* request = nullptr;
    return request;
  }

 private:
  const Request* before_;
};

// Throws Error (cancelled) if the host has requested that the present call be cancelled.
inline void check_cancelled() {
  const CancellationScope::Request* request = CancellationScope::current();
  if (request && request->load(std::memory_order_relaxed))
    fail(Failure::cancelled, "cancelled on request; the model is as it was before the call");
}

}  // namespace bempd
