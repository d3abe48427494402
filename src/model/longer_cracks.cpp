#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

#include "crack/cannot_grow.hpp"
#include "model/driven_growth.hpp"
#include "model/model.hpp"

// Scenes with longer cracks or larger lattice patches, in which the run of the previous scene continues.
namespace bempd::model {

namespace {

// Nodes by their exact places: a table with free slots behind each, as there are very many.
class NodesAt {
 public:
  NodesAt(const std::vector<int>& nodes, const std::vector<Point>& positions) : positions_(positions) {
    while (slots_.size() < 2 * nodes.size() + 2) slots_.resize(2 * slots_.size());
    for (const int node : nodes) {
      std::size_t slot = first_slot(positions[static_cast<std::size_t>(node)]);
      while (slots_[slot].node >= 0) slot = behind(slot);
      slots_[slot].node = node;
    }
  }

  // Next node at a place, in their order, and the last one ever after; -1 if there is none.
  int take(const Point& place) {
    int last = -1;
    for (std::size_t slot = first_slot(place); slots_[slot].node >= 0; slot = behind(slot)) {
      if (positions_[static_cast<std::size_t>(slots_[slot].node)] != place) continue;
      last = slots_[slot].node;
      if (!std::exchange(slots_[slot].is_taken, true)) break;
    }
    return last;
  }

 private:
  struct Slot {
    int node = -1;
    bool is_taken = false;
  };
  std::size_t first_slot(const Point& p) const {
    const std::size_t mixed = std::hash<double>()(p.x()) ^ (std::hash<double>()(p.y()) * 0x9e3779b97f4a7c15U);
    return (mixed ^ (mixed >> 32U)) & (slots_.size() - 1);
  }
  std::size_t behind(std::size_t slot) const { return (slot + 1) & (slots_.size() - 1); }

