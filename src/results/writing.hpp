#pragma once

#include <system_error>

#include "error.hpp"

namespace bempd::results {

// Runs `body` and turns failures to write files into errors for the host, with the reason and the path.
template <class Body>
void writing(const Body& body) {
  try {
    body();
  } catch (const std::system_error& e) {
    fail(Failure::io, e.what(), "; check that the folder exists and can be written to");
  }
}

}  // namespace bempd::results
