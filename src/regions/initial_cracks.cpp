#include "regions/initial_cracks.hpp"

#include <algorithm>

#include "error.hpp"

namespace bempd::regions {

using scene::Scene;

namespace {

// Where a segment may pass from one region to another: crossings with edges, and vertices and ends that touch.
std::vector<double> crossings(const Scene& scene, const Segment& segment, double tolerance) {
  std::vector<double> fractions{0.0, 1.0};
  for (const auto& region : scene.regions()) {
    for (const Edge& edge : edges_of(region->outline())) {
      for (const Crossing& crossing : meeting_points(Edge(segment.start, segment.end), edge))
        fractions.push_back(crossing.fraction_a);
      if (distance(segment, edge.start) <= tolerance) fractions.push_back(closest_fraction(segment, edge.start));
    }
  }
  std::sort(fractions.begin(), fractions.end());
  return fractions;
}

// In regions whose bonds can be cut.
void require_in_lattices(const Scene& scene, const Discretization& d, int crack, const Segment& segment) {
  const double tolerance = d.tolerance;
  const std::vector<double> stations = crossings(scene, segment, tolerance);
  for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
    if ((stations[i + 1] - stations[i]) * segment.length() <= 10 * tolerance) continue;
    const Point middle = segment.at(0.5 * (stations[i] + stations[i + 1]));
    bool inside = false;
    int other = 0;
    for (const auto& region : d.regions) {
      if (locate(scene.region(region->id()).outline(), middle, tolerance) == Location::outside) continue;
      if (region->takes_cracks()) {
        inside = true;
      } else {
        other = region->id();
      }
    }
    require(inside, "crack ", crack, " passes (", middle.x(), ", ", middle.y(), "), which is ",
            other > 0
                ? text("in region ", other, ", a ", scene.region(other).adjective(),
                       " region; cracks can only lie in peridynamic regions")
                : std::string("outside the body; end the crack on the boundary of a peridynamic region or inside"));
  }
}

}  // namespace

std::vector<int> bonds_cut_by_cracks(const Scene& scene, const Discretization& d, std::vector<std::string>& warnings) {
  std::vector<int> cut;
  for (std::size_t c = 0; c < scene.cracks().size(); ++c) {
    const std::vector<Point>& points = scene.cracks()[c].points;
    const int id = static_cast<int>(c) + 1;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      require_in_lattices(scene, d, id, {points[i], points[i + 1]});
    }
    for (const auto& region : d.regions) region->cut(scene.cracks()[c], id, cut, warnings);
  }
  std::sort(cut.begin(), cut.end());
  cut.erase(std::unique(cut.begin(), cut.end()), cut.end());
  return cut;
}

}  // namespace bempd::regions
