#include "geometry/coarse_sizes.hpp"

#include <algorithm>
#include <limits>

#include "geometry/halving.hpp"

namespace bempd {

namespace {

// Ratio of the length of the longest element to the length of the outer loop.
constexpr double share_of_outline = 1.0 / 8;

// Ratio of the length of the longest element to its distance from a part of the boundary that its panel does not meet.
constexpr double share_of_gap = 2;

// Ratio of two distances of a place on a panel: that from a panel with which it has a common corner to that from the
// corner. Below this ratio both panels count as running beside each other with a gap.
constexpr double aside = 0.3;
// Ratio of the least length of elements beside a neighbouring panel (see `aside`) to the length of the elements' panel.
constexpr double least_beside = 1.0 / 16;

// Largest number of halvings of a panel's elements. Parts of the boundary that touch would need any number of halvings.
constexpr int most_halvings = 12;

double distance(const Arc& arc, const Point& x) { return (arc.at(closest_fraction(arc, x)) - x).norm(); }

}  // namespace

double coarsest_element(const Outline& outline) {
  double sum = 0;
  for (std::size_t k = 0; k < outline.loops.front().size(); ++k) sum += outline.edge(static_cast<int>(k)).length();
  return share_of_outline * sum;
}

CoarseSizes::CoarseSizes(const std::vector<std::vector<Panel>>& loops) {
  for (const std::vector<Panel>& loop : loops) {
    const int first = static_cast<int>(panels_.size()), count = static_cast<int>(loop.size());
    for (int k = 0; k < count; ++k) {
      const Arc arc = loop[static_cast<std::size_t>(k)].arc();
      panels_.push_back({arc, arc.length(), first + (k + count - 1) % count, first + (k + 1) % count});
      boxes_.push_back(bounding_box(Edge(arc)));
    }
  }
  tree_ = BoxTree(boxes_);
  for (std::size_t k = 0; k < loops.front().size(); ++k) longest_ += share_of_outline * panels_[k].length;
}

// Panels that may limit the elements of a panel.
std::vector<int> CoarseSizes::near(int panel) const {
  Box box = bounding_box(Edge(panels_[static_cast<std::size_t>(panel)].arc));
  const double reach = std::min(longest_, panels_[static_cast<std::size_t>(panel)].length);
  box.min() -= Point::Constant(reach), box.max() += Point::Constant(reach);
  std::vector<int> others = tree_.meeting(box);
  std::erase(others, panel);
  return others;
}

double CoarseSizes::limit(int panel, const std::vector<int>& others, double fraction) const {
  const Placed& own = panels_[static_cast<std::size_t>(panel)];
  const Point x = own.arc.at(fraction);
  double limit = std::numeric_limits<double>::infinity();
  for (const int number : others) {
    const Placed& other = panels_[static_cast<std::size_t>(number)];
    const bool is_beside = number == own.before || number == own.behind;
    const double least_gap = boxes_[static_cast<std::size_t>(number)].exteriorDistance(x);
    if (!is_beside && share_of_gap * least_gap >= limit) continue;
    const double gap = distance(other.arc, x);
    if (!is_beside) {
      limit = std::min(limit, share_of_gap * gap);
    } else {
      double apart = std::numeric_limits<double>::infinity();
      if (number == own.before) apart = (own.arc.start - x).norm();
      if (number == own.behind) apart = std::min(apart, (own.arc.end - x).norm());
      limit = std::min(limit, std::max(apart, other.length));
      if (gap < aside * apart) limit = std::min(limit, std::max(share_of_gap * gap, least_beside * own.length));
    }
  }
  return limit;
}

std::vector<double> CoarseSizes::stations(int panel) const {
  const Placed& own = panels_[static_cast<std::size_t>(panel)];
  const std::vector<double> equal = element_stations(own.length, longest_, 1, own.arc.sweep);
  const std::vector<int> others = near(panel);
  std::vector<double> ends{0.0};
  for (std::size_t i = 0; i + 1 < equal.size(); ++i)
    halve(
        equal[i], equal[i + 1], (equal[i + 1] - equal[i]) * own.length,
        [&](double fraction) { return limit(panel, others, fraction); }, most_halvings, ends);
  return ends;
}

}  // namespace bempd
