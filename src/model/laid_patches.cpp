#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>

#include "crack/cannot_grow.hpp"
#include "model/model.hpp"
#include "regions/memory_limit.hpp"

// Scenes with other lattice patches (lattices inside a body, made of blocks), in which the run of the previous scene
// continues.
namespace bempd::model {

namespace {

using Keys = std::unordered_map<std::uint64_t, int>;

// Number of a place as a point of a lattice's grid; empty if no grid point is there.
std::optional<std::uint64_t> key_of(const Point& place, const regions::LatticeGrid& grid) {
  constexpr double slack = 1e-3;  // spacings
  const Point at = (place - grid.origin) / grid.spacing;
  const Point whole(std::round(at.x()), std::round(at.y()));
  if ((at - whole).lpNorm<Eigen::Infinity>() > slack) return std::nullopt;
  const auto number = [](double value) { return static_cast<std::uint32_t>(static_cast<std::int32_t>(value)); };
  return (static_cast<std::uint64_t>(number(whole.x())) << 32U) | number(whole.y());
}

// Node of some regions that is nearest to a place.
int nearest(std::span<const regions::Region* const> regions, const std::vector<Point>& positions, const Point& place) {
  int found = -1;
  double least = std::numeric_limits<double>::infinity();
  for (const regions::Region* region : regions)
    for (const int node : region->nodes()) {
      const double apart = (positions[static_cast<std::size_t>(node)] - place).squaredNorm();
      if (found < 0 || apart < least) least = apart, found = node;
    }
  return found;
}

// Match between the nodes of a scene and those of the previous scene: material points of patches by the grid's points,
// other nodes by equal places. A node without a counterpart takes the values of the nearest previous node.
class NodeMatch {
 public:
  NodeMatch(const scene::Scene& scene, const regions::Discretization& now, const regions::Discretization& before)
      : now_(now), before_(before) {
    former.node.assign(now.positions.size(), -1);
    former.node_now.assign(before.positions.size(), -1);
    for (const bool of_patches : {true, false})
      for (std::size_t r = 0; r < now.regions.size(); ++r) {
        const regions::Region& region = *now.regions[r];
        const int body = scene.region(region.id()).part_of();
        if ((body > 0) != of_patches) continue;
        of_patches ? match_points(region, patches_before(scene, body)) : match_nodes(region, *before.regions[r]);
      }
  }

  fracture::FormerBody former;

 private:
  const Point& place(int node) const { return now_.positions[static_cast<std::size_t>(node)]; }

  void match(int node, int other) {
    former.node[static_cast<std::size_t>(node)] = other;
    former.node_now[static_cast<std::size_t>(other)] = node;
  }

  // Lattice patches of a body in the previous scene. A patch of the present scene may consist of parts of several of
  // them.
  std::vector<const regions::Region*> patches_before(const scene::Scene& scene, int body) const {
    std::vector<const regions::Region*> found;
    for (const auto& region : before_.regions)
      if (scene.region(region->id()).part_of() == body) found.push_back(region.get());
    return found;
  }

  void match_points(const regions::Region& region, const std::vector<const regions::Region*>& old) {
    const regions::LatticeGrid grid = old.front()->lattice_grid().value();
    Keys at;
    for (const regions::Region* patch : old)
      for (const int node : patch->nodes())
        if (const auto key = key_of(before_.positions[static_cast<std::size_t>(node)], grid)) at[*key] = node;
    for (const int node : region.nodes()) {
      const auto key = key_of(place(node), grid);
      const auto same = key ? at.find(*key) : at.end();
      if (same != at.end()) {
        match(node, same->second);
      } else {
        former.node[static_cast<std::size_t>(node)] = nearest(old, before_.positions, place(node));
      }
    }
  }

  // Matches the nodes of a region by their places. Nodes with the same place, as on the two faces of a crack, keep
  // their order.
  void match_nodes(const regions::Region& region, const regions::Region& old) {
    std::map<std::pair<double, double>, std::vector<int>> at;
    const auto of = [](const Point& point) { return std::pair(point.x(), point.y()); };
    for (auto node = old.nodes().rbegin(); node != old.nodes().rend(); ++node)
      at[of(before_.positions[static_cast<std::size_t>(*node)])].push_back(*node);
    const regions::Region* const all[] = {&old};
    for (const int node : region.nodes()) {
      const auto same = at.find(of(place(node)));
      if (former.node[static_cast<std::size_t>(node)] >= 0) continue;
      if (same == at.end() || same->second.empty()) {
        former.node[static_cast<std::size_t>(node)] = nearest(all, before_.positions, place(node));
      } else {
        match(node, same->second.back());
        same->second.pop_back();
      }
    }
  }

