#include "linalg/nested_dissection.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>

#include "cancellation.hpp"

namespace bempd::linalg {

namespace {

// Number of nodes up to which a part of the graph is not divided further, because the factor is full there anyway.
constexpr std::ptrdiff_t leaf_size = 24;

class Dissection {
 public:
  Dissection(const NodeGraph& graph, const std::vector<char>& member)
      : graph_(graph),
        reach_(graph.positions.size(), 0),
        side_(graph.positions.size(), none),
        group_state_(graph.groups.size(), not_known) {
    const int count = static_cast<int>(graph.positions.size());
    for (int n = 0; n < count; ++n) {
      if (!member[n]) continue;
      nodes_.push_back(n);
      for (int partner : graph.partners.of(n)) {
        const double span = (graph.positions[partner] - graph.positions[n]).cwiseAbs().maxCoeff();
        reach_[n] = std::max(reach_[n], span);
      }
    }
    groups_of_ = make_adjacency(graph.positions.size(), [&](const auto& add) {
      for (std::size_t g = 0; g < graph.groups.size(); ++g)
        for (const int n : graph.groups[g]) add(n, static_cast<int>(g));
    });
  }

  std::vector<int> order() {
    divide(nodes_.begin(), nodes_.end());
    return std::move(nodes_);
  }

 private:
  using Iterator = std::vector<int>::iterator;
  enum Side : char { none, lower, upper };
  enum GroupState : char { not_known, divided, undivided };

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

  // Coordinate of a cut between nodes with different coordinates, with half of the nodes on each side if possible.
  double middle(Iterator begin, Iterator end, int axis) {
    coordinates_.clear();
    for (Iterator it = begin; it != end; ++it) coordinates_.push_back(graph_.positions[*it][axis]);
    const auto median = coordinates_.begin() + static_cast<std::ptrdiff_t>(coordinates_.size() / 2);
    std::nth_element(coordinates_.begin(), median, coordinates_.end());
    const double value = *median;
    const auto [lowest_place, highest] = std::minmax_element(coordinates_.begin(), coordinates_.end());
    const double lowest = *lowest_place;
    // The tolerance is relative to the extent of the nodes, because the order must not depend on the unit of length.
    const double tolerance = 1e-9 * (*highest - lowest);
    return value - tolerance > lowest ? value - tolerance : value + tolerance;
  }

  // Nodes of one side of a cut that are coupled to the other side.
  std::vector<int> boundary(Iterator begin, Iterator end, int axis, double cut, Side side) {
    const Side other = side == lower ? upper : lower;
    std::vector<int> found;
    for (Iterator it = begin; it != end; ++it) {
      if (side_[*it] != side) continue;
      const bool near = std::abs(graph_.positions[*it][axis] - cut) <= reach_[*it] * (1 + 1e-9);
      if ((near && has_partner(*it, other)) || shares_group_with_side(*it, other)) found.push_back(*it);
    }
    for (Iterator it = begin; it != end; ++it)
      for (const int g : groups_of_.of(*it)) group_state_[static_cast<std::size_t>(g)] = not_known;
    return found;
  }

  bool has_partner(int node, Side side) const {
    const std::span<const int> partners = graph_.partners.of(node);
    return std::any_of(partners.begin(), partners.end(), [&](int n) { return side_[n] == side; });
  }

  // Whether one of the groups of coupled nodes that contain a node has nodes on the given side of the cut. The answer
  // for each group is stored until boundary() ends.
  bool shares_group_with_side(int node, Side side) {
    const std::span<const int> groups = groups_of_.of(node);
    return std::any_of(groups.begin(), groups.end(), [&](int g) {
      GroupState& state = group_state_[static_cast<std::size_t>(g)];
      if (state == not_known) {
        const std::vector<int>& nodes = graph_.groups[static_cast<std::size_t>(g)];
        state = std::any_of(nodes.begin(), nodes.end(), [&](int n) { return side_[n] == side; }) ? divided : undivided;
      }
      return state == divided;
    });
  }

  const NodeGraph& graph_;
  std::vector<int> nodes_;
  std::vector<double> reach_, coordinates_;
  std::vector<Side> side_;
  Adjacency groups_of_;
  std::vector<GroupState> group_state_;
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
