#pragma once

#include <cfenv>

namespace bempd::test {

// Scope in which invalid operations, divisions by zero and overflows end the program, as in hosts that look for errors
// of their own.
class FloatingPointTraps {
 public:
  FloatingPointTraps() {
    std::feclearexcept(FE_ALL_EXCEPT);
    before_ = feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
  }
  ~FloatingPointTraps() {
    fedisableexcept(FE_ALL_EXCEPT);
    std::feclearexcept(FE_ALL_EXCEPT);
    feenableexcept(before_);
  }
  FloatingPointTraps(const FloatingPointTraps&) = delete;
  FloatingPointTraps& operator=(const FloatingPointTraps&) = delete;

 private:
  int before_;
};

}  // namespace bempd::test
