#pragma once

#include <atomic>

#include "error.hpp"

namespace bempd {

// Scope of a call in which a host's request to cancel is heard: long loops poll it through check_cancelled(), which
// costs two loads. Each thread knows the request of the call that it works for.
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

// Throws Error (cancelled) if the host has asked for it.
inline void check_cancelled() {
  const CancellationScope::Request* request = CancellationScope::current();
  if (request && request->load(std::memory_order_relaxed))
    fail(Failure::cancelled, "cancelled on request; the model is as it was before the call");
}

}  // namespace bempd
