#include "regions/initial_cracks.hpp"

#include <algorithm>

#include "error.hpp"
#include "pd/crack.hpp"

namespace bempd::model {

namespace {

// Where a segment may pass from one region to another: crossings with edges, and vertices and ends that touch.
std::vector<double> crossings(const Scene& scene, const Segment& segment, double tolerance) {
  std::vector<double> fractions{0.0, 1.0};
  for (const Region& region : scene.regions()) {
    for (const Edge& edge : edges_of(region.outline)) {
      for (const Crossing& crossing : meeting_points(Edge(segment.start, segment.end), edge))
        fractions.push_back(crossing.fraction_a);
      if (distance(segment, edge.start) <= tolerance) fractions.push_back(closest_fraction(segment, edge.start));
    }
  }
  std::sort(fractions.begin(), fractions.end());
  return fractions;
}

void require_in_lattices(const Scene& scene, int crack, const Segment& segment, double tolerance) {
  const std::vector<double> stations = crossings(scene, segment, tolerance);
  for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
    if ((stations[i + 1] - stations[i]) * segment.length() <= 10 * tolerance) continue;
    const Point middle = segment.at(0.5 * (stations[i] + stations[i + 1]));
    bool inside = false;
    int other = 0;
    for (std::size_t r = 0; r < scene.regions().size(); ++r) {
      const Region& region = scene.regions()[r];
      if (locate(region.outline, middle, tolerance) == Location::outside) continue;
      if (region.kind == RegionKind::peridynamics) {
        inside = true;
      } else {
        other = static_cast<int>(r) + 1;
      }
    }
    require(inside, "crack ", crack, " passes (", middle.x(), ", ", middle.y(), "), which is ",
            other > 0
                ? text("in region ", other, ", a BEM region; cracks can only lie in peridynamic regions")
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
      require_in_lattices(scene, id, {points[i], points[i + 1]}, d.tolerance);
    }
    for (const LatticePart& part : d.lattices) {
      std::vector<Point> polyline;
      for (const Point& p : points) polyline.push_back(part.to_grid(p));
      const std::vector<int> touched = pd::points_on(part.points, polyline);
      if (!touched.empty()) {
        const Point where = part.position(touched.front());
        const std::string finding =
            text("crack ", id, " passes through ", touched.size(), " material points of region ", part.region,
                 ", the first at (", where.x(), ", ", where.y(), ")");
        require(part.cell_centred, finding,
                "; a point on a crack belongs to neither side: shift the crack or the region by half a spacing (",
                0.5 * part.spacing(), ")");
        warnings.push_back(finding + "; they stay bonded to both of its faces and bridge it");
      }
      const pd::Touching touching = part.cell_centred ? pd::Touching::of_ends_keeps : pd::Touching::cuts;
      for (int bond : pd::bonds_cut_by(part.points, part.bonds(), polyline, touching)) {
        cut.push_back(static_cast<int>(part.first_bond) + bond);
      }
    }
  }
  std::sort(cut.begin(), cut.end());
  cut.erase(std::unique(cut.begin(), cut.end()), cut.end());
  return cut;
}

}  // namespace bempd::model
