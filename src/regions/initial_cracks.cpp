#include "regions/initial_cracks.hpp"

#include <algorithm>

#include "cancellation.hpp"
#include "error.hpp"

namespace bempd::regions {

using scene::Scene;

namespace {

// Where a segment may pass from one region to another: crossings with edges, and vertices and ends that touch.
std::vector<double> crossings(const Scene& scene, const Segment& segment, double tolerance) {
  std::vector<double> fractions{0.0, 1.0};
  for (int id : scene.region_ids()) {
    for (const Edge& edge : edges_of(scene.region(id).outline())) {
      for (const Crossing& crossing : meeting_points(Edge(segment.start, segment.end), edge))
        fractions.push_back(crossing.fraction_a);
      if (distance(segment, edge.start) <= tolerance) fractions.push_back(closest_fraction(segment, edge.start));
    }
  }
  std::sort(fractions.begin(), fractions.end());
  return fractions;
}

// The region that has elements on a piece of a crack, 0 where bonds can be cut.
int region_of_piece(const Preparation& p, int crack, const Point& middle) {
  std::vector<int> with_elements;
  int other = 0;
  for (const auto& region : p.regions) {
    if (locate(p.scene.region(region->id()).outline(), middle, p.tolerance) == Location::outside) continue;
    if (region->takes_cracks()) return 0;
    if (region->has_crack_elements()) with_elements.push_back(region->id());
    other = region->id();
  }
  require(other > 0, "crack ", crack, " passes (", middle.x(), ", ", middle.y(),
          "), which is outside the body; end the crack on the body's boundary or inside");
  require(!with_elements.empty(), "crack ", crack, " passes (", middle.x(), ", ", middle.y(), "), which is in region ",
          other, ", a ", p.scene.region(other).adjective(),
          " region; the chosen scheme has cracks in peridynamic regions only, scheme symmetric has them in both");
  require(with_elements.size() == 1, "crack ", crack, " runs along the interface of the regions ",
          with_elements.front(), " and ", with_elements.back(), " at (", middle.x(), ", ", middle.y(),
          "); it has to lie inside of one of them");
  return with_elements.front();
}

int region_of_crack(const Preparation& p, int crack, const std::vector<Point>& points) {
  if (points.empty()) return 0;  // removed
  int found = -1;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    check_cancelled();
    const Segment segment{points[k], points[k + 1]};
    const std::vector<double> stations = crossings(p.scene, segment, p.tolerance);
    for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
      if ((stations[i + 1] - stations[i]) * segment.length() <= 10 * p.tolerance) continue;
      const Point middle = segment.at(0.5 * (stations[i] + stations[i + 1]));
      const int region = region_of_piece(p, crack, middle);
      const auto name = [&](int id) {
        return id == 0 ? std::string("a peridynamic region") : text("the BEM region ", id);
      };
      require(found < 0 || region == found, "crack ", crack, " goes from ", name(found), " into ", name(region),
              " before (", middle.x(), ", ", middle.y(), "); end it at the interface");
      found = region;
    }
  }
  // All of it may be too short for the question where it passes from one region to another.
  return found < 0 ? region_of_piece(p, crack, 0.5 * (points[0] + points[1])) : found;
}

}  // namespace

std::vector<int> regions_of_cracks(const Preparation& preparation) {
  std::vector<int> regions;
  for (const scene::Crack& crack : preparation.scene.cracks())
    regions.push_back(region_of_crack(preparation, static_cast<int>(regions.size()) + 1, crack.points));
  return regions;
}

LatticeCracks cracks_in_lattices(const Scene& scene, const Discretization& d, const scene::Options& options) {
  LatticeCracks found{scene.cracks(), {}};
  if (options.text_value("pd.crack_tip") == "ahead") return found;
  for (std::size_t c = 0; c < found.cracks.size(); ++c) {
    const std::vector<Point> points = found.cracks[c].points;
    if (d.crack_regions[c] > 0 || points.size() < 2) continue;
    const auto move = [&](const Point& tip, const Point& before, Point& end) {
      // Both ends of a single piece may move.
      const double length = (tip - before).norm(), backward = (points.size() > 2 ? 0.9 : 0.45) * length;
      for (const auto& region : d.regions) {
        if (locate(scene.region(region->id()).outline(), tip, d.tolerance) != Location::inside) continue;
        const pd::FeltEnd felt = region->end_felt_at(tip, (tip - before) / length, backward);
        end = felt.end;
        for (const int bond : felt.weakened) found.weakened.emplace_back(bond, felt.share);
      }
    };
    move(points.front(), points[1], found.cracks[c].points.front());
    move(points.back(), points.end()[-2], found.cracks[c].points.back());
  }
  return found;
}

std::vector<int> bonds_cut_by_cracks(const std::vector<scene::Crack>& cracks, const Discretization& d,
                                     std::vector<std::string>& warnings) {
  std::vector<int> cut;
  for (std::size_t c = 0; c < cracks.size(); ++c) {
    if (d.crack_regions[c] > 0) continue;
    const int id = static_cast<int>(c) + 1;
    for (const auto& region : d.regions) region->cut(cracks[c], id, cut, warnings);
  }
  std::sort(cut.begin(), cut.end());
  cut.erase(std::unique(cut.begin(), cut.end()), cut.end());
  return cut;
}

std::vector<StartingTip> tips_of_cracks(const Scene& scene, const std::vector<scene::Crack>& cracks,
                                        const Discretization& d, const scene::Options& options) {
  std::vector<StartingTip> tips;
  for (std::size_t c = 0; c < cracks.size(); ++c) {
    const std::vector<Point>& points = cracks[c].points;
    if (d.crack_regions[c] > 0 || points.size() < 2) continue;
    for (const auto& [end, before] : {std::pair(points.front(), points[1]), std::pair(points.back(), points.end()[-2])})
      for (const auto& region : d.regions) {
        if (locate(scene.region(region->id()).outline(), end, d.tolerance) != Location::inside) continue;
        if (std::optional<pd::TipLaw> law = region->tip_law(options)) {
          law->crack = static_cast<int>(c) + 1;
          tips.push_back({end, (end - before).normalized(), *law});
        }
      }
  }
  return tips;
}

}  // namespace bempd::regions