  const regions::Discretization &now_, &before_;
};

// Nodes of an energy term (bond or cell square); of a bond, the first node, then the second.
std::vector<int> nodes_of(const coupling::Terms& terms, std::size_t term) {
  std::vector<int> nodes;
  terms.for_each_node(term, [&](int node) { nodes.push_back(node); });
  return nodes;
}

// Present numbers of those energy terms (bonds and cell squares) of the previous scene that are damaged or broken.
// Terms with the same nodes keep their order. Throws crack::CannotGrow if such a term does not exist in the present
// scene, unless its nodes are gone with a part of a lattice.
std::unordered_map<int, int> terms_now(const PreparedScene& now, const PreparedScene& before,
                                       const fracture::FormerBody& former) {
  const std::vector<std::uint8_t>& stages = before.evolution->progress().stages;
  const coupling::Terms &terms = now.system->terms(), &old = before.system->terms();
  std::vector<char> is_wanted(former.node.size(), 0);
  std::map<std::vector<int>, std::vector<int>> wanted;  // earlier terms by their present nodes, the last one first
  for (std::size_t t = stages.size(); t-- > 0;) {
    if (stages[t] == 0) continue;
    std::vector<int> nodes = nodes_of(old, t);
    for (int& node : nodes) {
      node = former.node_now[static_cast<std::size_t>(node)];
      if (node >= 0) is_wanted[static_cast<std::size_t>(node)] = 1;
    }
    if (former.has_fewer_terms && std::ranges::count(nodes, -1) > 0) continue;
    wanted[std::move(nodes)].push_back(static_cast<int>(t));
  }
  std::unordered_map<int, int> found;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    bool may_be = true;
    terms.for_each_node(t, [&](int node) { may_be &= is_wanted[static_cast<std::size_t>(node)] != 0; });
    if (!may_be) continue;
    const auto same = wanted.find(nodes_of(terms, t));
    if (same == wanted.end() || same->second.empty()) continue;
    found[same->second.back()] = static_cast<int>(t);
    same->second.pop_back();
  }
  for (const auto& [nodes, left] : wanted)
    if (!left.empty()) throw crack::CannotGrow("it would lose broken bonds");
  return found;
}

// Continues the run of the previous scene in the next scene. Throws crack::CannotGrow if broken bonds would be lost, or
// if boundary elements in place of a lattice would leave a part of the body free to move.
void continue_in(PreparedScene& next, const PreparedScene& before, const scene::Scene& scene, std::int64_t layout) {
  NodeMatch nodes(scene, next.discretization, before.discretization);
  nodes.former.has_fewer_terms = regions::gives_back(layout);
  nodes.former.terms = terms_now(next, before, nodes.former);
  next.fingerprint = before.fingerprint;
  next.anchored_pieces = before.anchored_pieces;
  fracture::BodyGrowth& growth = next.evolution->growth();
  growth.go_on_from(before.evolution->growth(), nodes.former, {});
  growth.book_layout(layout);
  const fracture::EvolutionState &now = next.evolution->progress(), &then = before.evolution->progress();
  if (nodes.former.has_fewer_terms && (now.fragments != then.fragments || now.springs.size() != then.springs.size()))
    throw crack::CannotGrow("elements in place of a lattice would set a part free");
}

}  // namespace

std::unique_ptr<PreparedScene> CrackGrowth::with_patches(std::vector<regions::Patch> patches,
                                                         std::optional<std::vector<scene::Crack>> cracks,
                                                         const scene::SceneValues* on_way, std::int64_t layout) {
  const PreparedScene& before = model_.prepared();
  Preparation& preparation = model_.preparation();
  CrackTreatments::Copy patches_before = model_.treatments().copy();
  std::vector<scene::Crack> cracks_before = model_.scene().cracks();
  const auto build = [&] {
    regions::require_memory(model_.scene(), model_.options());
    return preparation.build(&before, Preparation::Operators::anew);
  };
  try {
    if (cracks) preparation.scene().set_cracks(std::move(*cracks));
    model_.treatments().replace_patches(std::move(patches));
    std::unique_ptr<PreparedScene> next;
    if (on_way) {
      scene::SceneValues values = *on_way;
      next = preparation.scene().under(values, build);
    } else {
      next = build();
    }
    continue_in(*next, before, model_.scene(), layout);
    return next;
  } catch (...) {
    preparation.scene().set_cracks(std::move(cracks_before));
    model_.treatments().go_back_to(std::move(patches_before));
    throw;
  }
}

}  // namespace bempd::model
