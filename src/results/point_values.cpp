#include "results/point_values.hpp"

#include <map>

#include "cancellation.hpp"
#include "error.hpp"

namespace bempd::results {

namespace {

// Id of the region at a place; 0 outside the body. On an interface the region with the highest rank counts (lattices
// come before boundary elements); of equal ranks, the region with the lower id.
int region_at(const scene::Scene& scene, const regions::Discretization& d, const Point& place) {
  const regions::Region* found = nullptr;
  for (const auto& region : d.regions) {
    if (found && region->results().rank_at_interfaces() <= found->results().rank_at_interfaces()) continue;
    if (scene::contains(scene, region->id(), place, d.tolerance)) found = region.get();
  }
  return found ? found->id() : 0;
}

// Id of the region in which a point is evaluated: `wanted` or, if that is 0, the region at the place. Throws Error
// (argument) if the place lies outside that region; `number` is the point's index, for the message.
int region_for(const scene::Scene& scene, const regions::Discretization& d, const Point& place, std::size_t number,
               int wanted) {
  if (wanted == 0) {
    const int region = region_at(scene, d, place);
    require(region > 0, "point ", number + 1, ", (", place.x(), ", ", place.y(), "), lies outside the body");
    return region;
  }
  require(scene::contains(scene, wanted, place, d.tolerance), "point ", number + 1, ", (", place.x(), ", ", place.y(),
          "), lies outside region ", wanted, "; ask the region that has it, or let bempd_evaluate() choose");
  return wanted;
}

}  // namespace

PointValues evaluate(const scene::Scene& scene, const regions::Discretization& d, const regions::Solution& solution,
                     const FieldsOfScene& fields, const std::vector<Point>& places, bool with_stress,
                     const Side& side) {
  PointValues result;
  std::map<int, std::unique_ptr<regions::Evaluator>> evaluators;
  for (std::size_t i = 0; i < places.size(); ++i) {
    check_cancelled();
    const Point& place = places[i];
    require(place.allFinite(), "point ", i + 1, " is (", place.x(), ", ", place.y(),
            "); coordinates must be finite numbers");
    const int region = region_for(scene, d, place, i, side.region);
    std::unique_ptr<regions::Evaluator>& evaluator = evaluators[region];
    if (!evaluator) {
      const auto of_region = [&fields, region](regions::Field field) -> const regions::FieldValues& {
        return fields(region, field);
      };
      evaluator = d.region(region).results().evaluator(solution, of_region, with_stress);
      evaluator->choose_right_face(side.from_right);
    }
    const regions::PointValue value = evaluator->at(place);
    if (!value.displacement.allFinite() || !value.stress.allFinite()) {
      fail(Failure::unsolvable, "the displacement or stress at point ", i + 1, ", (", place.x(), ", ", place.y(),
           "), is beyond the range of numbers; choose other units, or smaller loads");
    }
    result.values.push_back(value);
  }
  for (const auto& [region, evaluator] : evaluators) result.kernel_evaluations += evaluator->kernel_evaluations();
  return result;
}

}  // namespace bempd::results
