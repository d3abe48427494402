#include "geometry/subdomain_loops.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>

#include "geometry/edge.hpp"
#include "geometry/turning.hpp"

namespace bempd {

namespace {

// Area inside a loop whose sides are taken as straight; positive if the loop is counter-clockwise.
double area_of(const SubdomainLoop& loop, const std::vector<Point>& positions) {
  const Point& origin = positions[loop.front().nodes[0]];
  double twice = 0;
  for (const SubdomainSide& side : loop)
    twice += cross(positions[side.nodes[0]] - origin, positions[side.nodes[2]] - origin);
  return 0.5 * twice;
}

}  // namespace

bool encloses(const SubdomainLoop& loop, const Point& p, const std::vector<Point>& positions) {
  bool inside = false;
  for (const SubdomainSide& side : loop) {
    const Point &a = positions[side.nodes[0]], &b = positions[side.nodes[2]];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
  }
  return inside;
}

namespace {

SubdomainLoop reversed(const SubdomainLoop& cut) {
  SubdomainLoop back(cut.rbegin(), cut.rend());
  for (SubdomainSide& side : back) std::swap(side.nodes[0], side.nodes[2]), side.sweep = -side.sweep;
  return back;
}

// Sides of a body and of both faces of all cuts. They are joined to loops, in which each side is followed by the next
// side clockwise around its end.
class SideFaces {
 public:
  SideFaces(const SubdomainLoops& loops, const std::vector<SubdomainLoop>& cuts, const std::vector<Point>& positions)
      : positions_(positions) {
    for (const SubdomainLoop& loop : loops) append(loop);
    for (const SubdomainLoop& cut : cuts) {
      append(cut);
      append(reversed(cut));
    }
    by_start_.resize(sides_.size());
    std::iota(by_start_.begin(), by_start_.end(), 0);
    std::stable_sort(by_start_.begin(), by_start_.end(), [&](int a, int b) { return start_of(a) < start_of(b); });
  }

  // Closed loops of all sides. The result is empty if two sides are followed by the same side, because a cut leaves the
  // body at that place, or the cut's direction is lost in the rounding of coordinates.
  SubdomainLoops loops() const {
    SubdomainLoops found;
    std::vector<char> done(sides_.size(), 0);
    for (std::size_t first = 0; first < sides_.size(); ++first) {
      if (done[first]) continue;
      found.emplace_back();
      std::size_t i = first;
      for (; !done[i]; i = after(i)) {
        done[i] = 1;
        found.back().push_back(sides_[i]);
      }
      if (i != first) return {};
    }
    return found;
  }

 private:
  void append(const SubdomainLoop& row) { sides_.insert(sides_.end(), row.begin(), row.end()); }

  int start_of(int side) const { return sides_[static_cast<std::size_t>(side)].nodes[0]; }

  std::span<const int> sides_that_leave(int node) const {
    const auto first = std::lower_bound(by_start_.begin(), by_start_.end(), node,
                                        [&](int side, int wanted) { return start_of(side) < wanted; });
    auto end = first;
    while (end != by_start_.end() && start_of(*end) == node) ++end;
    return {first, end};
  }

  std::size_t after(std::size_t i) const {
    const auto candidates = sides_that_leave(sides_[i].nodes[2]);
    if (candidates.size() == 1) return static_cast<std::size_t>(candidates.front());
    const Point back = turned(positions_[sides_[i].nodes[0]] - positions_[sides_[i].nodes[2]], 0.5 * sides_[i].sweep);
    int best = candidates.front();
    double least = std::numeric_limits<double>::infinity();
    for (const int one : candidates) {
      const SubdomainSide& side = sides_[static_cast<std::size_t>(one)];
      const Point along = turned(positions_[side.nodes[2]] - positions_[side.nodes[0]], -0.5 * side.sweep);
      double angle = std::atan2(-cross(back, along), back.dot(along));  // clockwise
      if (angle <= no_angle) angle += 2 * std::numbers::pi;             // the other face of a cut comes last
      if (angle < least) least = angle, best = one;
    }
    return static_cast<std::size_t>(best);
  }

  // Angle that counts as rounding error [rad]; cuts and sides that meet make larger angles.
  static constexpr double no_angle = 1e-6;

  const std::vector<Point>& positions_;
  SubdomainLoop sides_;
  std::vector<int> by_start_;  // numbers of sides, sorted by the nodes at which they start
};

}  // namespace

std::vector<SubdomainLoops> split(const SubdomainLoops& loops, const std::vector<SubdomainLoop>& cuts,
                                  const std::vector<Point>& positions) {
  const SideFaces faces(loops, cuts, positions);
  std::vector<SubdomainLoops> parts;
  std::vector<double> areas;
  std::vector<Box> boxes;
  SubdomainLoops holes;
  for (SubdomainLoop& loop : faces.loops()) {
    if (const double area = area_of(loop, positions); area <= 0) {
      holes.push_back(std::move(loop));
    } else {
      areas.push_back(area);
      boxes.emplace_back();
      for (const SubdomainSide& side : loop) boxes.back().extend(positions[side.nodes[0]]);
      parts.push_back({std::move(loop)});
    }
  }
  for (SubdomainLoop& hole : holes) {
    std::size_t owner = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (areas[i] >= least || !boxes[i].contains(positions[hole.front().nodes[0]])) continue;
      if (!encloses(parts[i].front(), positions[hole.front().nodes[0]], positions)) continue;
      owner = i, least = areas[i];
    }
    if (parts.empty()) return {};
    parts[owner].push_back(std::move(hole));
  }
  return parts;
}

}  // namespace bempd
