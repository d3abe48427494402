#include "geometry/halving.hpp"

#include <cstddef>
#include <utility>

namespace bempd {

std::vector<double> halved(std::vector<double> stations, int halvings) {
  for (; halvings > 0; --halvings) {
    std::vector<double> finer{stations.front()};
    for (std::size_t i = 1; i < stations.size(); ++i)
      finer.insert(finer.end(), {0.5 * (stations[i - 1] + stations[i]), stations[i]});
    stations = std::move(finer);
  }
  for (; halvings < 0; ++halvings) {
    std::vector<double> coarser;
    for (std::size_t i = 0; i + 1 < stations.size(); i += 2) coarser.push_back(stations[i]);
    coarser.push_back(stations.back());
    stations = std::move(coarser);
  }
  return stations;
}

}  // namespace bempd
