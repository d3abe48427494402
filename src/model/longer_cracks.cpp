#include <algorithm>
#include <utility>

#include "crack/cannot_grow.hpp"
#include "model/driven_growth.hpp"
#include "model/model.hpp"

// Scenes with longer cracks, in which the run of the previous scene continues.
namespace bempd::model {

namespace {

// Nodes found by their exact places, in a hash table (open addressing), because bodies have very many nodes.
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

  // Node at a place. Each call for the same place returns the next node there in the order of the nodes; after the last
  // node, the last node again. -1 if there is no node.
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
  std::vector<Slot> slots_ = std::vector<Slot>(2);  // their number is a power of two
};

// Whether the lattices of two scenes have the same bonds in the same order, so that broken bonds can be taken over.
// They differ if a lattice with points on its outline has moved its points to avoid a longer crack.
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

// Map from each node of the new scene to the node of the previous scene whose displacement it takes: the region's node
// at the same place (several nodes at a place in their order), else the region's nearest node.
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

// Node of the new scene for each node of the previous scene, given the map `before` of nodes_before() from new to
// previous nodes. If several new nodes come from one previous node, the first of them; -1 if none does.
std::vector<int> nodes_now(const std::vector<int>& before, std::size_t count) {
  std::vector<int> now(count, -1);
  for (std::size_t node = before.size(); node-- > 0;)
    now[static_cast<std::size_t>(before[node])] = static_cast<int>(node);
  return now;
}

// Crack ends that have entered a lattice: in the previous scene these ends had boundary elements.
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

// Builds the prepared scene with longer cracks. Argument errors become CannotGrow, because the scene was valid without
// the longer cracks.
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

}  // namespace bempd::model
