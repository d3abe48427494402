#pragma once

#include <cfenv>

namespace bempd::test {

// While it lives, invalid operations, divisions by zero and overflows end the program, as hosts that look for their own
// mistakes have it.
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