  const std::vector<Point>& positions_;
  std::vector<Slot> slots_ = std::vector<Slot>(2);  // a power of two
};

// Whether the lattices of two scenes have the same bonds in the same order, so that broken bonds can be taken over. A
// lattice with points on its outline may have moved to avoid a longer crack.
bool has_same_bonds(const PreparedScene& now, const PreparedScene& before) {
  const coupling::Terms &a = now.system->terms(), &b = before.system->terms();
  if (a.size() != b.size()) return false;
  const auto at = [](const PreparedScene& scene, int node) {
    return scene.discretization.positions[static_cast<std::size_t>(node)];
  };
  const double tolerance = 10 * before.discretization.tolerance;
  for (std::size_t t = 0; t < a.size(); ++t)
    if ((at(now, a.first[t]) - at(before, b.first[t])).norm() > tolerance ||
        (at(now, a.second[t]) - at(before, b.second[t])).norm() > tolerance)
      return false;
  return true;
}

// Map from each node of the new scene to the node of the previous one whose displacement it takes: the region's node at
// the same place (if there are several, in their order), else the region's nearest node.
std::vector<int> nodes_before(const regions::Discretization& now, const regions::Discretization& before) {
  std::vector<int> found(now.positions.size(), -1);
  for (std::size_t r = 0; r < now.regions.size(); ++r) {
    const std::vector<int>&own = now.regions[r]->nodes(), &old = before.regions[r]->nodes();
    NodesAt at(old, before.positions);
    for (const int node : own) {
      int& known = found[static_cast<std::size_t>(node)];
      const Point& place = now.positions[static_cast<std::size_t>(node)];
      if (known >= 0) continue;
      known = at.take(place);
      if (known >= 0) continue;
      const auto off = [&](int one) { return (before.positions[static_cast<std::size_t>(one)] - place).squaredNorm(); };
      known = *std::min_element(old.begin(), old.end(), [&](int a, int b) { return off(a) < off(b); });
    }
  }
  return found;
}

// Nodes of the new scene by those of the previous one whose displacements they take, the first ones; -1: there is none.
std::vector<int> nodes_now(const std::vector<int>& before, std::size_t count) {
  std::vector<int> now(count, -1);
  for (std::size_t node = before.size(); node-- > 0;)
    now[static_cast<std::size_t>(before[node])] = static_cast<int>(node);
  return now;
}

// Ends of cracks that have entered a lattice: they had elements in the previous scene.
std::vector<crack::TipId> entering(const regions::Discretization& next, const regions::Discretization& previous) {
  std::vector<crack::TipId> tips;
  const std::vector<regions::PartedCrack>& before = previous.cracks;
  for (std::size_t c = 0; c < before.size(); ++c)
    for (const int end : {0, 1})
      if (!next.cracks[c].parts.empty() && !before[c].parts.empty() && next.cracks[c].region_at(end) == 0 &&
          before[c].region_at(end) > 0)
        tips.push_back({static_cast<int>(c) + 1, end});
  return tips;
}

// Builds the prepared scene with longer cracks. An argument error becomes CannotGrow: the scene was valid before, so
// the longer cracks are the reason.
std::unique_ptr<PreparedScene> built_with(Preparation& preparation, std::vector<scene::Crack> longer,
                                          const scene::SceneValues* on_way) {
  preparation.scene().set_cracks(std::move(longer));
  const auto build_next = [&] { return preparation.build(preparation.prepared()); };
  try {
    if (!on_way) return build_next();
    scene::SceneValues values = *on_way;
    return preparation.scene().under(values, build_next);
  } catch (const Error& error) {
    if (error.failure() != Failure::argument) throw;
    throw crack::CannotGrow(error.what());
  }
}

}  // namespace

std::unique_ptr<PreparedScene> CrackGrowth::with_cracks(std::vector<scene::Crack> longer,
                                                        const scene::SceneValues* on_way) {
  std::unique_ptr<PreparedScene> next = built_with(model_.preparation(), std::move(longer), on_way);
  const PreparedScene& before = model_.prepared();
  if (!has_same_bonds(*next, before))
    throw crack::CannotGrow(
        "a crack that grows on would move the material points of a peridynamic region, whose broken bonds are those "
        "of the present points; it stops. Give that region edges along the axes and no angle of its lattice, or make "
        "it "
        "so large that the crack stays inside");
  next->fingerprint = before.fingerprint;
  next->anchored_pieces = before.anchored_pieces;
  fracture::FormerBody former;
  former.node = nodes_before(next->discretization, before.discretization);
  former.node_now = nodes_now(former.node, before.discretization.positions.size());
  next->evolution->growth().go_on_from(before.evolution->growth(), former,
                                       entering(next->discretization, before.discretization));
  return next;
}

namespace {

using Keys = std::unordered_map<std::uint64_t, int>;

// Number of a place on a lattice's grid; empty off its points.
std::optional<std::uint64_t> key_of(const Point& place, const regions::LatticeGrid& grid) {
  constexpr double slack = 1e-3;  // spacings
  const Point at = (place - grid.origin) / grid.spacing;
  const Point whole(std::round(at.x()), std::round(at.y()));
  if ((at - whole).lpNorm<Eigen::Infinity>() > slack) return std::nullopt;
  const auto number = [](double value) { return static_cast<std::uint32_t>(static_cast<std::int32_t>(value)); };
  return (static_cast<std::uint64_t>(number(whole.x())) << 32U) | number(whole.y());
}

// Node of a region that is nearest to a place.
int nearest(const regions::Region& region, const std::vector<Point>& positions, const Point& place) {
  const auto off = [&](int node) { return (positions[static_cast<std::size_t>(node)] - place).squaredNorm(); };
  const std::vector<int>& nodes = region.nodes();
  return *std::min_element(nodes.begin(), nodes.end(), [&](int a, int b) { return off(a) < off(b); });
}

// Relates the nodes of a scene to those of the one before. Material points of patches keep their places on the grid.
class NodeMatch {
 public:
  NodeMatch(const scene::Scene& scene, const regions::Discretization& now, const regions::Discretization& before)
      : now_(now), before_(before) {
    former.node.assign(now.positions.size(), -1);
    former.node_now.assign(before.positions.size(), -1);
    for (const bool of_patches : {true, false})
      for (std::size_t r = 0; r < now.regions.size(); ++r) {
        const regions::Region &region = *now.regions[r], &old = *before.regions[r];
        const bool is_patch = scene.region(region.id()).part_of() > 0;
        if (is_patch == of_patches) is_patch ? match_points(region, old) : match_nodes(region, old);
      }
  }

