#include "paper/volume_damage.hpp"

#include <cassert>

#include "pd/micromodulus.hpp"

namespace bempd::paper {

std::vector<double> volume_damage(const pd::Network& network, const std::vector<double>& volumes, int horizon_ratio,
                                  const std::vector<std::uint8_t>& broken) {
  assert(broken.empty() || broken.size() == network.bonds.size());
  std::vector<double> whole(volumes.size(), 0), lost(volumes.size(), 0);
  for (std::size_t b = 0; b < network.bonds.size(); ++b) {
    const pd::Bond& bond = network.bonds[b];
    const double factor = pd::volume_factor(network.offsets[network.offset_of[b]].length, horizon_ratio);
    whole[bond.first] += factor * volumes[bond.second];
    whole[bond.second] += factor * volumes[bond.first];
    if (broken.empty() || !broken[b]) continue;
    lost[bond.first] += factor * volumes[bond.second];
    lost[bond.second] += factor * volumes[bond.first];
  }
  for (std::size_t i = 0; i < lost.size(); ++i) lost[i] = whole[i] > 0 ? lost[i] / whole[i] : 0;
  return lost;
}

}  // namespace bempd::paper
