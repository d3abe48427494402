#pragma once

#include <atomic>

#include "error.hpp"

namespace bempd {

// Thrown inside an event when the host wishes to end the step. The event is undone, and the step ends in the state
// before the event. EventGivenUp is no error. It ends in the loop over events or in the step, which have permitted it;
// code between must throw it on.
struct EventGivenUp {};

// Scope in which check_cancelled() reads the host's requests, in the same thread. Long loops call check_cancelled()
// often: a call costs four loads.
class CancellationScope {
 public:
  using Request = std::atomic<bool>;
  struct Requests {
    const Request* cancel = nullptr;  // request to cancel the call; null: none
    const Request* stop = nullptr;    // request to end the step inside an event; null: not possible here
  };

  explicit CancellationScope(const Requests& requests) : before_(current()) { current() = requests; }
  explicit CancellationScope(const Request* cancel) : CancellationScope(Requests{cancel, nullptr}) {}
  ~CancellationScope() { current() = before_; }
  CancellationScope(const CancellationScope&) = delete;
  CancellationScope& operator=(const CancellationScope&) = delete;

  static Requests& current() {
    thread_local Requests requests;
    return requests;
  }

 private:
  Requests before_;
};

// Throws Error (cancelled) if the host has requested that the present call be cancelled, and EventGivenUp if the host
// has requested the end of a step that may be ended inside an event.
inline void check_cancelled() {
  const CancellationScope::Requests& requests = CancellationScope::current();
  if (requests.cancel && requests.cancel->load(std::memory_order_relaxed))
    fail(Failure::cancelled, "cancelled on request; the model is as it was before the call");
  if (requests.stop && requests.stop->load(std::memory_order_relaxed)) throw EventGivenUp();
}

}  // namespace bempd