  fracture::FormerBody former;

 private:
  const Point& place(int node) const { return now_.positions[static_cast<std::size_t>(node)]; }

  void match(int node, int other) {
    former.node[static_cast<std::size_t>(node)] = other;
    former.node_now[static_cast<std::size_t>(other)] = node;
  }

  void match_points(const regions::Region& region, const regions::Region& old) {
    const regions::LatticeGrid grid = old.lattice_grid().value();
    Keys at;
    for (const int node : old.nodes())
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

  // Nodes with the same place keep their order, as those of the two faces of a crack.
  void match_nodes(const regions::Region& region, const regions::Region& old) {
    std::map<std::pair<double, double>, std::vector<int>> at;
    const auto of = [](const Point& point) { return std::pair(point.x(), point.y()); };
    for (auto node = old.nodes().rbegin(); node != old.nodes().rend(); ++node)
      at[of(before_.positions[static_cast<std::size_t>(*node)])].push_back(*node);
    for (const int node : region.nodes()) {
      const auto same = at.find(of(place(node)));
      if (former.node[static_cast<std::size_t>(node)] >= 0) continue;
      if (same == at.end() || same->second.empty()) {
        former.node[static_cast<std::size_t>(node)] = nearest(old, before_.positions, place(node));
      } else {
        match(node, same->second.back());
        same->second.pop_back();
      }
    }
  }

  const regions::Discretization &now_, &before_;
};

// Nodes of a term, those of a bond in its order.
std::vector<int> nodes_of(const coupling::Terms& terms, std::size_t term) {
  std::vector<int> nodes;
  terms.for_each_node(term, [&](int node) { nodes.push_back(node); });
  return nodes;
}

// Numbers that terms of the scene before have now, for all that are not virgin. Terms of the same nodes keep their
// order. Throws crack::CannotGrow if one is not there any more.
std::unordered_map<int, int> terms_now(const PreparedScene& now, const PreparedScene& before,
                                       const fracture::FormerBody& former) {
  const std::vector<std::uint8_t>& stages = before.evolution->progress().stages;
  const coupling::Terms &terms = now.system->terms(), &old = before.system->terms();
  std::vector<char> is_wanted(former.node.size(), 0);
  std::map<std::vector<int>, std::vector<int>> wanted;  // by nodes now: terms before, the last one first
  for (std::size_t t = stages.size(); t-- > 0;) {
    if (stages[t] == 0) continue;
    std::vector<int> nodes = nodes_of(old, t);
    for (int& node : nodes) {
      node = former.node_now[static_cast<std::size_t>(node)];
      if (node >= 0) is_wanted[static_cast<std::size_t>(node)] = 1;
    }
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

}  // namespace

std::unique_ptr<PreparedScene> CrackGrowth::with_patches(const scene::SceneValues* on_way, std::int64_t layout) {
  const PreparedScene& before = model_.prepared();
  Preparation& preparation = model_.preparation();
  const auto build = [&] { return preparation.build(&before, Preparation::Operators::anew); };
  std::unique_ptr<PreparedScene> next;
  if (on_way) {
    scene::SceneValues values = *on_way;
    next = preparation.scene().under(values, build);
  } else {
    next = build();
  }
  NodeMatch nodes(model_.scene(), next->discretization, before.discretization);
  nodes.former.terms = terms_now(*next, before, nodes.former);
  next->fingerprint = before.fingerprint;
  next->anchored_pieces = before.anchored_pieces;
  next->evolution->growth().go_on_from(before.evolution->growth(), nodes.former, {});
  next->evolution->growth().book_layout(layout);
  return next;
}

}  // namespace bempd::model
