#pragma once

#include <sstream>
#include <stdexcept>
#include <string>

namespace bempd {

// Kind of a failure, by what the caller can do about it.
enum class Failure { argument, order, unsolvable, convergence, cancelled, io };

class Error : public std::runtime_error {
 public:
  Error(Failure failure, const std::string& message) : std::runtime_error(message), failure_(failure) {}
  Failure failure() const { return failure_; }

 private:
  Failure failure_;
};

// Joins `parts` to one text; numbers get up to 10 significant digits.
template <class... Parts>
std::string text(const Parts&... parts) {
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream.precision(10);
  (stream << ... << parts);
  return stream.str();
}

template <class... Parts>
[[noreturn]] void fail(Failure failure, const Parts&... parts) {
  throw Error(failure, text(parts...));
}

template <class... Parts>
void require(bool condition, const Parts&... parts) {
  if (!condition) throw Error(Failure::argument, text(parts...));
}

}  // namespace bempd
