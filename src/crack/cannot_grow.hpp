#pragma once

#include <string>

#include "error.hpp"

namespace bempd::crack {

// Error of a carrier (part of the model in which cracks grow, carrier.hpp): a crack cannot grow to a place, because no
// valid scene contains the longer crack; `reason` says why. In a step the crack stops instead; bempd_grow_cracks()
// returns the error to the host.
class CannotGrow : public Error {
 public:
  explicit CannotGrow(const std::string& reason) : Error(Failure::argument, reason) {}
};

// Message of the error that a host gets when it asks cracks to grow although no tip may grow.
inline constexpr const char* no_free_tip =
    "all tips have ended, have stopped before an interface, or are frozen; let a frozen one grow again with "
    "bempd_set_tip_frozen()";

// Error: the longer crack frees a part of the body that loads push away and that cannot be removed, so that there is no
// equilibrium. In a step the body is separated, and the run ends just before this growth; bempd_grow_cracks() returns
// the error to the host.
class FreesLoadedPart : public Error {
 public:
  explicit FreesLoadedPart(const std::string& reason) : Error(Failure::unsolvable, reason) {}
};

}  // namespace bempd::crack
