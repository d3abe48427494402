#include "geometry/subdomain_loops.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

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

bool encloses(const SubdomainLoop& loop, const Point& p, const std::vector<Point>& positions) {
  bool inside = false;
  for (const SubdomainSide& side : loop) {
    const Point &a = positions[side.nodes[0]], &b = positions[side.nodes[2]];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
  }
  return inside;
}

SubdomainLoop reversed(const SubdomainLoop& cut) {
  SubdomainLoop back(cut.rbegin(), cut.rend());
  for (SubdomainSide& side : back) std::swap(side.nodes[0], side.nodes[2]), side.sweep = -side.sweep;
  return back;
}

// Sides of a subdomain with the number of the side that follows each.
class SideRing {
 public:
  explicit SideRing(const SubdomainLoops& loops) {
    for (const SubdomainLoop& loop : loops) {
      const int first = append(loop);
      next_.back() = first;
    }
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      leaving_[sides_[i].nodes[0]] = static_cast<int>(i);
      arriving_[sides_[i].nodes[2]] = static_cast<int>(i);
    }
  }

  // Joins both faces of a cut to the sides at its ends.
  void insert(const SubdomainLoop& cut) {
    const int from = cut.front().nodes[0], to = cut.back().nodes[2];
    const int forward = append(cut), backward = append(reversed(cut));
    next_[arriving_.at(from)] = forward;
    next_[static_cast<std::size_t>(backward) - 1] = leaving_.at(to);
    next_[arriving_.at(to)] = backward;
    next_.back() = leaving_.at(from);
  }

  SubdomainLoops loops() const {
    SubdomainLoops found;
    std::vector<char> done(sides_.size(), 0);
    for (std::size_t first = 0; first < sides_.size(); ++first) {
      if (done[first]) continue;
      found.emplace_back();
      for (std::size_t i = first; !done[i]; i = static_cast<std::size_t>(next_[i])) {
        done[i] = 1;
        found.back().push_back(sides_[i]);
      }
    }
    return found;
  }

 private:
  int append(const SubdomainLoop& row) {
    const int first = static_cast<int>(sides_.size());
    for (const SubdomainSide& side : row) {
      sides_.push_back(side);
      next_.push_back(static_cast<int>(sides_.size()));
    }
    return first;
  }

  SubdomainLoop sides_;
  std::vector<int> next_;
  std::unordered_map<int, int> leaving_, arriving_;  // side that leaves or arrives at a node of a loop
};

}  // namespace

std::vector<SubdomainLoops> split(const SubdomainLoops& loops, const std::vector<SubdomainLoop>& cuts,
                                  const std::vector<Point>& positions) {
  SideRing ring(loops);
  for (const SubdomainLoop& cut : cuts) ring.insert(cut);
  std::vector<SubdomainLoops> parts;
  std::vector<double> areas;
  SubdomainLoops holes;
  for (SubdomainLoop& loop : ring.loops()) {
    if (const double area = area_of(loop, positions); area <= 0) {
      holes.push_back(std::move(loop));
    } else {
      areas.push_back(area);
      parts.push_back({std::move(loop)});
    }
  }
  for (SubdomainLoop& hole : holes) {
    std::size_t owner = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (areas[i] >= least || !encloses(parts[i].front(), positions[hole.front().nodes[0]], positions)) continue;
      owner = i, least = areas[i];
    }
    parts[owner].push_back(std::move(hole));
  }
  return parts;
}

}  // namespace bempd
