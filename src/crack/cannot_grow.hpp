#pragma once

#include <string>

#include "error.hpp"

namespace bempd::crack {

// Error of a carrier (carrier.hpp) that cannot let a crack grow to a place because no valid scene contains the longer
// crack; `reason` says why. During a step the crack stops instead; bempd_grow_cracks() returns the error to the host.
class CannotGrow : public Error {
 public:
  explicit CannotGrow(const std::string& reason) : Error(Failure::argument, reason) {}
};

// What a host reads that asks cracks to grow where no tip is free to.
inline constexpr const char* no_free_tip =
    "all tips have ended, have stopped before an interface, or are frozen; let a frozen one grow again with "
    "bempd_set_tip_frozen()";

// Failure of a carrier whose longer crack frees a part that loads push away and cannot be taken off: no equilibrium is
// left. In a step the body is separated, and the run ends just before; bempd_grow_cracks() hands the error to the host.
class FreesLoadedPart : public Error {
 public:
  explicit FreesLoadedPart(const std::string& reason) : Error(Failure::unsolvable, reason) {}
};

}  // namespace bempd::crack
