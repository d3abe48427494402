#pragma once

#include <string>

#include "error.hpp"

namespace bempd::crack {

// Failure of a carrier that cannot have the crack where it is to grow to, with the reason: no scene with the longer
// crack can be made. In a step the crack stops; bempd_grow_cracks() hands the error to the host.
class CannotGrow : public Error {
 public:
  explicit CannotGrow(const std::string& reason) : Error(Failure::argument, reason) {}
};

}  // namespace bempd::crack
