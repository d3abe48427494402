#pragma once

#include "regions/scheme.hpp"

namespace bempd::regions {

// Scheme with symmetric Galerkin boundary elements and lattices that reproduce linear fields: the kinds of regions
// without changes.
std::unique_ptr<Scheme> make_symmetric_scheme();

}  // namespace bempd::regions
