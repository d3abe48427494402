#include "regions/discretization.hpp"

#include "regions/initial_cracks.hpp"
#include "regions/interfaces.hpp"
#include "regions/scheme.hpp"
#include "stopwatch.hpp"

namespace bempd::regions {

std::vector<coupling::DenseOperator> Discretization::dense_operators() const {
  std::vector<RegionOperator> known;
  for (const auto& region : regions) {
    if (auto dense = region->dense_operator(known)) known.push_back({region.get(), std::move(*dense)});
  }
  std::vector<coupling::DenseOperator> operators;
  for (RegionOperator& one : known) operators.push_back(std::move(one.dense));
  return operators;
}

RegionStatistics Discretization::statistics() const {
  RegionStatistics sum;
  for (const auto& region : regions) region->add_statistics(sum);
  return sum;
}

Discretization discretize(const scene::Scene& scene, const scene::Options& options) {
  Discretization d;
  std::vector<Outline> outlines;
  for (const auto& region : scene.regions()) outlines.push_back(region->outline());
  const Box box = scene.bounding_box();
  d.tolerance = geometric_tolerance(box);
  d.arrangement = arrange(outlines);
  const std::unique_ptr<Scheme> scheme = make_scheme(options);
  const Preparation preparation{scene, options, *scheme, d.arrangement, d.tolerance, d.regions, d.crack_regions};
  require_compatible(preparation);

  for (int id = 1; id <= scene.region_count(); ++id) d.regions.push_back(scene.region(id).build(id, preparation));
  d.crack_regions = regions_of_cracks(preparation);
  for (const auto& region : d.regions) {
    const Stopwatch watch(region->seconds_preparing);
    region->mesh(preparation);
  }
  NodeRegistry registry(box.min(), 10 * d.tolerance);
  Contributions contributions{registry, d.bonds, d.critical_stretch, d.warnings};
  for (const auto& region : d.regions) {
    const Stopwatch watch(region->seconds_preparing);
    region->build(preparation, contributions);
  }
  for (const auto& region : d.regions) {
    for (const LeadingElements& leading : region->leading_elements())
      d.region(leading.follower).follow(leading, region->id(), d.ties);
  }
  d.positions = registry.positions();
  return d;
}

}  // namespace bempd::regions
