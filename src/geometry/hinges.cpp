#include "geometry/hinges.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace bempd {

namespace {

class HingeFinder {
 public:
  HingeFinder(const std::vector<EdgeTree>& boundaries, const std::vector<Contact>& contacts, double tolerance)
      : boundaries_(boundaries), tolerance_(tolerance) {
    std::vector<Box> boxes;
    boxes.reserve(boundaries.size());
    for (const EdgeTree& boundary : boundaries) boxes.push_back(boundary.box);
    regions_ = BoxTree(boxes);
    for (const Contact& c : contacts) {
      if (c.region > c.other_region) continue;
      links_[{c.region, c.edge}].push_back({c.other_region, &boundaries[c.region].edges[c.edge], c.from, c.to});
    }
  }

  // Finds the hinges among the vertices, because bodies that touch in a single point have a vertex of at least one body
  // there.
  std::vector<PointTouch> run() {
    for (const EdgeTree& boundary : boundaries_)
      for (const Edge& edge : boundary.edges) examine(edge.start);
    return std::move(hinges_);
  }

 private:
  struct Link {
    int other;
    const Edge* edge;
    double from, to;

    double distance_to(const Point& p) const {
      const double fraction = std::clamp(closest_fraction(*edge, p), from, to);
      return (edge->at(fraction) - p).norm();
    }
  };

  void examine(const Point& p) {
    const std::vector<int> present = regions_at(p);
    if (present.size() < 2) return;
    std::vector<std::vector<int>> groups = connected_groups(present, p);
    if (groups.size() > 1 && !is_known(p)) {
      places_.emplace(p.x(), p);
      hinges_.push_back({p, std::move(groups)});
    }
  }

  bool is_known(const Point& p) const {
    const double reach = 3 * tolerance_;
    for (auto near = places_.lower_bound(p.x() - reach); near != places_.end() && near->first <= p.x() + reach; ++near)
      if ((near->second - p).norm() <= reach) return true;
    return false;
  }

  std::vector<int> regions_at(const Point& p) const {
    const Point margin = Point::Constant(tolerance_);
    std::vector<int> present;
    for (const int r : regions_.meeting({p - margin, p + margin}))
      if (boundaries_[r].passes(p, tolerance_)) present.push_back(r);
    return present;
  }

  std::vector<std::vector<int>> connected_groups(const std::vector<int>& present, const Point& p) const {
    std::map<int, int> label;
    for (int r : present) label[r] = r;
    // The reach is larger than the tolerance of regions_at(), because the ends of a contact are known only up to the
    // tolerance.
    const double reach = 3 * tolerance_;
    const Point margin = Point::Constant(reach);
    for (const int region : present)
      for (const int edge : boundaries_[region].tree.meeting({p - margin, p + margin})) {
        const auto links = links_.find({region, edge});
        if (links == links_.end()) continue;
        for (const Link& link : links->second) {
          if (!label.count(link.other) || link.distance_to(p) > reach) continue;
          const int from = label[link.other], to = label[region];
          for (auto& entry : label)
            if (entry.second == from) entry.second = to;
        }
      }
    std::map<int, std::vector<int>> members;
    for (int r : present) members[label[r]].push_back(r);
    std::vector<std::vector<int>> groups;
    groups.reserve(members.size());
    for (auto& entry : members) groups.push_back(std::move(entry.second));
    std::sort(groups.begin(), groups.end());
    return groups;
  }

  const std::vector<EdgeTree>& boundaries_;
  double tolerance_;
  BoxTree regions_;
  std::map<std::pair<int, int>, std::vector<Link>> links_;  // by the lower region number and its edge
  std::vector<PointTouch> hinges_;
  std::multimap<double, Point> places_;  // places of the hinges by x
};

}  // namespace

std::vector<PointTouch> find_hinges(const std::vector<EdgeTree>& boundaries, const std::vector<Contact>& contacts,
                                    double tolerance) {
  return HingeFinder(boundaries, contacts, tolerance).run();
}

}  // namespace bempd
