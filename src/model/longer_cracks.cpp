#include <algorithm>
#include <unordered_map>

#include "crack/cannot_grow.hpp"
#include "model/driven_growth.hpp"
#include "model/model.hpp"

// Scenes with longer cracks, in which the run of the previous scene continues.
namespace bempd::model {

namespace {

struct HashOfPoint {
  std::size_t operator()(const Point& p) const {
    return std::hash<double>()(p.x()) ^ (std::hash<double>()(p.y()) * 0x9e3779b97f4a7c15U);
  }
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
    std::unordered_map<Point, std::vector<int>, HashOfPoint> at;
    for (auto node = old.rbegin(); node != old.rend(); ++node)
      at[before.positions[static_cast<std::size_t>(*node)]].push_back(*node);
    for (const int node : own) {
      int& known = found[static_cast<std::size_t>(node)];
      const Point& place = now.positions[static_cast<std::size_t>(node)];
      const auto same = at.find(place);
      if (known >= 0) continue;
      if (same != at.end()) {
        known = same->second.back();
        if (same->second.size() > 1) same->second.pop_back();
        continue;
      }
      const auto off = [&](int one) { return (before.positions[static_cast<std::size_t>(one)] - place).squaredNorm(); };
      known = *std::min_element(old.begin(), old.end(), [&](int a, int b) { return off(a) < off(b); });
    }
  }
  return found;
}

}  // namespace

// Ends of cracks that have entered a lattice: they had elements in the previous scene.
std::vector<crack::TipId> Model::entering(const regions::Discretization& next) const {
  std::vector<crack::TipId> tips;
  const std::vector<regions::PartedCrack>& before = prepared_->discretization.cracks;
  for (std::size_t c = 0; c < before.size(); ++c)
    for (const int end : {0, 1})
      if (!next.cracks[c].parts.empty() && !before[c].parts.empty() && next.cracks[c].region_at(end) == 0 &&
          before[c].region_at(end) > 0)
        tips.push_back({static_cast<int>(c) + 1, end});
  return tips;
}

// Builds the prepared scene with longer cracks. An argument error becomes CannotGrow: the scene was valid before, so
// the longer cracks are the reason.
std::unique_ptr<PreparedScene> Model::built_with(std::vector<scene::Crack> longer, const scene::SceneValues* on_way) {
  scene_.set_cracks(std::move(longer));
  const auto build_next = [&] { return build(prepared_.get()); };
  try {
    if (!on_way) return build_next();
    scene::SceneValues values = *on_way;
    return scene_.under(values, build_next);
  } catch (const Error& error) {
    if (error.failure() != Failure::argument) throw;
    throw crack::CannotGrow(error.what());
  }
}

// Builds the prepared scene with longer cracks and continues the present run in it. Throws CannotGrow if the longer
// cracks are impossible.
std::unique_ptr<PreparedScene> Model::with_cracks(std::vector<scene::Crack> longer, const scene::SceneValues* on_way) {
  std::unique_ptr<PreparedScene> next = built_with(std::move(longer), on_way);
  if (!has_same_bonds(*next, *prepared_))
    throw crack::CannotGrow(
        "a crack that grows on would move the material points of a peridynamic region, whose broken bonds are those "
        "of the present points; it stops. Give that region edges along the axes and no angle of its lattice, or make "
        "it "
        "so large that the crack stays inside");
  next->fingerprint = prepared_->fingerprint;
  next->anchored_pieces = prepared_->anchored_pieces;
  next->evolution->go_on_after_growth(*prepared_->evolution,
                                      nodes_before(next->discretization, prepared_->discretization),
                                      entering(next->discretization));
  return next;
}

}  // namespace bempd::model
