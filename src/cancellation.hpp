#pragma once

#include <atomic>

#include "error.hpp"

namespace bempd {

// Thrown where the host's wish to end a step is heard inside an event: the event is given up, and the step ends as it
// was before it. It is no error, and only what let it be thrown may catch it: the loop over events, or the whole step.
struct EventGivenUp {};

// Scope in which check_cancelled() of the same thread reads the host's requests. Long loops call check_cancelled()
// often: it costs four loads.
class CancellationScope {
 public:
  using Request = std::atomic<bool>;
  struct Requests {
    const Request* cancel = nullptr;  // the call; null: none
    const Request* stop = nullptr;    // the step, while it can be ended inside an event; null: none
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

// Throws Error (cancelled) if the host has requested that the present call be cancelled, and EventGivenUp if it has
// requested the end of a step that can be ended here.
inline void check_cancelled() {
  const CancellationScope::Requests& requests = CancellationScope::current();
  if (requests.cancel && requests.cancel->load(std::memory_order_relaxed))
    fail(Failure::cancelled, "cancelled on request; the model is as it was before the call");
  if (requests.stop && requests.stop->load(std::memory_order_relaxed)) throw EventGivenUp();
}

}  // namespace bempd
