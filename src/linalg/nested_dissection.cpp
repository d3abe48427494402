#include "linalg/nested_dissection.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "cancellation.hpp"

namespace bempd::linalg {

namespace {

// Number of nodes in parts that are not divided further: their part of the factor is full anyway.
constexpr std::ptrdiff_t leaf_size = 24;

class Dissection {
 public:
  Dissection(const NodeGraph& graph, const std::vector<char>& member)
      : graph_(graph),
        reach_(graph.positions.size(), 0),
        side_(graph.positions.size(), none),
        grouped_(graph.positions.size(), 0) {
    const int count = static_cast<int>(graph.positions.size());
    for (int n = 0; n < count; ++n) {
      if (!member[n]) continue;
      nodes_.push_back(n);
      for (int partner : graph.partners.of(n)) {
        const double span = (graph.positions[partner] - graph.positions[n]).cwiseAbs().maxCoeff();
        reach_[n] = std::max(reach_[n], span);
      }
    }
    for (const std::vector<int>& group : graph.groups) {
      for (int n : group) grouped_[n] = 1;
    }
  }

  std::vector<int> order() {
    divide(nodes_.begin(), nodes_.end());
    return std::move(nodes_);
  }

 private:
  using Iterator = std::vector<int>::iterator;
  enum Side : char { none, lower, upper };

  void divide(Iterator begin, Iterator end) {
    if (end - begin <= leaf_size) return;
    check_cancelled();
    Eigen::AlignedBox2d box;
    for (Iterator it = begin; it != end; ++it) box.extend(graph_.positions[*it]);
    const int axis = box.sizes().x() * (1 + 1e-9) >= box.sizes().y() ? 0 : 1;
    const double cut = middle(begin, end, axis);
    for (Iterator it = begin; it != end; ++it) side_[*it] = graph_.positions[*it][axis] < cut ? lower : upper;
    const std::vector<int> from_lower = boundary(begin, end, axis, cut, lower);
    const std::vector<int> from_upper = boundary(begin, end, axis, cut, upper);
    const std::vector<int>& separator = from_lower.size() <= from_upper.size() ? from_lower : from_upper;
    for (int n : separator) side_[n] = none;
    const Iterator upper_begin = std::stable_partition(begin, end, [&](int n) { return side_[n] == lower; });
    const Iterator upper_end = std::stable_partition(upper_begin, end, [&](int n) { return side_[n] == upper; });
    for (Iterator it = begin; it != end; ++it) side_[*it] = none;
    if (upper_begin - begin == 0 || upper_end - upper_begin == 0) return;
    divide(begin, upper_begin);
    divide(upper_begin, upper_end);
  }

  // Coordinate of a cut between nodes of different coordinates, with half of the nodes on each side if possible.
  double middle(Iterator begin, Iterator end, int axis) {
    coordinates_.clear();
    for (Iterator it = begin; it != end; ++it) coordinates_.push_back(graph_.positions[*it][axis]);
    const auto median = coordinates_.begin() + static_cast<std::ptrdiff_t>(coordinates_.size() / 2);
    std::nth_element(coordinates_.begin(), median, coordinates_.end());
    const double value = *median;
    const auto [lowest_place, highest] = std::minmax_element(coordinates_.begin(), coordinates_.end());
    const double lowest = *lowest_place;
    // The tolerance is relative to the part's size, because the order must not depend on the unit of length.
    const double tolerance = 1e-9 * (*highest - lowest);
    return value - tolerance > lowest ? value - tolerance : value + tolerance;
  }

  // Nodes of one side of a cut that are coupled to the other side.
  std::vector<int> boundary(Iterator begin, Iterator end, int axis, double cut, Side side) {
    const Side other = side == lower ? upper : lower;
    std::vector<char> group_is_cut;
    for (const std::vector<int>& group : graph_.groups) {
      group_is_cut.push_back(std::any_of(group.begin(), group.end(), [&](int n) { return side_[n] == other; }) ? 1 : 0);
    }
    std::vector<int> found;
    for (Iterator it = begin; it != end; ++it) {
      if (side_[*it] != side) continue;
      const bool near = std::abs(graph_.positions[*it][axis] - cut) <= reach_[*it] * (1 + 1e-9);
      if ((near && has_partner(*it, other)) || (grouped_[*it] && in_cut_group(*it, group_is_cut))) found.push_back(*it);
    }
    return found;
  }

  bool has_partner(int node, Side side) const {
    const std::span<const int> partners = graph_.partners.of(node);
    return std::any_of(partners.begin(), partners.end(), [&](int n) { return side_[n] == side; });
  }

  bool in_cut_group(int node, const std::vector<char>& group_is_cut) const {
    for (std::size_t g = 0; g < group_is_cut.size(); ++g) {
      const std::vector<int>& group = graph_.groups[g];
      if (group_is_cut[g] && std::find(group.begin(), group.end(), node) != group.end()) return true;
    }
    return false;
  }

  const NodeGraph& graph_;
  std::vector<int> nodes_;
  std::vector<double> reach_, coordinates_;
  std::vector<Side> side_;
  std::vector<char> grouped_;
};

}  // namespace

NodeGraph::NodeGraph(std::vector<Eigen::Vector2d> positions_of_nodes, const std::vector<int>& first,
                     const std::vector<int>& second, std::vector<std::vector<int>> coupled_groups)
    : positions(std::move(positions_of_nodes)),
      partners(make_adjacency(positions.size(),
                              [&](const auto& add) {
                                for (std::size_t b = 0; b < first.size(); ++b) {
                                  add(first[b], second[b]);
                                  add(second[b], first[b]);
                                }
                              })),
      groups(std::move(coupled_groups)) {}

std::vector<int> nested_dissection(const NodeGraph& graph, const std::vector<char>& member) {
  return Dissection(graph, member).order();
}

}  // namespace bempd::linalg
