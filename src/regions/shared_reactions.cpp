#include "regions/shared_reactions.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "regions/places/edge_part.hpp"

namespace bempd::regions {

namespace {

using coupling::SharedForce;

// Nodes of a supported part of an edge, in order from one end of the part: end, middle and end of each element. Each
// node has its distance from that end, as a fraction of the part, and the integral of its shape function over the part.
struct Side {
  std::size_t support;
  std::vector<int> nodes;
  std::vector<double> distances, weights;
};

class SupportedParts {
 public:
  SupportedParts(const scene::Scene& scene, const Discretization& d)
      : scene_(scene), d_(d), known_(scene.supports().size()) {}

  // Nodes of a support on a part of an edge, from the start of the part on.
  const Side& of(std::size_t support) {
    if (known_[support]) return *known_[support];
    const auto& part = dynamic_cast<const EdgePart&>(*scene_.supports()[support].place);
    const std::map<int, double> weights = part.weights(scene_, d_);
    Side side{support, {}, {}, {}};
    for (const PlacedNode& n : part.nodes(scene_, d_)) {
      side.nodes.push_back(n.node);
      side.distances.push_back(n.fraction);
      side.weights.push_back(weights.at(n.node));
    }
    return known_[support].emplace(std::move(side));
  }

 private:
  const scene::Scene& scene_;
  const Discretization& d_;
  std::vector<std::optional<Side>> known_;
};

Side reversed(Side side) {
  const double end = side.distances.back();
  std::reverse(side.nodes.begin(), side.nodes.end());
  std::reverse(side.distances.begin(), side.distances.end());
  std::reverse(side.weights.begin(), side.weights.end());
  for (double& distance : side.distances) distance = end - distance;
  return side;
}

// Force that the tractions on a side (supported part of an edge) make at the side's first node, as a linear combination
// of the forces on the middle nodes of its first two elements. The traction at a middle node is the force on the node
// over the node's weight; the traction at the first node is extrapolated linearly from both. It times the first node's
// weight is the force there, because the first moment of an end's quadratic shape function about that end is zero.
std::vector<SharedForce> force_of_tractions(const Side& side, int component) {
  const std::vector<double>&x = side.distances, &w = side.weights;
  const int node = side.nodes.front();
  const double first = w[0] / w[1];
  if (side.nodes.size() < 5) return {{2 * side.nodes[1] + component, node, first}};
  const double slope = x[1] / (x[3] - x[1]);
  return {{2 * side.nodes[1] + component, node, first * (1 + slope)},
          {2 * side.nodes[3] + component, node, -w[0] / w[3] * slope}};
}

// Sides (supported parts of edges) that meet at a node, for the supports that hold one of its degrees of freedom; empty
// if the first support gets the whole reaction.
std::vector<Side> sides_at(int node, const std::vector<std::size_t>& supports, const scene::Scene& scene,
                           const Discretization& d, SupportedParts& parts) {
  const auto is_point = [&](std::size_t s) { return scene.supports()[s].place->point().has_value(); };
  const bool is_one_edge = std::count_if(supports.begin(), supports.end(), is_point) + 1 == std::ssize(supports);
  std::vector<Side> sides;
  for (const std::size_t s : supports) {
    if (is_point(s)) continue;
    const auto edge = scene.supports()[s].place->edge();
    if (!edge || d.region(edge->first).bonds()) return {};
    Side side = parts.of(s);
    const bool is_inside = side.nodes.front() != node && side.nodes.back() != node;
    if (is_inside && !is_one_edge) return {};
    if (side.nodes.back() == node) side = reversed(std::move(side));
    const auto is_same = [&](const Side& other) { return other.nodes[1] == side.nodes[1]; };
    if (std::none_of(sides.begin(), sides.end(), is_same)) sides.push_back(std::move(side));
  }
  return sides;
}

// Divides the reaction of a degree of freedom, which so far counts for the support `first` alone, among the sides.
void divide(int dof, std::size_t first, const std::vector<Side>& sides, std::vector<std::vector<SharedForce>>& shared) {
  const int node = dof / 2;
  shared[first].push_back({dof, node, -1});
  double all = 0;
  for (const Side& side : sides) all += side.weights.front();
  std::vector<SharedForce> rest{{dof, node, 1}};  // the node's force less those of the tractions
  for (const Side& side : sides) {
    for (const SharedForce& one : sides.size() > 1 ? force_of_tractions(side, dof % 2) : std::vector<SharedForce>()) {
      shared[side.support].push_back(one);
      rest.push_back({one.dof, node, -one.weight});
    }
  }
  for (const Side& side : sides)
    for (const SharedForce& one : rest)
      shared[side.support].push_back({one.dof, node, one.weight * side.weights.front() / all});
}

// Supports of each degree of freedom that several supports hold. Most scenes have no such degree of freedom.
std::map<int, std::vector<std::size_t>> shared_dofs(const DofConditions& conditions) {
  std::map<int, std::vector<std::size_t>> holders;
  for (std::size_t s = 0; s < conditions.held_dofs.size(); ++s) {
    const std::vector<int>& counted = conditions.reaction_dofs[s];  // the others count for an earlier support
    auto next = counted.begin();
    for (const int dof : conditions.held_dofs[s]) {
      if (next != counted.end() && *next == dof) {
        ++next;
      } else {
        holders.try_emplace(dof);
      }
    }
  }
  if (holders.empty()) return holders;
  for (std::size_t s = 0; s < conditions.held_dofs.size(); ++s)
    for (const int dof : conditions.held_dofs[s])
      if (const auto found = holders.find(dof); found != holders.end()) found->second.push_back(s);
  return holders;
}

}  // namespace

coupling::SupportDofs dofs_of_supports(const scene::Scene& scene, const Discretization& d,
                                       const DofConditions& conditions) {
  coupling::SupportDofs dofs{conditions.reaction_dofs, {}};
  dofs.shared.resize(dofs.own.size());
  SupportedParts parts(scene, d);
  for (const auto& [dof, supports] : shared_dofs(conditions)) {
    const std::vector<Side> sides = sides_at(dof / 2, supports, scene, d, parts);
    if (!sides.empty() && (sides.size() > 1 || sides.front().support != supports.front()))
      divide(dof, supports.front(), sides, dofs.shared);
  }
  return dofs;
}

}  // namespace bempd::regions
