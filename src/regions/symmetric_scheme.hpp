#pragma once

#include "regions/scheme.hpp"

namespace bempd::regions {

// Symmetric Galerkin boundary elements and lattices that reproduce linear fields: what the kinds are by themselves.
std::unique_ptr<Scheme> make_symmetric_scheme();

}  // namespace bempd::regions
