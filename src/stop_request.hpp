#pragma once

#include <atomic>

namespace bempd {

// Scope in which stop_is_requested() reads `request`, in the same thread: the host's wish to end the step after its
// present event (null: none).
class StopScope {
 public:
  using Request = std::atomic<bool>;

  explicit StopScope(const Request* request) : before_(current()) { current() = request; }
  ~StopScope() { current() = before_; }
  StopScope(const StopScope&) = delete;
  StopScope& operator=(const StopScope&) = delete;

  static const Request*& current() {
    thread_local const Request* request = nullptr;
    return request;
  }

 private:
  const Request* before_;
};

// Whether the host has asked for the end of the step after the present event. Work for later events is then useless.
inline bool stop_is_requested() {
  const StopScope::Request* request = StopScope::current();
  return request && request->load(std::memory_order_relaxed);
}

}  // namespace bempd
