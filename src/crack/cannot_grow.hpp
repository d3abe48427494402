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

}  // namespace bempd::crack
