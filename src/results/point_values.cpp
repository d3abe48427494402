#include "results/point_values.hpp"

#include <map>

#include "error.hpp"

namespace bempd::results {

namespace {

// On an interface the region comes first whose values are at hand, then the lower number; 0 outside the body.
int region_at(const scene::Scene& scene, const regions::Discretization& d, const Point& place) {
  const regions::Region* found = nullptr;
  for (const auto& region : d.regions) {
    if (found && region->rank_at_interfaces() <= found->rank_at_interfaces()) continue;
    if (locate(scene.region(region->id()).outline(), place, d.tolerance) != Location::outside) found = region.get();
  }
  return found ? found->id() : 0;
}

}  // namespace

PointValues evaluate(const scene::Scene& scene, const regions::Discretization& d, const regions::Solution& solution,
                     const FieldsOfScene& fields, const std::vector<Point>& places, bool with_stress) {
  PointValues result;
  std::map<int, std::unique_ptr<regions::Evaluator>> evaluators;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Point& place = places[i];
    require(place.allFinite(), "point ", i, " is (", place.x(), ", ", place.y(),
            "); coordinates must be finite numbers");
    const int region = region_at(scene, d, place);
    require(region > 0, "point ", i, ", (", place.x(), ", ", place.y(), "), lies outside the body");
    std::unique_ptr<regions::Evaluator>& evaluator = evaluators[region];
    if (!evaluator) {
      const auto of_region = [&fields, region](regions::Field field) -> const regions::FieldValues& {
        return fields(region, field);
      };
      evaluator = d.region(region).evaluator(solution, of_region, with_stress);
    }
    result.values.push_back(evaluator->at(place));
  }
  for (const auto& [region, evaluator] : evaluators) result.kernel_evaluations += evaluator->kernel_evaluations();
  return result;
}

}  // namespace bempd::results
