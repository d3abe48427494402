#pragma once

#include "regions/scheme.hpp"

namespace bempd::regions {

// The scheme of Yang and Liu, Int. J. Solids Struct. 2021: collocation, uncorrected bonds, coupling by shared nodes.
std::unique_ptr<Scheme> make_paper_scheme(const scene::Options& options);

}  // namespace bempd::regions
