#include "geometry/hinges.hpp"

#include <algorithm>
#include <map>

namespace bempd {

namespace {

class HingeFinder {
 public:
  HingeFinder(const std::vector<std::vector<Edge>>& boundaries, const std::vector<Contact>& contacts, double tolerance)
      : boundaries_(boundaries), tolerance_(tolerance) {
    for (const auto& edges : boundaries) {
      Box box;
      for (const Edge& edge : edges) box.extend(bounding_box(edge));
      boxes_.push_back(box);
    }
    for (const Contact& c : contacts) {
      if (c.region > c.other_region) continue;
      links_.push_back({c.region, c.other_region, &boundaries[c.region][c.edge], c.from, c.to});
    }
  }

  // Two bodies that touch in a single point do so in a vertex of at least one of them.
  std::vector<PointTouch> run() {
    for (const auto& edges : boundaries_)
      for (const Edge& edge : edges) examine(edge.start);
    return std::move(hinges_);
  }

 private:
  struct Link {
    int a, b;
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
    for (const PointTouch& known : hinges_)
      if ((known.where - p).norm() <= 3 * tolerance_) return;
    std::vector<std::vector<int>> groups = connected_groups(present, p);
    if (groups.size() > 1) hinges_.push_back({p, std::move(groups)});
  }

  std::vector<int> regions_at(const Point& p) const {
    std::vector<int> present;
    for (std::size_t r = 0; r < boundaries_.size(); ++r) {
      if (boxes_[r].isEmpty() || boxes_[r].exteriorDistance(p) > tolerance_) continue;
      const auto at_p = [&](const Edge& edge) { return distance(edge, p) <= tolerance_; };
      if (std::any_of(boundaries_[r].begin(), boundaries_[r].end(), at_p)) present.push_back(static_cast<int>(r));
    }
    return present;
  }

  std::vector<std::vector<int>> connected_groups(const std::vector<int>& present, const Point& p) const {
    std::map<int, int> label;
    for (int r : present) label[r] = r;
    for (const Link& link : links_) {
      // Wider than for presence: the ends of a piece are themselves only known to the tolerance.
      if (!label.count(link.a) || !label.count(link.b) || link.distance_to(p) > 3 * tolerance_) continue;
      const int from = label[link.b], to = label[link.a];
      for (auto& entry : label)
        if (entry.second == from) entry.second = to;
    }
    std::map<int, std::vector<int>> members;
    for (int r : present) members[label[r]].push_back(r);
    std::vector<std::vector<int>> groups;
    for (auto& entry : members) groups.push_back(std::move(entry.second));
    std::sort(groups.begin(), groups.end());
    return groups;
  }

  const std::vector<std::vector<Edge>>& boundaries_;
  double tolerance_;
  std::vector<Box> boxes_;
  std::vector<Link> links_;
  std::vector<PointTouch> hinges_;
};

}  // namespace

std::vector<PointTouch> find_hinges(const std::vector<std::vector<Edge>>& boundaries,
                                    const std::vector<Contact>& contacts, double tolerance) {
  return HingeFinder(boundaries, contacts, tolerance).run();
}

}  // namespace bempd
