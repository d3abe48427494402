#pragma once

#include <new>

namespace bempd {

// Exception for a failed allocation. `message` names what the memory was for; it must be a literal, because a copy of
// it would need memory.
class NoMemory : public std::bad_alloc {
 public:
  explicit NoMemory(const char* message) : message_(message) {}
  const char* what() const noexcept override { return message_; }

 private:
  const char* message_;
};

}  // namespace bempd
