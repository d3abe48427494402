#pragma once

#include <system_error>

#include "error.hpp"

namespace bempd::results {

// Runs `body`, which writes files, and turns its std::system_error into Error (io) for the host, with path and reason.
template <class Body>
void writing(const Body& body) {
  try {
    body();
  } catch (const std::system_error& e) {
    fail(Failure::io, e.what(), "; check that the folder exists and can be written to");
  }
}

}  // namespace bempd::results
