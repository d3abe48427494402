#pragma once

#include "regions/scheme.hpp"

namespace bempd::regions {

// Creates the symmetric scheme: symmetric Galerkin boundary elements, and lattices whose bonds reproduce linear fields
// exactly.
std::unique_ptr<Scheme> make_symmetric_scheme();

}  // namespace bempd::regions
