#pragma once

#include <cstdint>
#include <vector>

#include "pd/network.hpp"

namespace bempd::paper {

// Local damage of every material point (Yang and Liu 2021, Eq. 16): the share of the volume within its horizon to which
// its broken bonds led, 1 - sum mu v V / sum v V over its bonds. v is the volume factor of Eq. 19, V the entry of
// `volumes` for the far point, and mu is 0 for broken and 1 for other bonds. `broken` has one entry per bond (nonzero:
// broken) or is empty. Bonds as long as the horizon have no stiffness, are not stored and do not count. A point without
// bonds is undamaged.
std::vector<double> volume_damage(const pd::Network& network, const std::vector<double>& volumes, int horizon_ratio,
                                  const std::vector<std::uint8_t>& broken);

}  // namespace bempd::paper
