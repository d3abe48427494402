#include "results/picture_arrays.hpp"

#include <algorithm>
#include <cmath>

namespace bempd::results {

void append(std::vector<output::VtuArray>& arrays, const std::string& name, int components,
            const std::vector<double>& values) {
  auto found = std::find_if(arrays.begin(), arrays.end(), [&](const output::VtuArray& a) { return a.name == name; });
  if (found == arrays.end()) found = arrays.insert(arrays.end(), {name, components, std::vector<double>()});
  auto& all = std::get<std::vector<double>>(found->values);
  all.insert(all.end(), values.begin(), values.end());
}

void append_stress(std::vector<output::VtuArray>& arrays, const PlaneElasticity& elasticity,
                   const std::vector<double>& values) {
  std::vector<double> tensors, largest, smallest;
  const double across = elasticity.state == PlaneState::strain ? elasticity.poisson_ratio : 0;
  for (std::size_t i = 0; i < values.size(); i += 3) {
    const double xx = values[i], yy = values[i + 1], xy = values[i + 2];
    tensors.insert(tensors.end(), {xx, xy, 0, xy, yy, 0, 0, 0, across * (xx + yy)});
    const double mean = 0.5 * (xx + yy), radius = std::hypot(0.5 * (xx - yy), xy);
    largest.push_back(mean + radius);
    smallest.push_back(mean - radius);
  }
  append(arrays, "stress", 9, tensors);
  append(arrays, "principal_stress_1", 1, largest);
  append(arrays, "principal_stress_2", 1, smallest);
}

}  // namespace bempd::results
