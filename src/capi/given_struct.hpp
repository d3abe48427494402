#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "capi/guard.hpp"

namespace bempd::capi {

// Copy of a caller's struct: members beyond the caller's size have their defaults. A longer struct of a newer program
// must have zeros beyond the known members.
template <class T>
T given_struct(const T* from, const char* name, const T& defaults, std::size_t least = sizeof(std::int64_t)) {
  const std::size_t size = struct_bytes(from, name, least);
  T values = defaults;
  std::memcpy(&values, from, std::min(size, sizeof values));
  const auto* bytes = reinterpret_cast<const unsigned char*>(from);
  require(size <= sizeof values ||
              std::all_of(bytes + sizeof values, bytes + size, [](unsigned char byte) { return byte == 0; }),
          name, " was filled by a program made for a newer bempd, with members this version does not know");
  return values;
}

inline void require_at_least(double value, double least, const char* name) {
  require(std::isfinite(value) && value >= least, name, " is ", value, "; it must be a finite number >= ", least);
}

}  // namespace bempd::capi
