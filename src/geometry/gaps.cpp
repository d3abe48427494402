#include "geometry/gaps.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <map>
#include <utility>

#include "geometry/edge_tree.hpp"

namespace bempd {

namespace {

Box around(const Point& p, double reach) {
  const Point margin = Point::Constant(reach);
  return {p - margin, p + margin};
}

class GapFinder {
 public:
  GapFinder(const std::vector<Outline>& regions, const std::vector<double>& reach) : reach_(reach) {
    std::vector<Box> boxes;
    Box all;
    for (const Outline& outline : regions) {
      bodies_.emplace_back(edges_of(outline));
      boxes.push_back(bodies_.back().box);
      all.extend(boxes.back());
    }
    tree_ = BoxTree(boxes);
    // Regions up to three tolerances apart count as touching, because two places that were each matched to a third
    // place may be two tolerances apart.
    tolerance_ = 3 * geometric_tolerance(all);
  }

  // Finds the gaps. Two boundaries that run along each other are closest at a vertex of one of them. On arcs, some
  // places between vertices are examined as well.
  std::vector<Gap> run() {
    for (int region = 0; region < static_cast<int>(bodies_.size()); ++region)
      for (const Edge& edge : bodies_[region].edges) {
        examine(region, edge, 0);
        if (!edge.straight())
          for (const double fraction : {0.25, 0.5, 0.75}) examine(region, edge, fraction);
      }
    std::vector<Gap> gaps;
    for (const auto& [regions, gap] : narrowest_) gaps.push_back(gap);
    return gaps;
  }

 private:
  void examine(int region, const Edge& edge, double fraction) {
    const Point p = edge.at(fraction);
    for (const int other : tree_.meeting(around(p, reach_[region]))) {
      if (other == region) continue;
      const double reach = std::min(reach_[region], reach_[other]);
      const auto [width, closest] = nearest(bodies_[other], p, reach);
      if (!(width > tolerance_ && width < reach)) continue;
      if (touch_near(p, 2 * reach, region, other) || touch_near(p, 2 * reach, other, region)) continue;
      const Point middle = 0.5 * (p + closest);
      if (is_filled(middle)) continue;
      const std::pair<int, int> both = std::minmax(region, other);
      const auto [known, is_new] = narrowest_.insert({both, {both.first, both.second, width, middle}});
      if (!is_new && width < known->second.width) known->second = {both.first, both.second, width, middle};
    }
  }

  // Distance and place of the point of a body's edges that is closest to `p`, within `reach`; infinitely far if there
  // is none.
  static std::pair<double, Point> nearest(const EdgeTree& body, const Point& p, double reach) {
    std::pair<double, Point> best{std::numeric_limits<double>::infinity(), p};
    for (const int k : body.tree.meeting(around(p, reach))) {
      const Point q = body.edges[k].at(closest_fraction(body.edges[k], p));
      if (const double distance = (q - p).norm(); distance < best.first) best = {distance, q};
    }
    return best;
  }

  // Whether two regions touch near `p`, so that a gap at `p` is a detail of their shapes.
  bool touch_near(const Point& p, double reach, int region, int other) const {
    for (const int k : bodies_[region].tree.meeting(around(p, reach)))
      for (const Point& end : {bodies_[region].edges[k].start, bodies_[region].edges[k].end})
        if ((end - p).norm() <= reach && bodies_[other].passes(end, tolerance_)) return true;
    return false;
  }

  bool is_filled(const Point& p) const {
    for (const int region : tree_.meeting(around(p, 0)))
      if (bodies_[region].locate(p, 0) != Location::outside) return true;
    return false;
  }

  const std::vector<double>& reach_;
  std::vector<EdgeTree> bodies_;
  BoxTree tree_;
  double tolerance_ = 0;
  std::map<std::pair<int, int>, Gap> narrowest_;
};

}  // namespace

std::vector<Gap> close_gaps(const std::vector<Outline>& regions, const std::vector<double>& reach) {
  assert(regions.size() == reach.size());
  return GapFinder(regions, reach).run();
}

}  // namespace bempd
