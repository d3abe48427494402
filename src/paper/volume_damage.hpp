#pragma once

#include <cstdint>
#include <vector>

#include "pd/network.hpp"

namespace bempd::paper {

// Local damage of every material point (Yang and Liu 2021, Eq. 16): the part of the volume within its horizon that its
// broken bonds led to, 1 - sum mu v V / sum v V over its bonds, where v is the volume factor of Eq. 19 and V the far
// point's entry of `volumes`. `broken` holds one entry a bond (nonzero: broken) or is empty. A bond exactly as long as
// the horizon has no stiffness, is not stored, and does not count; a point without bonds is undamaged.
std::vector<double> volume_damage(const pd::Network& network, const std::vector<double>& volumes, int horizon_ratio,
                                  const std::vector<std::uint8_t>& broken);

}  // namespace bempd::paper
