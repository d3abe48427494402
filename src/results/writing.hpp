#pragma once

#include <system_error>

#include "error.hpp"

namespace bempd::results {

// Files are the host's business: its reason and the path, as an error the host can act on.
template <class Body>
void writing(const Body& body) {
  try {
    body();
  } catch (const std::system_error& e) {
    fail(Failure::io, e.what(), "; check that the folder exists and can be written to");
  }
}

}  // namespace bempd::results
