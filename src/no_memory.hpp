#pragma once

#include <new>

namespace bempd {

// Memory is missing for something that the message names, which has to be a literal: it takes no memory.
class NoMemory : public std::bad_alloc {
 public:
  explicit NoMemory(const char* message) : message_(message) {}
  const char* what() const noexcept override { return message_; }

 private:
  const char* message_;
};

}  // namespace bempd
